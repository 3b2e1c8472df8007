"""`rospkg lint` with the values of its options as they were typed; typer is not needed for it."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

from ...disk_trace import is_file, is_folder
from ...report import FORMATS
from .. import UsageError
from ..arguments import one_of, split
from ..page_on_terminal import refuse_page_on_terminal
from .lint_options import LintOptions

LEVELS = ("error", "warning", "info")
SHOWN = ("info", "all")
WITH_COMMAS = ("select", "ignore", "extend_select", "target", "show")


def lint_as_typed(typed: dict[str, Any]) -> int:
    """Lint with values by the names of the options; return the exit status. Raises UsageError, and as `lint` does."""
    from .run import lint

    refuse_wrong_values(typed)
    typed |= {name: split(typed[name]) for name in WITH_COMMAS}
    for each in typed["show"]:
        one_of("--show", each, SHOWN)
    typed |= {name: tuple(typed[name] or ()) for name in ("paths", "output")}
    typed["traceback"] |= "--traceback" in sys.argv  # typed before the verb
    typed |= standard_input(typed)
    return lint(LintOptions.of(typed))


def standard_input(typed: dict[str, Any]) -> dict[str, Any]:
    """Return the paths where one is `-`: the file that standard input stands for. Raises UsageError."""
    name, has_dash = typed["stdin_filename"], Path("-") in typed["paths"]
    if name is None and not has_dash:
        return {}
    if name is None:
        raise UsageError("`-` is standard input; --stdin-filename says which file it stands for")
    if typed["paths"] not in ((), (Path("-"),)):
        raise UsageError("--stdin-filename is for one file; leave the paths out, or give `-`")
    options = (name for name in ("fix", "fix_only", "diff", "watch") if typed[name])
    if wrong := next(options, None) or ("add_ignores" if typed["add_ignores"] is not None else ""):
        raise UsageError(f"--{wrong.replace('_', '-')} can't be used with standard input, which is no file on disk")
    if not is_folder(name.parent):
        raise UsageError(f"--stdin-filename: there is no folder `{name.parent}`")
    return {"paths": (name if is_file(name) else name.parent,)}


def refuse_wrong_values(typed: dict[str, Any]) -> None:
    """Raise UsageError for a value that an option can't have, or not together with another."""
    config, workspace = typed["config"], typed["workspace"]
    one_of("--format", typed["format"], FORMATS)
    if typed["statistics"] and typed["format"] not in ("text", "json"):
        raise UsageError(
            f"--statistics is printed as text or json, not as `{typed['format']}`; give --format text or json"
        )
    refuse_page_on_terminal(typed["format"], "lint")
    one_of("--color", typed["color"], ("auto", "always", "never"))
    for option, level in (("--fail-on", typed["fail_on"]), ("--fix-level", typed["fix_level"])):
        if level is not None:
            one_of(option, level, LEVELS)
    if config is not None and not is_file(config):
        raise UsageError(f"--config: there is no file `{config}`")
    if config is not None and typed["isolated"]:
        raise UsageError("--config and --isolated contradict each other; give one of them")
    if workspace is not None and not is_folder(workspace):
        raise UsageError(f"--workspace: `{workspace}` is not a folder")
