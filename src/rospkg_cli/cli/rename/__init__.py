"""`rospkg rename`: another name for a package, with every reference to it."""
