"""As much of geometry_msgs as generated nodes use."""
