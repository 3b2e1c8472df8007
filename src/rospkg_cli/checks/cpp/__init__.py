"""Checks of C++ against the package that it is part of."""
