"""Rule input: which packages a fault in the exports of a package breaks: packages here, or others elsewhere."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator
from functools import cached_property

from ...files import PackageFiles
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_facts import ANY
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ...ros.aliases import keys_for_cmake
from ...ros.manifest import BUILDS
from ..repository.pages_and_scripts import pages_and_scripts
from ..repository.released import Release
from .found_with import built_against, found_with
from .known_packages import is_known_package

BUILD = ("build_depend",)
TOOLS = "ament_"
"""What the tools of ament begin with, which find no package for others."""
OFFERED = "include/"
"""The folder of headers for others."""


@dataclass(frozen=True)
class Consumers:
    facts: PackageFacts
    workspace: Workspace
    files: PackageFiles
    release: Release

    @cached_property
    def builders(self) -> tuple[PackageFacts, ...]:
        """The packages of the workspace that have targets of their own and depend on this one to build.

        One that compiles nothing (a bringup with a `<depend>`) does not build against it, whatever it declares.
        """
        name = self.facts.name
        needing = (each for each in self.workspace.needing(name) if each.is_ament and each.is_compiled)
        return tuple(each for each in needing if name in built_against(each, *BUILD))

    @cached_property
    def finders(self) -> tuple[PackageFacts, ...]:
        """Those whose CMake looks for this package, as not all do that declare it: they stop where finding it does."""
        wanted = (self.facts.name, ANY)
        return tuple(each for each in self.builders if not each.sought_packages.isdisjoint(wanted))

    @cached_property
    def including(self) -> tuple[PackageFacts, ...]:
        """Those of them that certainly include a header of include/ and have no copy of it: they stop without it."""
        offered = {path.removeprefix(OFFERED) for path in self.files.below(OFFERED)}
        return tuple(each for each in self.finders if offered & each.included_headers - each.header_files)

    def lacking(self, name: str) -> Iterator[PackageFacts]:
        """Yield those that include a header, and certainly find a package in no other way than by this one."""
        wanted = {name, name.lower(), *keys_for_cmake(name)}
        yield from (each for each in self.including if self.lacks(each, wanted))

    def lacks(self, user: PackageFacts, names: Collection[str]) -> bool:
        """Return whether a package certainly finds none of `names`, in whatever else it declares or looks for.

        An unknown package may find anything. One of the workspace that looks for them itself may do so
        for others, too, unless it certainly keeps them for itself: it may write its own config.
        """
        declared = {need.name for need in user.dependencies if need.tag in BUILDS}
        needs = {name for name in declared | user.sought_packages if not name.startswith(TOOLS)}
        needs -= {self.facts.name, ANY}
        there, known = found_with(needs, self.workspace)
        is_all = all(is_known_package(name, self.workspace) for name in needs)
        return known and is_all and there.isdisjoint(names) and not self.may_hand_on(there, names)

    def may_hand_on(self, found: Collection[str], names: Collection[str]) -> bool:
        """Return whether a package of the workspace, other than this one, may find some of `names` for its users."""
        others = (self.workspace.named(name) for name in found if name != self.facts.name)
        sought = (each.sought_packages - each.kept_links for each in others if each is not None and each.is_ament)
        return any(not each.isdisjoint((*names, ANY)) for each in sought)

    def lack_any(self, names: Collection[str]) -> bool:
        """Return whether a package that includes a header lacks one of `names`, which this one does not export."""
        return any(True for name in names for _ in self.lacking(name))

    @cached_property
    def are_elsewhere(self) -> bool:
        """Whether no package here is built against this one, but others are: it is a library without programs, it is
        released, and its pages say how to use it."""
        return not self.builders and self.is_library(self.facts) and self.release.is_made and self.is_shown

    def is_library(self, facts: PackageFacts) -> bool:
        """Return whether a package has nothing that is started."""
        return facts.knows("executables") and not facts.executables and not facts.launch_files

    @property
    def is_shown(self) -> bool:
        """Whether a page shows how to use the package."""
        name = re.escape(self.facts.name)
        use = re.compile(rf"find_package\(\s*{name}\b|#include\s*[<\"]{name}/|depend>\s*{name}\s*<")
        return any(use.search(text) for text in pages_and_scripts(self.files))
