"""The exit status of a verb, and the sentence on what ended it."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path

from ..user_error import UserError
from .streams import OutputError, say

CTRL_C = 130
"""What a shell calls the exit status of a command that SIGINT ended: 128 and the number of the signal."""


def status_of(verb: Callable[[], int]) -> int:
    """Run a verb; return its exit status, or that of its error. Raises OutputError."""
    from ..engine.fixing.signals import StoppedError

    try:
        return verb()
    except UserError as error:
        say(str(error))
        return 2
    except KeyboardInterrupt:
        return interrupted(CTRL_C)
    except StoppedError as stopped:
        return interrupted(128 + stopped.number)
    except OutputError:
        raise
    except Exception as error:
        if is_nowhere():
            say("the current folder was removed; change to one that is there (`cd`)")
            return 2
        return failed(error)


def is_nowhere() -> bool:
    """Return whether the folder that the command was started in is gone."""
    try:
        Path.cwd()
    except FileNotFoundError:
        return True
    return False


def interrupted(status: int) -> int:
    """Say so, and return the status."""
    say("interrupted; no partial files were left")
    return status


def failed(error: Exception) -> int:
    """Print a sentence on an internal error; return the exit status."""
    if "--traceback" in sys.argv:
        import traceback

        from ..control_characters import visible_lines, without_workflow_commands

        print(
            without_workflow_commands(visible_lines("".join(traceback.format_exception(error)))),
            end="",
            file=sys.stderr,
        )
    what = f"{type(error).__name__}: {error}"
    say(f"internal error: {what}; please report it with the output of --traceback")
    return 3
