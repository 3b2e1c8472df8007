"""The Python sources of a package: their imports and roles."""
