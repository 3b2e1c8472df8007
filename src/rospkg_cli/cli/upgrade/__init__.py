"""`rospkg upgrade`: what a new distribution removed or changed, fixed in one go."""
