"""The YAML files that the launch files, the code and the pages of a package name."""

from __future__ import annotations

from ...files import ReaderInput
from ...lazy_regex import regex
from ..file_role import role_of
from ..launch.live_text import live_text

NAMING = (".py", ".xml", ".launch", ".yaml", ".yml", ".cpp", ".cc", ".hpp", ".h", ".sh", ".bash", ".service", ".md")
MARKS = (b".yaml", b".yml")
ANY = "*"
"""Stands for a name that is put together when the text is run."""
FILE = regex(r"(?:^|[^\w.-])([\w.-]*)\.ya?ml\b")


def named_yaml(reading: ReaderInput) -> frozenset[str]:
    """Return the last part of each name of a YAML file, without its suffix, and `*` where one is put together."""
    files, found = reading.files, set()
    paths = (path for path in files.paths if path.endswith(NAMING) and role_of(path) not in ("test", "aside"))
    for path in (path for path in paths if any(files.holds(path, mark) for mark in MARKS)):
        found.update(FILE.findall(live_text(files, path)))
    return frozenset(ANY if is_part(name) else name for name in found)


def puts_together(text: str) -> bool:
    """Return whether a text puts the name of a YAML file together when it is run."""
    return any(map(is_part, FILE.findall(text)))


def is_part(name: str) -> bool:
    return name[:1] in ("", ".", "_", "-")
