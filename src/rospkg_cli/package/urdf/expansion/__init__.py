"""What xacro makes of a robot, as far as it depends on nothing outside of its files."""
