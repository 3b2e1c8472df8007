"""Rule input: who meets a fault in what a package exports: a package here that stops at it, or others elsewhere."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator
from functools import cached_property

from ...files import PackageFiles
from ...light_dataclasses import dataclass
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ...ros.aliases import keys_for_cmake
from ...ros.manifest import BUILDS
from ..pages_and_scripts import pages_and_scripts
from ..released import Release
from .found_with import built_against, found_with

BUILD = ("build_depend",)
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
    def including(self) -> tuple[PackageFacts, ...]:
        """Those that certainly include a header of include/ and have no copy of it: they stop without it."""
        offered = {path.removeprefix(OFFERED) for path in self.files.below(OFFERED)}
        return tuple(each for each in self.builders if offered & each.included_headers - each.header_files)

    def lacking(self, name: str) -> Iterator[PackageFacts]:
        """Yield those that include a header, and certainly find a package in no other way than by this one."""
        wanted = {name, name.lower(), *keys_for_cmake(name)}
        for each in self.including:
            needs = {need.name for need in each.dependencies if need.tag in BUILDS} - {self.facts.name}
            there, known = found_with(needs, self.workspace)
            if known and wanted.isdisjoint(there):
                yield each

    def lack_any(self, names: Collection[str]) -> bool:
        """Return whether one of them lacks a package that this one does not hand on."""
        return any(True for name in names for _ in self.lacking(name))

    @cached_property
    def are_elsewhere(self) -> bool:
        """Whether the package is plainly a library for others, and nobody here is built against it.

        It is released and its pages say how to use it, or all packages of its repository are libraries.
        """
        if self.builders or not self.is_library(self.facts):
            return False
        return all(map(self.is_library, self.release.neighbours)) or (self.release.is_made and self.is_shown)

    def is_library(self, facts: PackageFacts) -> bool:
        """Return whether a package has nothing that is started."""
        return facts.knows("executables") and not facts.executables and not facts.launch_files

    @property
    def is_shown(self) -> bool:
        """Whether a page tells others how to use the package."""
        name = re.escape(self.facts.name)
        use = re.compile(rf"find_package\(\s*{name}\b|#include\s*[<\"]{name}/|depend>\s*{name}\s*<")
        return any(use.search(text) for text in pages_and_scripts(self.files))
