"""`rospkg index`: its options, the index of package names and its age."""
