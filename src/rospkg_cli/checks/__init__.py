"""Checks over packages, in folders like those of `rules/`: what is wrong, before a rule reports it."""
