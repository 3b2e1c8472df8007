"""Rules of dependencies: undeclared, unknown, unused, of the wrong kind (DEP)."""
