"""The Python sources of a package: what each imports, and for what it is run."""
