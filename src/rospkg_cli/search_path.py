"""Where Python looks for modules: never in the current folder, which may be an untrusted package.

`python -m rospkg_cli` and an empty entry in PYTHONPATH (a trailing `:` is enough) put it first; a `yaml.py`
in it would be imported instead of PyYAML.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator

OWN = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))  # noqa: PTH100, PTH120 — pathlib is not imported yet


def leave_out_current_folder() -> None:
    """Take the current folder out of `sys.path` and, for processes that are started, out of the environment."""
    trusted = set(map(os.path.realpath, installed_folders()))
    sys.path[:] = [entry for entry in sys.path if not is_current(entry, trusted)]
    listed = os.environ.get("PYTHONPATH")
    if listed is not None:
        kept = [entry for entry in listed.split(os.pathsep) if not is_current(entry, trusted)]
        os.environ["PYTHONPATH"] = os.pathsep.join(kept)
    os.environ["PYTHONSAFEPATH"] = "1"  # workers that are spawned begin with `python -c`


def is_current(entry: str, trusted: set[str]) -> bool:
    """Return whether an entry is the current folder, and none that modules are installed into."""
    try:
        folder = os.path.realpath(entry or os.curdir)
        return folder not in trusted and os.path.samefile(folder, os.curdir)  # noqa: PTH121
    except OSError:
        return not entry


def installed_folders() -> Iterator[str]:
    """Yield the folders of rospkg, of Python's own modules and of installed ones."""
    yield OWN
    yield os.path.dirname(os.__file__)  # noqa: PTH120
    site = sys.modules.get("site")
    if site is not None:
        yield from site.getsitepackages()
        yield site.getusersitepackages()
