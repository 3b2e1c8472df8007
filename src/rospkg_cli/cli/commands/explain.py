"""The options of `rospkg explain` and `rospkg rules`."""

from __future__ import annotations

import sys
from typing import Annotated

from typer import Argument, Option, echo

from . import one_of

EXPLAIN_EPILOG = "Examples:  rospkg explain SET101  ·  rospkg explain empty-glob"
RULES_EPILOG = "Example:  rospkg rules --format json"


def explain(rule: Annotated[str, Argument(help="A code or a name.")]) -> None:
    """What a rule finds, why, a bad and a good example, and its fix."""
    from ..explain import explain as text

    if sys.stdout.isatty():
        from rich.console import Console
        from rich.markdown import Markdown

        Console().print(Markdown(text(rule)))
    else:
        echo(text(rule), nl=False)


def rules(format: Annotated[str, Option("--format", metavar="FORMAT", help="text or json.")] = "text") -> None:
    """List all rules."""
    from ...docs import rules_json, rules_text

    one_of("--format", format, ("text", "json"))
    echo(rules_json() if format == "json" else rules_text(), nl=False)
