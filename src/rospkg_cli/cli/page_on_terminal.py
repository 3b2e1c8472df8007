"""Pages of HTML, which are not for terminals."""

from __future__ import annotations

import sys

from . import UsageError


def refuse_page_on_terminal(format: str, command: str) -> None:
    """Raise UsageError where a page would be printed on a terminal; a file or a pipe gets it."""
    if format == "html" and sys.stdout.isatty():
        raise UsageError(
            f"a page of HTML is for a browser, not for a terminal; `rospkg {command} --format html > {command}.html` "
            "writes it to a file"
        )
