"""`rospkg new`: its options, questions, families of packages, and what is printed."""
