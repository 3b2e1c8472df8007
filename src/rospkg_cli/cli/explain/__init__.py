"""`rospkg explain` and `rospkg rules`: their options, and the docs of a rule."""
