"""The command line. Each verb is a folder: `options` is what typer sees, `run` is what it does."""

from ..user_error import UserError


class UsageError(UserError):
    """Wrong use; the message is one sentence that says what to do."""
