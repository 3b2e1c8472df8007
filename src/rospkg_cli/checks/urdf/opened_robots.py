"""Rule input: whether anything opens a robot description of a package, as far as the texts of the package say."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING

from ...files import PackageFiles
from ...light_dataclasses import dataclass
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from .given_arguments import GivenArguments
from .included_paths import includes_path
from .named_with_folder import NamedWithFolder
from .naming_packages import NamingPackages
from .robot_texts import RobotTexts
from .xacro_includes import may_include

if TYPE_CHECKING:
    from .named_elsewhere import NamedElsewhere

XACRO = (".urdf", ".xacro")


@dataclass(frozen=True)
class OpenedRobots:
    files: PackageFiles
    package: PackageFacts
    workspace: Workspace
    texts: RobotTexts
    packages: NamingPackages
    arguments: GivenArguments

    def has(self, path: str) -> bool:
        """Return whether a file may be opened: a text of the package names it, or one of a package that names this.

        Robots name files in full; launch files and code often append the suffix to the stem. Such a stem must have
        letters: a `1` occurs everywhere. A robot that names a file opens it where something opens the robot.
        """
        if path not in self._opened:
            self._opened[path] = any(self.is_opened_itself(each) for each in (path, *self.including(path)))
        return self._opened[path]

    @cached_property
    def _opened(self) -> dict[str, bool]:
        """The answers so far: several rules ask for each robot, and for those that include it."""
        return {}

    def is_opened_itself(self, path: str) -> bool:
        """Return whether anything other than a robot of the package may open a file."""
        if self.is_other_copy(path):
            return False
        may_be = not self.texts.is_copy(path) and (self.texts.may_compose(path) or self.packages.has(path))
        return may_be or any(not other.endswith(XACRO) for other in self.texts.naming(path))

    def including(self, path: str) -> list[str]:
        """Return the robots of the package that name a file, those that name one of these, and so on."""
        found, waiting = {path}, [path]
        while waiting:
            inner = waiting.pop()
            more = [] if self.is_other_copy(inner) else self.robots_naming(inner)
            waiting += [each for each in more if each not in found]
            found.update(more)
        return sorted(found - {path})

    def robots_naming(self, path: str) -> list[str]:
        """Return the robots that name a file: by an include, or elsewhere in their texts."""
        if path not in self._robots_naming:
            self._robots_naming[path] = self.find_robots_naming(path)
        return self._robots_naming[path]

    @cached_property
    def _robots_naming(self) -> dict[str, list[str]]:
        return {}

    def find_robots_naming(self, path: str) -> list[str]:
        name = path.rpartition("/")[2]
        texts = dict(self.texts.every)
        named = (each for each in self.texts.naming(path) if each.endswith(XACRO))
        return [
            each for each in named if not may_include(texts[each], name) or self.is_included(path, each, texts[each])
        ]

    def is_included(self, path: str, by: str, text: str) -> bool:
        """Return whether a robot of the package, given by its path and text, may include a file of the package."""
        return includes_path(by, text, path, self.package.name, self.paths)

    @cached_property
    def paths(self) -> frozenset[str]:
        return frozenset(self.files.paths)

    def is_other_copy(self, path: str) -> bool:
        """Return whether texts name a file of this name with the folder of another copy, and none with this one's."""
        return self.with_folders.is_other_copy(path)

    @cached_property
    def with_folders(self) -> NamedWithFolder:
        return NamedWithFolder(self.paths, self.package.name, self.workspace, self.texts.every)

    @cached_property
    def elsewhere(self) -> NamedElsewhere:
        """What distinguishes files of one name; imported only where something names a robot."""
        from .named_elsewhere import NamedElsewhere

        return NamedElsewhere(self.paths, self.package, self.workspace)
