"""`rospkg doctor`: what decides about a run, on one screen."""
