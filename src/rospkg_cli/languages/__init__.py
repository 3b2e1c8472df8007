"""Text in, tree or value out: what a file says in its own language, with the place of each value. No word of ROS."""
