"""Example ROS2 package for Physical AI textbook."""
