"""Checks of robot descriptions."""
