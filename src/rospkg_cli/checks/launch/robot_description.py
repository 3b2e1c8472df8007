"""LCH009: the output of a command as a parameter, which launch_ros reads as YAML: robot descriptions.

A `ParameterValue(…, value_type=str)` around it makes it a string.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.launch.launch_file import LaunchFile
from .robot_parameters import RobotParameter, robot_parameters

COMMENT = r"<!--(?:(?!-->).){0,5000}-->[ \t\r]{0,200}\n?[ \t]{0,200}"
DROPPED = regex(rf"(?:{COMMENT}){{1,20}}(?=<xacro:)|<xacro:[^<>]*>", re.DOTALL)
"""What xacro leaves out: its own elements, and the comments right before them. (xacro: remove_previous_comments)"""

NO_PLAIN_SCALAR = regex(r":[ \t\r\n]|[ \t]#")
"""What ends a plain scalar of YAML: a colon with a blank behind it, a hash with a blank before it."""

HEADER = regex(rf"\s*(?:<\?xml[^>]*>\s*)?(?:{COMMENT})*", re.DOTALL)
"""What stands before the root element."""

INCLUDED = regex(r"filename\s*=\s*[\"'][^\"']*?([\w.-]+\.(?:xacro|urdf|xml))[\"']")


@dataclass(frozen=True)
class RobotDescriptions:
    """The robot parameters of the launch files of a package, and its robot files."""

    launch: tuple[LaunchFile, ...]
    files: PackageFiles

    def parameters(self) -> Iterator[tuple[LaunchFile, RobotParameter, str]]:
        """Yield each parameter with the file of the package that YAML can't read; "" where none is known."""
        for file in self.launch:
            for each in robot_parameters(file.evaluated) if file.evaluated else ():
                yield file, each, next(self.files_unlike_yaml(each.robot), "")

    def files_unlike_yaml(self, name: str) -> Iterator[str]:
        """Yield the files of a robot that hold what YAML can't read, from the one of this name on."""
        seen, queue = {name}, [name] if name.endswith((".xacro", ".urdf")) else []
        while queue:
            current = queue.pop()
            for path in self.files.paths:
                if path.rpartition("/")[2] == current:
                    text = self.files.readable_text(path)
                    if NO_PLAIN_SCALAR.search(printed(text if current == name else root_of(text))):
                        yield path
                    found = [each for each in INCLUDED.findall(text) if each not in seen]
                    seen.update(found)
                    queue += found


def root_of(text: str) -> str:
    """Return a file from its root element on: xacro includes nothing of what stands before it (process_include)."""
    header = HEADER.match(text)
    return text[header.end() :] if header else text


def printed(text: str) -> str:
    """Return what xacro prints of a file, as far as it passes over comments and its own elements."""
    return DROPPED.sub("", text) if "<xacro:" in text else text
