"""`rospkg inspect`: its options, and what it does."""
