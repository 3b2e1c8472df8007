"""The options of `rospkg explain` and `rospkg rules`."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated

from typer import Argument, Option

from ..arguments import one_of, split
from ..complete import choices, rule_words

EXPLAIN_EPILOG = "Examples:  rospkg explain SET101  ·  rospkg explain empty-glob  ·  rospkg explain --all --format json"
RULES_EPILOG = "Examples:  rospkg rules  ·  rospkg rules SET  ·  rospkg rules --format json"


def explain(
    rule: Annotated[str, Argument(help="A code or a name.", autocompletion=rule_words, show_default=False)] = "",
    every: Annotated[bool, Option("--all", help="Every rule, one after the other.")] = False,
    format: Annotated[
        str, Option("--format", metavar="FORMAT", help="text or json.", autocompletion=choices("text", "json"))
    ] = "text",
) -> None:
    """Show what a rule finds, why, a bad and a good example, and its fix."""
    from ...control_characters import visible_lines
    from .run import explained, explained_json

    one_of("--format", format, ("text", "json"))
    load_plugins()
    if format == "json":
        sys.stdout.write(explained_json(rule, every))
        return
    shown = visible_lines(explained(rule, every))
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


def rules(
    names: Annotated[
        list[str] | None,
        Argument(help="Codes, names, or how codes begin: SET, DEP1.", autocompletion=rule_words, show_default=False),
    ] = None,
    format: Annotated[
        str, Option("--format", metavar="FORMAT", help="text or json.", autocompletion=choices("text", "json"))
    ] = "text",
) -> None:
    """List the rules: all, or those of some codes."""
    from ...control_characters import visible_lines
    from ...rule_docs import rules_json, rules_text
    from .run import named_rules

    one_of("--format", format, ("text", "json"))
    load_plugins()
    chosen = named_rules(split(names))
    sys.stdout.write(rules_json(chosen) if format == "json" else visible_lines(rules_text(chosen)))
