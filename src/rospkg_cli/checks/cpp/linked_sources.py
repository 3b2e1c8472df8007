"""Sources that the build certainly compiles and links: the linker stops where they use what is not defined."""

from __future__ import annotations

from functools import cached_property

from ...light_dataclasses import dataclass
from ...package.cmake.target_links import TargetLinks
from ..cmake.source_targets import SourceTargets
from ..depends.compiled_sources import certainly_compiled
from ..depends.header_inclusions import HEADERS
from .other_builds import has_built_libraries
from .uncompiled_sources import UncompiledSources


@dataclass(frozen=True)
class LinkedSources:
    sources: UncompiledSources

    def has(self, path: str) -> bool:
        """Return whether a file is certainly part of a program or a shared library, a header that it includes too.

        A compiled library that lies in the package may define what is used, and a target that stops at a source of
        ROS 1 is never linked.
        """
        is_linked = path.endswith(HEADERS) or not self.linked.isdisjoint(self.targets.targets_of(path))
        is_certain = path in self.certain and self.sources.ros1.stopping_all([path]) is None
        return is_linked and is_certain and not self.are_built

    @cached_property
    def linked(self) -> frozenset[str]:
        """The targets for which a linker runs, or what they are made of does: nothing runs for a lone static one."""
        cmake = self.sources.package.cmake
        links = TargetLinks(cmake)
        made = (target for target in cmake.targets if target.is_built and not target.call.maybe)
        return frozenset(
            each.name for each in made if each.is_executable or links.shared(each) or bool(links.with_word(each.name))
        )

    @cached_property
    def certain(self) -> set[str]:
        return certainly_compiled(self.sources.package.cmake, self.sources.sources)

    @cached_property
    def are_built(self) -> bool:
        return has_built_libraries(self.sources.package.cmake.package_files)

    @cached_property
    def targets(self) -> SourceTargets:
        return SourceTargets(self.sources.package.cmake)
