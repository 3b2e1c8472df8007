"""`rospkg graph`: its options, and what it does."""
