"""Rules of rospkg itself: what can't be read, and suppressions (RPK)."""
