"""The command line. Each verb is a folder: `options` is what typer sees, `run` is what it does."""


class UsageError(Exception):
    """Wrong use; the message is one sentence that says what to do."""
