"""Files that `add` writes: new ones, and those that several nodes share."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ..change import ChangeError
from ..finding import Create, Delete
from ..light_dataclasses import dataclass
from ..package.package import Package
from .part import Operations

HEADER = re.compile(r"(?:#!.*\n)?(?:[ \t]*(?:#(?!include|ifndef|pragma)|//).*\n|[ \t]*\n)*")
"""A first line for the shell, and the comment of license and copyright."""


@dataclass(frozen=True)
class NewFile:
    path: str
    text: str
    executable: bool = False
    clash: str = "choose another name"
    """What to do where another file has the name."""
    users: str = ""
    """A pattern of the code that uses it, where other nodes may; it is kept as long as a file of the package does."""
    force: bool = False
    """Whether it is removed even where it was edited since."""

    def add(self, package: Package) -> Operations:
        """Return the file, nothing where it is there; raises ChangeError where another has its name."""
        if not package.files.is_there(self.path):
            return (Create(self.path, self.text, self.executable),)
        if not package.files.exists(self.path) or body(package.files.readable_text(self.path)) != body(self.text):
            raise ChangeError(f"`{self.path}` is there already, and is something else; {self.clash}")
        return ()

    def remove(self, package: Package) -> Iterator[Operations]:
        """Yield its deletion; raises ChangeError where it was edited since."""
        if not package.files.exists(self.path):
            return
        is_ours = self.says(package.files.readable_text(self.path)) == self.says(self.text)
        if self.users:
            if is_ours and not self.is_used(package):
                yield (Delete(self.path),)
        elif is_ours or self.force:
            yield (Delete(self.path),)
        else:
            raise ChangeError(f"`{self.path}` is not as `add` writes it; --force removes it all the same")

    def says(self, text: str) -> str:
        """Return what counts of a text: all but its header, of parameters all but comments."""
        if self.path.endswith(".yaml"):
            return "\n".join(line.partition("#")[0].rstrip() for line in text.split("\n") if line[:5].strip(" #"))
        return body(text)

    def is_used(self, package: Package) -> bool:
        """Return whether another file of the package uses it."""
        used = re.compile(self.users, re.MULTILINE)
        suffixes = (".py", ".cpp", ".hpp", ".h", ".cc", ".cxx", ".hxx")
        return any(
            path != self.path and path.endswith(suffixes) and used.search(package.files.readable_text(path))
            for path in package.files.paths
        )


def body(text: str) -> str:
    """Return a text without what differs from author to author: the header."""
    found = HEADER.match(text)
    return text[found.end() :].rstrip() if found else text.rstrip()


def without_header(text: str) -> str:
    """Return a text without the comment of license and copyright, a first line for the shell stays."""
    first, newline, _ = text.partition("\n")
    return (first + newline if first.startswith("#!") else "") + body(text) + "\n"
