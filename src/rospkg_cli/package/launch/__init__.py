"""Launch files: one view over the Python, XML and YAML frontends, every part of it with its span."""
