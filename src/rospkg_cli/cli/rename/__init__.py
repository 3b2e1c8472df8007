"""`rospkg rename`: another name for a package or a node, with every reference to it."""
