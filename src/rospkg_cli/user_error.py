"""The errors that are for the user's eyes, so that the command line knows them without importing who raises them."""

from __future__ import annotations


class UserError(Exception):
    """Its message is one sentence that says what is wrong and what to do; the command leaves with status 2."""
