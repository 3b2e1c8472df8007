"""Whether anything starts or imports a Python file of a package, by a search in texts: it can't be read itself."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cached_property

from ..files import PackageFiles
from ..light_dataclasses import dataclass
from ..package.file_role import role_of

NAMING = (".py", ".cfg", ".toml", ".txt", ".cmake", ".xml", ".launch", ".yaml", ".yml", ".json", ".sh")
"""Files that may name a module, beside those whose texts only tell of it."""


@dataclass(frozen=True)
class StartedTexts:
    files: PackageFiles

    def named(self, path: str, others: Iterator[str]) -> Iterator[str]:
        """Yield those of some files that name a Python file or its module."""
        stem = re.escape(path.rpartition("/")[2].partition(".")[0])
        named = re.compile(rf"(?<![\w.-]){stem}(?!\w)|\.{stem}\b")
        return (each for each in others if each != path and named.search(self.files.readable_text(each)))

    def is_named(self, path: str) -> bool:
        """Return whether another file names a Python file."""
        return any(self.named(path, iter(self.texts)))

    def is_reached(self, path: str) -> bool:
        """Return whether a file that is no module names one, or a module does that one of these names, and so on.

        What a rule of CMake installs with its folder may be started by its name.
        """
        found, waiting = {path}, [path]
        while waiting:
            one = waiting.pop()
            if self.is_installed_with_its_folder(one):
                return True
            for other in self.named(one, iter(self.texts)):
                if not is_module(other):
                    return True
                waiting += [other] if other not in found else []
                found.add(other)
        return False

    def is_installed_with_its_folder(self, path: str) -> bool:
        """Return whether a rule of CMake installs all that is in a file's folder, or all that a glob finds there."""
        place = rf"(?:(?<![\w./-])|\}}/){re.escape(path.rpartition('/')[0])}(?:/(?:\*[\w.*]*)?)?(?![\w./-])"
        rule = rf"\b(?:DIRECTORY|GLOB|GLOB_RECURSE)\b[^()]*{place}"
        return "/" in path and re.search(rule, self.files.readable_text("CMakeLists.txt")) is not None

    @cached_property
    def texts(self) -> tuple[str, ...]:
        paths = (path for path in self.files.paths if path.endswith(NAMING))
        return tuple(path for path in paths if role_of(path) != "test")


def is_module(path: str) -> bool:
    """Return whether a file is Python that something else starts or imports, and no setup.py or launch file."""
    return path.endswith(".py") and path != "setup.py" and role_of(path) != "launch"
