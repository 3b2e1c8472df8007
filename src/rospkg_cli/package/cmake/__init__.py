"""A package's CMake after it was run: targets, install rules, dependencies, and what they install."""
