"""What `rospkg new` does with --update and with -i."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from .. import UsageError

if TYPE_CHECKING:
    from ...scaffold.answers import Request


def update_at(package: Path, request: Request, dry_run: bool, diff: bool, color: str, others: bool) -> int:
    """Update a package; raises UsageError for options that are for new ones (`others`)."""
    from .update import update

    if request.name:
        raise UsageError(f"--update keeps the name of the package; leave `{request.name}` out")
    if others or request.minimal:
        raise UsageError(
            "--update goes with --dry-run, --diff and the answers; leave --force, --skip, --family, --minimal, "
            "--no-record and -i out"
        )
    return update(package, request, dry_run, diff, color)


def ask_all(request: Request, into: Path) -> Request:
    """Ask for what was not typed, and show the command that needs no questions."""
    from ..streams import say
    from .interactive import ask, command_of
    from .run import defaults

    request = ask(request, into, defaults(into))
    say(f"the same without questions: {command_of(request)}")
    return request
