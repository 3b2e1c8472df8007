"""`rospkg cache`: where lint keeps what it found, how large that is, and how to remove it."""
