"""`rospkg lint`: its options, the session that they ask for, fixes, reports and the exit status."""
