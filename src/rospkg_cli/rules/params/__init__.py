"""Rules of parameter files (PRM)."""
