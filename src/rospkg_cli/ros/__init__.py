"""What is known of ROS: distributions, names, build types, imports; its data is in `tables/`."""
