"""Rule input: packages inside a package, below which colcon does not look. (colcon-recursive-crawl)"""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from functools import cached_property
from typing import Literal

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.file_role import is_set_aside, role_of
from ...package.install_table import InstallTable
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from .wanted_packages import WantedPackages

MARKERS = ("COLCON_IGNORE", "AMENT_IGNORE", "CATKIN_IGNORE")
COPIES = frozenset("fixtures resource resources example examples thirdparty 3rdparty external extern".split())
"""Folders of packages that are there to be read or copied."""
Way = Literal["built", "started", "carried", "by hand", "idle", "none"]
FOR_ROS2 = regex(r"<build_type>\s*(?:ament_\w+|cmake)\b")
NAME = regex(r"<name>\s*([\w-]+)")


@dataclass(frozen=True)
class NestedPackages:
    package: PackageFacts
    files: PackageFiles
    table: InstallTable | None
    workspace: Workspace
    cmake: CMake | None

    def manifests(self) -> Iterator[str]:
        """Yield the package.xml of the packages inside, the outermost of each folder, that should be built."""
        outer: list[str] = []
        every = (path for path in self.files.every if path.endswith("/package.xml"))
        for path in sorted(every, key=posixpath.dirname) if self.package.build_type != "catkin" else ():
            folder = posixpath.dirname(path)
            if folder.startswith(tuple(outer)):
                continue
            outer.append(f"{folder}/")
            if role_of(path) not in ("test", "aside") and not self.is_set_aside(folder) and self.is_manifest(path):
                yield path

    def is_set_aside(self, folder: str) -> bool:
        """Return whether a marker, .gitignore or the folder's name says that it is not to be built, or it is data."""
        parts = folder.split("/")
        above = ("/".join(parts[:end]) for end in range(1, len(parts) + 1))
        marked = any(self.files.has_file(f"{each}/{marker}") for each in above for marker in MARKERS)
        installed = self.table is not None and any(row.source == f"{folder}/package.xml" for row in self.table.rows)
        is_left = is_set_aside(f"{folder}/") or not COPIES.isdisjoint(map(str.lower, parts))
        return marked or installed or is_left or self.files.absent.is_ignored(folder)

    def is_manifest(self, path: str) -> bool:
        return "<package" in self.files.readable_text(path)

    def should_be_built(self, path: str) -> bool:
        """Return whether a package is one for colcon: for ROS 2, in no hidden folder, with a name of its own."""
        text = self.files.readable_text(path)
        is_for_ros1 = "catkin" in text and "ament" not in text
        name = NAME.search(text)
        is_copy = name is not None and name[1] in self.workspace.names
        return not is_for_ros1 and not is_copy and not any(part.startswith(".") for part in path.split("/"))

    def ways(self) -> dict[Way, list[str]]:
        """Return the packages by how they are built; those that nothing needs follow one that something needs."""
        found: dict[Way, list[str]] = {}
        for path in self.manifests():
            found.setdefault(self.way_of(path), []).append(path)
        if "none" in found:
            found["none"] += found.pop("idle", [])
        return found

    def way_of(self, path: str) -> Way:
        """Return how a package gets built: by the outer one, or where pages start colcon below it, bring it, or
        build it without colcon; else whether something needs it ("none") or nothing does ("idle")."""
        from .built_places import is_built_from  # few packages have another one inside
        from .carried_folders import is_carried
        from .hand_builds import is_built_by_hand

        folder = posixpath.dirname(path)
        if self.is_built_here(path):
            return "built"
        if is_built_from(self.files, folder):
            return "started"
        if is_carried(self.files, folder):
            return "carried"
        if is_built_by_hand(self.wanted.pages, folder):
            return "by hand"
        return "none" if self.should_be_built(path) and self.is_wanted(path) else "idle"

    def is_wanted(self, path: str) -> bool:
        """Return whether a package of ROS 2 is depended on, used, built or run by its name."""
        text = self.files.readable_text(path)
        name = NAME.search(text)
        return bool(FOR_ROS2.search(text)) and name is not None and self.wanted.has(name[1])

    @cached_property
    def wanted(self) -> WantedPackages:
        return WantedPackages(self.files, self.workspace)

    def is_built_here(self, path: str) -> bool:
        """Return whether the CMake of the outer package builds the folder of a package.xml, or one inside of it."""
        folder = posixpath.dirname(path)
        return any(f"{each}/".startswith(f"{folder}/") for each in self.built_folders)

    @cached_property
    def built_folders(self) -> frozenset[str]:
        if self.cmake is None:
            return frozenset()
        from .cmake_folders import named_folders  # a package without CMake needs no commands of it

        return named_folders(self.cmake)
