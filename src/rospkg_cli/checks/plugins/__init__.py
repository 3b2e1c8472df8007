"""Checks of plugins."""
