"""Checks of several packages together."""
