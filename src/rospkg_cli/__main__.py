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
    import gc

    # Looking for circles among trees of syntax is an eighth of a run, and few are there: most is freed without it
    gc.set_threshold(200_000, 20, 100)
    try:
        if sys.argv[1:2] == ["lint"]:
            return lint(sys.argv[1:])
        from .cli.app import run

        return run()
    finally:
        gc.freeze()  # the interpreter would look through them all when it ends, a fifth of a small run


def lint(arguments: list[str]) -> int:
    """Lint, or print what the same run printed before where it would print the same again."""
    from .cache.kept_run import RunToKeep, kept_run, set_run

    found = kept_run(arguments)
    if isinstance(found, tuple):
        from .cli.streams import guarded

        status, text = found
        return guarded(lambda: sys.stdout.write(text) * 0 + status)
    set_run(found)
    status = lint_anew(arguments)
    if isinstance(found, RunToKeep):
        found.keep(status)
    set_run(None)
    return status


def lint_anew(arguments: list[str]) -> int:
    """Lint, with typer only where the arguments need it; return the exit status."""
    from .cli.lint.plain_arguments import plain_arguments

    typed = plain_arguments(arguments[1:])
    if typed is None:
        from .cli.app import run

        return run()
    from .cli.exit_status import status_of
    from .cli.lint.typed_options import lint_as_typed
    from .cli.streams import guarded

    return guarded(lambda: status_of(lambda: lint_as_typed(typed)))


if __name__ == "__main__":
    sys.exit(main())
