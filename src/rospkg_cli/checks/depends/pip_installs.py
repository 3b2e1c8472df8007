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
from ..container_files import OF_CONTAINER, files_called

REQUIREMENTS = regex(r"(?:.*/)?requirements[^/]*\.txt")
TYPED = regex(r"(?:.*/)?(?:README[^/]*|[^/]*\.(?:md|rst|sh|bash))")
"""Files with commands: some run them, and people type those of the others."""
ABOVE = (
    "requirements.txt", "docker/requirements.txt", "README.md", "README.rst", "README", "INSTALL.md", "install.sh",
    "setup.sh", "scripts/install.sh", "scripts/setup.sh",
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
        return frozenset(name for path, text in installing_texts(self.files) for name in names_in(path, text))


def installing_texts(files: PackageFiles) -> Iterator[tuple[str, str]]:
    """Yield the requirements, pages and scripts of the package and of the folders above it, and all that containers
    are made by, with their paths.
    """
    for path in files.paths:
        if REQUIREMENTS.fullmatch(path) or TYPED.fullmatch(path):
            yield path, files.readable_text(path)
    whole = PackageFiles(files.whole) if files.whole is not None else None
    for each in ABOVE if whole is not None else ():
        path = files.above((each,)) or ""
        if whole is not None and path:
            yield path, whole.readable_text(path)
    for owner, path in files_called(files, OF_CONTAINER):
        yield path, owner.readable_text(path)


def names_in(path: str, text: str) -> Iterator[str]:
    """Yield the names in a file of requirements, or behind `pip install` in commands."""
    if REQUIREMENTS.fullmatch(path):
        yield from (match[1] for match in LISTED.finditer(text))
        return
    for command in INSTALLS.finditer(text):
        yield from (word[0] for word in WORD.finditer(command[1]))


def normalized(name: str) -> str:
    return re.sub(r"[-_.]+", "-", name).lower()
