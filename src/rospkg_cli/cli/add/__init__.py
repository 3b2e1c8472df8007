"""`rospkg add` and `rospkg remove`: their options, and what they do."""
