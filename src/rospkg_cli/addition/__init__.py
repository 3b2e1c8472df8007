"""Adding to packages that exist, and taking away again what was added."""
