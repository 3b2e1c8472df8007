"""setup.py and setup.cfg: what setuptools is told, and what colcon installs for it."""
