"""Rules of robot descriptions (URD)."""
