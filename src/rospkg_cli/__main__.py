"""The entry point: --version alone is answered at once, everything else goes to the command line."""

from __future__ import annotations

import sys

from . import __version__
from .search_path import leave_out_current_folder


def main() -> int:
    """Run the command line; return the exit status."""
    leave_out_current_folder()
    if sys.argv[1:] in (["--version"], ["-V"]):
        from .cli.streams import guarded

        return guarded(lambda: print(f"rospkg {__version__}") or 0)
    if sys.argv[1:2] == ["lint"] and (status := lint_as_before(sys.argv[1:])) is not None:
        return status
    from .cli.app import run

    return run()


def lint_as_before(arguments: list[str]) -> int | None:
    """Print what the same run printed before, where it would now print the same; else return None."""
    from .cache.kept_run import RunToKeep, kept_run, set_pending

    found = kept_run(arguments)
    if isinstance(found, RunToKeep):
        set_pending(found)
    if not isinstance(found, tuple):
        return None
    from .cli.streams import guarded

    status, text = found
    return guarded(lambda: sys.stdout.write(text) * 0 + status)


if __name__ == "__main__":
    sys.exit(main())
