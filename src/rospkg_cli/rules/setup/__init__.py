"""Rules of setup.py and setup.cfg, and of what they install (SET)."""
