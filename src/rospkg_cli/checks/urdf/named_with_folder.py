"""Which of several files of one name a text names, by the folder before the name: `gz/arm.urdf`, `classic/arm.urdf`."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cached_property

from ...light_dataclasses import dataclass
from ...package.workspace import Workspace


@dataclass(frozen=True)
class NamedWithFolder:
    paths: frozenset[str]
    """The files of the package."""
    package: str
    workspace: Workspace
    texts: tuple[tuple[str, str], ...]
    """The path and the text of each file that may open one."""

    def is_other_copy(self, path: str) -> bool:
        """Return whether texts name a file of this name with the folder of another copy, and none with this one's."""
        copies = self.copies.get(path.rpartition("/")[2], [])
        return len(copies) > 1 and not self.has(path) and any(map(self.has, copies))

    @cached_property
    def copies(self) -> dict[str, list[str]]:
        """The paths of the package's files by their names."""
        found: dict[str, list[str]] = {}
        for path in self.paths:
            found.setdefault(path.rpartition("/")[2], []).append(path)
        return found

    def has(self, path: str) -> bool:
        """Return whether a text, of this package or another, names a file together with its folder."""
        if path not in self._answers:
            self._answers[path] = self.look_for(path)
        return self._answers[path]

    @cached_property
    def _answers(self) -> dict[str, bool]:
        """The answers so far: each of two hundred files called `model.sdf` is asked for as a copy of each other."""
        return {}

    def look_for(self, path: str) -> bool:
        folder, _, name = path.rpartition("/")
        last = folder.rpartition("/")[2]
        if not last:
            return False
        in_parts = re.compile(rf"(?<![\w.]){re.escape(last)}[\"'/,\s]+{re.escape(name)}(?![\w.])")
        if any(in_parts.search(text) for other, text in self.holding(name) if other != path and last in text):
            return True
        others = (facts for facts in self.workspace.packages if facts.name != self.package)
        return any({last, name} <= words for facts in others for words in facts.robot_words)

    def holding(self, name: str) -> list[tuple[str, str]]:
        """Return the texts in which a name occurs at all, which are few."""
        if name not in self._holding:
            self._holding[name] = [each for each in self.texts if name in each[1]]
        return self._holding[name]

    @cached_property
    def _holding(self) -> dict[str, list[tuple[str, str]]]:
        return {}


def means_inner_copy(path: str, text: str, paths: Iterable[str]) -> bool:
    """Return whether a text names a file of the same name in a folder below: `urdf/new/arm.urdf` for `urdf/arm.urdf`.

    The text also has the folders between them, and the name does not directly follow the outer folder.
    """
    folder, _, name = path.rpartition("/")
    inner = (each for each in paths if each != path and each.startswith(f"{folder}/") and each.endswith(f"/{name}"))
    if not any(has_all(each[len(folder) + 1 : -len(name) - 1], text) for each in inner):
        return False
    return re.search(rf"(?<![\w.]){re.escape(folder.rpartition('/')[2])}[\"'/,\s]+{re.escape(name)}", text) is None


def has_all(folders: str, text: str) -> bool:
    return all(re.search(rf"(?<![\w.]){re.escape(each)}(?![\w.])", text) for each in folders.split("/"))
