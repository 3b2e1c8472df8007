"""setup.py and setup.cfg: the arguments of setuptools, and what colcon installs for them."""
