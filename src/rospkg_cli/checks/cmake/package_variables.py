"""Variables that found packages set (`rclcpp_INCLUDE_DIRS`), and which of them a misspelt name stands for."""

from __future__ import annotations

from functools import cached_property

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.workspace import Workspace
from ...ros.link_targets import MESSAGES, ROS_NAME
from ...ros.names import NameKind
from ...ros.read_table import rows
from ...suggest import near_names
from .name_slips import digits

OF_PACKAGE = regex(r"(\w+)_(INCLUDE_DIRS?|INCLUDES|LIBRARY|LIBRARIES|LIBS|TARGETS?|DEFINITIONS)")
CERTAIN = regex(r"rclcpp\w*|tf2\w*|Boost|OpenCV")
"""Packages, in addition to those of messages, whose variables are known to begin with their own name only."""
SUFFIXES = {"INCLUDE_DIR": "INCLUDE_DIRS", "INCLUDES": "INCLUDE_DIRS", "LIBRARY": "LIBRARIES", "LIBS": "LIBRARIES",
            "TARGET": "TARGETS"}  # fmt: skip
"""Ending that people write → the one that ament_package() sets."""
OF_PLAIN_CMAKE = frozenset("apriltag console_bridge fmt octomap orocos_kdl urdfdom_headers".split())
"""Packages of the table that are not built with ament: their configs set any variables, as `OCTOMAP_LIBRARIES`."""
SHORTEST = 6
"""Letters that the name of a package needs for a similar one to be a slip of it."""


@dataclass(frozen=True)
class PackageVariables:
    cmake: CMake
    workspace: Workspace

    def near(self, name: str) -> str | None:
        """Return the variable of a found package that differs from a name in case, ending or one letter alone."""
        found = OF_PACKAGE.fullmatch(name)
        package = self.packages.get(found[1].lower()) or self.near_package(found[1]) if found else None
        if found is None or package is None:
            return None
        suffix = SUFFIXES.get(found[2], found[2]) if package.islower() else found[2]
        wanted = f"{package}_{suffix}"
        return wanted if wanted != name else None

    def near_package(self, name: str) -> str | None:
        """Return the one found package that is a letter off a name, where no package has that name itself."""
        is_clear = len(name) >= SHORTEST and ROS_NAME.fullmatch(name) is not None
        is_package = self.workspace.kind_of(name) in (NameKind.PACKAGE, NameKind.KEY)
        if not is_clear or is_package or self.workspace.named(name):
            return None
        near = near_names(name, (each for each in self.packages.values() if digits(each) == digits(name)), 1)
        return near[0] if len(near) == 1 else None

    @cached_property
    def packages(self) -> dict[str, str]:
        """Name in lower case → name, of the found packages whose variables are known."""
        names = [each.name for each in self.cmake.packages]
        certain = (each for each in names if CERTAIN.fullmatch(each) or is_of_ros(each) or self.is_made_here(each))
        return {name.lower(): name for name in certain}

    def is_made_here(self, name: str) -> bool:
        """Return whether ament_package() writes the variables of a package of the workspace."""
        facts = self.workspace.named(name)
        return facts is not None and facts.build_type == "ament_cmake"


def package_of(variable: str) -> str:
    """Return the package that a variable belongs to, in capitals; the variable itself where it has no such ending."""
    found = OF_PACKAGE.fullmatch(variable.upper())
    return found[1] if found is not None else variable.upper()


def is_of_ros(name: str) -> bool:
    """Return whether the variables of a package are written by ament_package(), so that they begin with its name."""
    is_in_table = name in rows("cmake_targets.txt") and ROS_NAME.fullmatch(name) is not None
    is_other = name.endswith("_vendor") or name in OF_PLAIN_CMAKE
    return MESSAGES.fullmatch(name) is not None or (is_in_table and not is_other)
