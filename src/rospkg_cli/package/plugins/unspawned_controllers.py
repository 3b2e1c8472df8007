"""Controllers with a type that nothing in the package spawns, though it spawns others of the same manager."""

from __future__ import annotations

import re
from collections.abc import Iterable
from itertools import pairwise

from ...files import PackageFiles
from ...lazy_regex import regex
from ..file_role import role_of
from ..launch.text import uncommented
from .unlisted_blocks import ancestors, keys

NAMING = (".py", ".xml", ".launch", ".yaml", ".yml", ".sh", ".bash", ".cpp", ".hpp", ".md", ".rst", ".srv", ".service")
"""Files that name a controller which is loaded, or say how to load it; MoveIt spawns what a YAML file lists."""
TYPE = "type"
MANAGER = regex(r"controller_manager[ ]*:")


class SpawnedNames:
    """What the files of a package name, but for the one that gives controllers their types."""

    def __init__(self, files: PackageFiles) -> None:
        self.files = files
        self.known: dict[str, list[str]] = {}

    def is_unspawned(self, path: str, text: str, at: int) -> bool:
        """Return whether the type at an offset is that of a controller which no other file names.

        Where none of its siblings is named, another package may spawn all of them.
        """
        name = controller_at(text, at)
        if not name or not MANAGER.search(text):
            return False
        others = self.texts(path)
        if any(may_name(name, each) for each in others):
            return False
        siblings = {found for found in controllers(text) if found != name}
        return any(word(each).search(other) for each in siblings for other in others)

    def texts(self, path: str) -> list[str]:
        if path not in self.known:
            paths = (each for each in self.files.paths if each.endswith(NAMING) and each != path)
            run = (each for each in paths if role_of(each) != "aside")
            self.known[path] = [uncommented(each, self.files.readable_text(each)) for each in run]
        return self.known[path]


def controller_at(text: str, at: int) -> str:
    """Return the key above the `type` at an offset; "" where there is none."""
    own, block, *_ = [*ancestors(text, at), None, None]
    return block.name if own is not None and own.name == TYPE and block is not None else ""


def is_of_something(text: str, at: int) -> bool:
    """Return whether the `type` at an offset is that of anything, as nothing says that it is a controller's.

    A controller manager alone surely takes it for a plugin; other nodes may make what they have themselves.
    """
    own, *around = [each.name for each in ancestors(text, at)] or [""]
    is_type = own.rpartition(".")[2] == TYPE
    return is_type and not any(each.rpartition("/")[2].endswith("controller_manager") for each in around)


def controllers(text: str) -> Iterable[str]:
    """Return the keys right above each `type`."""
    lines = text.splitlines()
    found = list(keys(lines, range(len(lines))))
    return [one.name for one, two in pairwise(found) if two.name == TYPE]


def may_name(name: str, text: str) -> bool:
    """Return whether a text names a controller, or puts together a name with its beginning or its end."""
    pieces = name.split("_")
    ends = "|".join(re.escape("_".join(pieces[at:])) for at in range(1, len(pieces)))
    starts = "|".join(re.escape("_".join(pieces[:at])) for at in range(1, len(pieces)))
    if word(name).search(text) is not None:
        return True
    joined = rf"(?:\}}|\)|\+\s*[frFR]?[\"'])_?(?:{ends})[\"'\s]|[\"'\s](?:{starts})_?(?:[\"']\s*[+%,]|[{{%$])"
    return bool(ends) and re.search(joined, text) is not None


def word(name: str) -> re.Pattern[str]:
    return re.compile(rf"(?<![\w-]){not_looked_up(name)}(?![\w-])")


def not_looked_up(name: str) -> str:
    """Return the pattern of a name but where code looks it up in a value that has it (`loaded["arm"]["default"]`).

    What sets it there (`controllers["arm"] = …`) may be what hands it to a spawner.
    """
    escaped = re.escape(name)
    return rf"(?:(?<![\w)\]]\[[\"'])|(?={escaped}[\"']\]\s*=[^=])){escaped}"
