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
    from .cli.app import run

    return run()


if __name__ == "__main__":
    sys.exit(main())
