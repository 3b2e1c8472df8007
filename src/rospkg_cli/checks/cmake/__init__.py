"""Checks of CMakeLists.txt."""
