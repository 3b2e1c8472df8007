"""Which Python libraries a repository has pip install: by its requirements, its Dockerfiles, scripts and pages."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cached_property

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...ros.aliases import key_for_pip
from ...ros.names import Names

REQUIREMENTS = regex(r"(?:.*/)?requirements[^/]*\.txt")
TYPED = regex(r"(?:.*/)?(?:(?:[^/]*\.)?Dockerfile[^/]*|README[^/]*|[^/]*\.(?:md|rst|sh|bash))")
"""Files with commands: some run them, and people type those of the others."""
ABOVE = (
    "requirements.txt", "docker/requirements.txt", "Dockerfile", "docker/Dockerfile", ".devcontainer/Dockerfile",
    "README.md", "README.rst", "README", "INSTALL.md", "install.sh", "setup.sh", "scripts/install.sh",
    "scripts/setup.sh",
)  # fmt: skip
LISTED = regex(r"^[ \t]*([A-Za-z][\w.-]*)", re.MULTILINE)
INSTALLS = regex(r"\bpip3?\s+install\b((?:[^\n&|;\\]|\\\n)*)")
WORD = regex(r"(?<![\w./:-])[A-Za-z][\w.-]*")


@dataclass(frozen=True)
class PipInstalls:
    files: PackageFiles

    def has(self, module: str, key: str, index: Names) -> bool:
        """Return whether pip is told to install what a module is of, under its own name or one that rosdep knows."""
        wanted = normalized(module.partition(".")[0])
        return wanted in self.names or any(key_for_pip(name, index) == key for name in self.written)

    @cached_property
    def names(self) -> frozenset[str]:
        return frozenset(map(normalized, self.written))

    @cached_property
    def written(self) -> frozenset[str]:
        """The names of distributions, as the files of the package and of the folders above it write them."""
        own = [path for path in self.files.paths if REQUIREMENTS.fullmatch(path) or TYPED.fullmatch(path)]
        found = {name for path in own for name in names_in(path, self.files.readable_text(path))}
        whole = PackageFiles(self.files.whole) if self.files.whole is not None else None
        for each in ABOVE if whole is not None else ():
            path = self.files.above((each,))
            found.update(names_in(path, whole.readable_text(path)) if path and whole else ())
        return frozenset(found)


def names_in(path: str, text: str) -> Iterator[str]:
    """Yield the names in a file of requirements, or behind `pip install` in commands."""
    if REQUIREMENTS.fullmatch(path):
        yield from (match[1] for match in LISTED.finditer(text))
    elif TYPED.fullmatch(path):
        for command in INSTALLS.finditer(text):
            yield from (word[0] for word in WORD.finditer(command[1]))


def normalized(name: str) -> str:
    return re.sub(r"[-_.]+", "-", name).lower()
