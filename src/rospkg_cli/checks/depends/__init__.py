"""Checks of dependencies: used and undeclared, unknown, unused, of the wrong kind."""
