"""Runs over one workspace again and again in one process, where little changes between them."""
