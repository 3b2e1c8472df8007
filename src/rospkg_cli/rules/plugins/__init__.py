"""Rules of plugins of pluginlib (PLG)."""
