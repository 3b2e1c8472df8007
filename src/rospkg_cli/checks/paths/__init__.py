"""Paths in code, launch files and YAML: how they are written, and what becomes of what is opened or written there."""
