"""Python code of a package: its modules, names, classes and calls, and the conditions that parts of it run under."""
