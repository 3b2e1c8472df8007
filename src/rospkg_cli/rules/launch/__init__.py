"""Rules of launch files (LCH)."""
