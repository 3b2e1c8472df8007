"""Absolute paths in a home folder (`/home/ada/…`): where files name them, and whether they matter on other machines."""
