"""`rospkg format`: its options, and what it does."""
