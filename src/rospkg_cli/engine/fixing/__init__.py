"""Fixes: which fit together, until nothing changes, and how they are written."""
