"""Checks of package.xml."""
