"""Rule input: which robot descriptions are robots of their own, and which are parts that other files include."""

from __future__ import annotations

from fnmatch import fnmatchcase
from functools import cached_property

from ...files import PackageFiles
from ...languages.xml.parser import Document
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.package_facts import PackageFacts
from ...package.urdf.robot_file import RobotFile
from ...package.workspace import Workspace

INCLUDED = regex(r"<xacro:include\s[^>]*?filename\s*=\s*[\"']([^\"']*)")
COMPUTED = regex(r"\$\{[^}]*\}|\$\([^()]*\)")
STARTS = (".py", ".launch", ".launch.xml", ".yaml")
"""Files that name the robots that they start."""


@dataclass(frozen=True)
class XacroIncludes:
    files: PackageFiles
    package: PackageFacts
    workspace: Workspace

    @cached_property
    def texts(self) -> tuple[str, ...]:
        """The texts of the files that may be robots, or include one."""
        paths = (path for path in self.files.paths if path.endswith((".xacro", ".urdf", ".xml")))
        return tuple(map(self.files.readable_text, paths))

    def is_robot(self, robot: RobotFile) -> bool:
        """Return whether a file is a robot of its own: it has a name, and no other file mentions it."""
        return self.is_top(robot.document)

    def is_top(self, document: Document) -> bool:
        """Return whether the root of a file has a name, and no file of this package or robot of another mentions it."""
        name = document.source.path.rpartition("/")[2]
        named = document.root.get("name") is not None
        texts = [text for text in self.texts if text is not document.source.text and "xacro:include" in text]
        if not named or any(name in text for text in texts):
            return False
        is_included = (document.source.path in self.included_elsewhere) or any(
            may_include(text, name) for text in texts
        )
        return self.is_launched(name) or not is_included

    def is_part(self, document: Document) -> bool:
        """Return whether a robot includes a file that code and launch files do not name: it may be incomplete."""
        path, name = document.source.path, document.source.path.rpartition("/")[2]
        own = any(may_include(text, name) for text in self.texts if text is not document.source.text)
        return (own or path in self.included_elsewhere) and not self.is_launched(name)

    @cached_property
    def included_elsewhere(self) -> frozenset[str]:
        """The files of the package that robots of other packages include."""
        others = (facts for facts in self.workspace.packages if facts.name != self.package.name)
        named = (each for facts in others for each in facts.robot_includes)
        return frozenset(path for package, path, _ in named if package == self.package.name)

    def is_launched(self, name: str) -> bool:
        """Return whether code or a launch file names a robot."""
        paths = (path for path in self.files.paths if path.endswith(STARTS))
        return any(name in self.files.readable_text(path) for path in paths)

    def including(self, name: str) -> tuple[str, ...]:
        """Return the texts that may include a file of a name."""
        return tuple(text for text in self.texts if may_include(text, name))


def may_include(text: str, name: str) -> bool:
    """Return whether a file includes another one of this name, or by a computed path that may be it."""
    for match in INCLUDED.finditer(text):
        last = COMPUTED.sub("*", match.group(1)).rpartition("/")[2]
        if last == name or ("*" in last and fnmatchcase(name, last)):
            return True
    return False
