"""The xacro files that a robot may include: those of its package, and of the other packages of the run."""

from __future__ import annotations

import posixpath
from functools import cached_property

from ....files import PackageFiles
from ....languages.xml.parser import Document, read_xml
from ....lazy_regex import regex
from ....light_dataclasses import dataclass
from ....source import Source
from ....tree import SkippedError
from ....unreadable import UnreadableError
from ...workspace import Workspace
from .macros import macro_name
from .texts import PACKAGE

GLOB = regex(r"[*?\[]")
ROBOTS = (".xacro", ".urdf")
MAX_FILE = 2_000_000


@dataclass(frozen=True)
class XacroLibrary:
    """Files go by their paths in the package; those of another package by their paths in the run, behind a `/`."""

    files: PackageFiles
    own: str
    """The name of the package."""
    workspace: Workspace

    @cached_property
    def documents(self) -> dict[str, Document | None]:
        return {}

    def included(self, name: str, by: str) -> Document | None:
        """Return the file that an include names; None where it is not here, or is not known."""
        if GLOB.search(name):
            return None
        if name.startswith(PACKAGE):
            package, _, path = name[len(PACKAGE) :].partition("/")
            path = posixpath.normpath(path)
            if package == self.own:
                return self.read(path) or self.read(self.installed_as(path))
            facts = self.workspace.named(package)
            return self.read(facts.at(path)) if facts is not None else None
        if "://" in name or name.startswith(("/", "~")):
            return None
        return self.read(posixpath.normpath(posixpath.join(posixpath.dirname(by), name)))

    def defining(self, name: str, tail: str) -> set[str]:
        """Return the files of the package that define a macro, and that a computed name of this end may be."""
        return {path for path in self.macro_files.get(name, ()) if path.endswith(tail)}

    @cached_property
    def macro_files(self) -> dict[str, list[str]]:
        """The files of the package that define each macro."""
        found: dict[str, list[str]] = {}
        for path in self.files.paths:
            document = self.read(path) if path.endswith(ROBOTS) else None
            for element in document.root.walk() if document is not None else ():
                if element.tag == "xacro:macro":
                    found.setdefault(macro_name(element), []).append(path)
        return found

    def installed_as(self, path: str) -> str:
        """Return the one file of the package whose path ends in one below the share directory; "" for none."""
        found = [each for each in self.files.paths if each.endswith(f"/{path}")]
        return found[0] if len(found) == 1 else ""

    def read(self, path: str) -> Document | None:
        if path not in self.documents:
            self.documents[path] = self.parse(path)
        return self.documents[path]

    def parse(self, path: str) -> Document | None:
        try:
            source = self.files.source(path) if not path.startswith("/") else self.of_another(path)
            if source is None or len(source.text) > MAX_FILE or "<!DOCTYPE" in source.text:
                return None
            return read_xml(source, prefixes="<xacro:" in source.text)
        except (UnreadableError, UnicodeError, SkippedError, OSError):
            return None

    def of_another(self, path: str) -> Source | None:
        whole = self.files.whole
        return Source(path, whole.entry(path.lstrip("/")).text.text) if whole is not None else None
