"""rospkg: write ROS 2 packages that are right, and find what is wrong in those that exist."""

__version__ = "0.1.0"
