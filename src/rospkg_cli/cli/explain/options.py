"""The options of `rospkg explain` and `rospkg rules`."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated

from typer import Argument, Option

from ..arguments import one_of

EXPLAIN_EPILOG = "Examples:  rospkg explain SET101  ·  rospkg explain empty-glob"
RULES_EPILOG = "Example:  rospkg rules --format json"


def explain(rule: Annotated[str, Argument(help="A code or a name.")]) -> None:
    """Show what a rule finds, why, a bad and a good example, and its fix."""
    from ...control_characters import visible_lines
    from .run import explain as text

    load_plugins()
    shown = visible_lines(text(rule))
    if sys.stdout.isatty():
        from rich.console import Console
        from rich.markdown import Markdown

        Console().print(Markdown(shown))
    else:
        sys.stdout.write(shown)


def load_plugins() -> None:
    """Make the rules known that the root's config plugs in, as in a run from the current folder."""
    from ...engine.discovery.choose_configs import choose_configs
    from ...engine.run.rule_plugins import load_plugins

    load_plugins(choose_configs([Path()]).root.plugins)


def rules(format: Annotated[str, Option("--format", metavar="FORMAT", help="text or json.")] = "text") -> None:
    """List all rules."""
    from ...control_characters import visible_lines
    from ...rule_docs import rules_json, rules_text

    one_of("--format", format, ("text", "json"))
    load_plugins()
    sys.stdout.write(rules_json() if format == "json" else visible_lines(rules_text()))
