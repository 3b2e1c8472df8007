"""Ways from the start of a program to a line of Python code, as far as they are shown: fewer than there may be."""
