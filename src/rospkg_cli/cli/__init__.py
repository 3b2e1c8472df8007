"""The command line. Each verb is a file with one public function; `app` alone knows typer."""


class UsageError(Exception):
    """Wrong use; the message is one sentence that says what to do."""
