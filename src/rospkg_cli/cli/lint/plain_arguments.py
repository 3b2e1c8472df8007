"""Arguments of `rospkg lint` that are clear without typer, whose import is a fifth of linting a small package.

These are paths, and long options in full with a value that is there. The rest is typer's: short options, help, errors.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from .lint_options import PARTS, LintOptions


def fields() -> Iterator[tuple[str, str, Any]]:
    """Yield the name, the type as it is written, and the default of each option, and of `paths`."""
    defaults = LintOptions()
    for kind, values in ((LintOptions, defaults), *((PARTS[name], getattr(defaults, name)) for name in PARTS)):
        for name, written in kind.__annotations__.items():
            if name not in PARTS:
                yield name, written, getattr(values, name)


def plain_arguments(arguments: Sequence[str]) -> dict[str, Any] | None:
    """Return the values by the names of the fields of LintOptions; None where typer has to look at the arguments."""
    typed, kinds = {}, {}
    for name, kind, default in fields():
        typed[name], kinds[f"--{name.replace('_', '-')}"] = default, (name, kind)
    del kinds["--paths"]
    rest = iter(arguments)
    for each in rest:
        if each[:1] not in ("", "-"):
            typed["paths"] += (Path(each),)
            continue
        option, equals, value = each.partition("=")
        name, kind = kinds.get(option, ("", ""))
        if kind == "bool" and not equals:
            typed[name] = True
            continue
        value = value if equals else next(rest, "")
        if kind in ("", "bool") or value[:1] in ("", "-"):
            return None
        if kind.startswith("tuple"):
            typed[name] += (value,)
        else:
            typed[name] = Path(value) if kind.startswith("Path") else value
    return typed
