"""What the build does with the files that include a package: compile, install, or leave to an option."""

from __future__ import annotations

from functools import cached_property

from ...files import PackageFiles
from ...languages.cpp.file import CppFile
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.install_table import InstallTable
from .compiled_sources import certainly_compiled, compiled_on_demand, own_compiled
from .declared_dependencies import DeclaredDependencies
from .included_packages import IncludedPackage


@dataclass(frozen=True)
class IncludingFiles:
    declared: DeclaredDependencies
    files: PackageFiles
    cmake: CMake
    sources: tuple[CppFile, ...]
    table: InstallTable

    def are_passed_on(self, each: IncludedPackage) -> bool:
        """Return whether only headers for other packages include it: the build of this package opens none of them."""
        known = self.compiled if each.role != "test" else None
        return known is not None and known.isdisjoint(use.path for use in each.uses)

    def are_idle(self, each: IncludedPackage) -> bool:
        """Return whether nothing compiles a file that includes it: neither this package nor one that builds against it.

        A header that is only installed counts where a package of the workspace includes one of this package's headers.
        """
        installed = {row.source for row in self.table.of("header")}
        is_seen = not self.compiled and not installed.isdisjoint(use.path for use in each.uses)
        name, needing = self.declared.facts.name, self.declared.workspace.needing(self.declared.facts.name)
        is_seen = is_seen and self.declared.workspace.is_built_against(name)
        is_seen = is_seen and any(self.offered & facts.included_headers - facts.header_files for facts in needing)
        return self.are_passed_on(each) and not is_seen

    @cached_property
    def offered(self) -> frozenset[str]:
        """The headers of include/, as other packages include them: `my_pkg/node.hpp`."""
        return frozenset(path.removeprefix("include/") for path in self.files.below("include/"))

    @cached_property
    def compiled(self) -> set[str] | None:
        """The files that the package's own build opens; None where unknown."""
        return own_compiled(self.cmake, self.sources)

    def are_optional(self, each: IncludedPackage) -> bool:
        """Return whether only files include it that are compiled under a condition, such as an option that is off."""
        return all(use.path in self.on_demand for use in each.uses)

    @cached_property
    def on_demand(self) -> set[str]:
        """The files that are compiled under a condition alone."""
        return compiled_on_demand(self.cmake, self.sources)

    def are_for_ros1(self, each: IncludedPackage) -> bool:
        """Return whether package.xml declares it for ROS 1 alone, and no build certainly compiles what includes it."""
        declared = {one.name for one in self.declared.manifest.dependencies if one.condition}
        is_left = declared.intersection(each.names) and not self.declared.has(each.names)
        return bool(is_left) and self.certain.isdisjoint(use.path for use in each.uses)

    @cached_property
    def certain(self) -> set[str]:
        return certainly_compiled(self.cmake, self.sources)
