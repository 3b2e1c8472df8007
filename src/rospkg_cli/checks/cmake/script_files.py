"""Whether a file of a package is a script: by its name, its first line, its bit and its statements."""

from __future__ import annotations

import posixpath
import re

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass

STARTS = regex(r"^(?:if[ \t(]+__name__|[A-Za-z_][\w.]*[ \t]*\(|(?:while|for|with|try|raise)\b)", re.MULTILINE)
"""A statement at the top level that does something."""
DEFINES = regex(r"^(?:class|def|async def)\b", re.MULTILINE)
IMPORTS = regex(r"^(?:from[ \t]+[\w.]+[ \t]+import[ \t(]|import[ \t]+[\w.]+[ \t]*$)", re.MULTILINE)
"""A line that is Python and no shell command."""
FOR_ROS1 = regex(r"^[ \t]*(?:import|from)[ \t]+rospy\b", re.MULTILINE)


@dataclass(frozen=True)
class ScriptFiles:
    files: PackageFiles

    def text(self, path: str) -> str:
        return self.files.readable_text(path)

    def is_runnable(self, path: str) -> bool:
        """Return whether a file is a program, by its name."""
        return posixpath.splitext(path)[1] in (".py", ".sh", ".bash", "")

    def has_shebang(self, path: str) -> bool:
        """Return whether a file begins with `#!`; also where it can't be read."""
        try:
            return self.files.tree.entry(path).data.startswith(b"#!")
        except OSError:
            return True

    def has_bit(self, path: str) -> bool:
        """Return whether a file is executable; also where it can't be read."""
        try:
            return self.files.is_executable(path)
        except OSError:
            return True

    def is_python(self, path: str) -> bool:
        """Return whether a file is Python by its name, or by its imports where its name has no suffix."""
        if "." in posixpath.basename(path):
            return path.endswith(".py")
        return IMPORTS.search(self.text(path)) is not None

    def does_something(self, path: str) -> bool:
        """Return whether a Python file has statements other than definitions and imports at its top level."""
        return STARTS.search(self.text(path)) is not None

    def holds_definitions(self, path: str) -> bool:
        """Return whether a file is a Python module to import: definitions, and no statement that does something."""
        is_defining = path.endswith(".py") and DEFINES.search(self.text(path)) is not None
        return is_defining and not self.does_something(path)

    def is_for_ros1(self, path: str) -> bool:
        return FOR_ROS1.search(self.text(path)) is not None
