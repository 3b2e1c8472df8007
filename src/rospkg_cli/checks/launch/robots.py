"""Robot descriptions that launch_ros would read as YAML, and whether YAML would take them."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

from ...files import PackageFiles
from ...package.launch.file import LaunchFile
from ...package.launch.unquoted import Unquoted
from ...unreadable import UnreadableError

NO_PLAIN_SCALAR = re.compile(r":[ \t\r\n]|[ \t]#")
"""What ends a plain scalar of YAML: a colon with a blank behind it, a hash with a blank before it."""

INCLUDED = re.compile(r"filename\s*=\s*[\"'][^\"']*?([\w.-]+\.(?:xacro|urdf|xml))[\"']")
ROBOTS = (".xacro", ".urdf")


@dataclass(frozen=True)
class Robots:
    file: LaunchFile
    files: PackageFiles

    def unquoted(self) -> Iterator[tuple[Unquoted, str]]:
        """Yield each description with the robot file of the package that YAML can't read; "" where none is known."""
        for each in self.file.unquoted:
            yield each, next(self.unreadable(each.robot), "")

    def unreadable(self, name: str) -> Iterator[str]:
        """Yield the files of a robot that hold what YAML can't read, from the one of this name on."""
        seen, queue = {name}, [name] if name.endswith(ROBOTS) else []
        while queue:
            asked = queue.pop()
            for path in self.files.paths:
                if path.rpartition("/")[2] == asked:
                    text = self.text(path)
                    if NO_PLAIN_SCALAR.search(text):
                        yield path
                    found = [each for each in INCLUDED.findall(text) if each not in seen]
                    seen.update(found)
                    queue += found

    def text(self, path: str) -> str:
        try:
            return self.files.source(path).text
        except UnreadableError:
            return ""
