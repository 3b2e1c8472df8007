"""Rules of several packages together (WSP)."""
