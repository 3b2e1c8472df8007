"""Hostile inputs, made from real packages and run through the commands; `python -m bench.attack --help` says how."""
