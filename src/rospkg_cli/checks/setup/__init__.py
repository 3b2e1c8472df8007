"""Checks of setup.py and setup.cfg."""
