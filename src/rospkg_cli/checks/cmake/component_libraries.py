"""Sources of installed libraries, by whether components are registered of these, or something links them."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cached_property

from ...languages.cmake.evaluated_command import path_in_package
from ...languages.cmake.targets import Target
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.cmake.target_links import TargetLinks


@dataclass(frozen=True)
class ComponentLibraries:
    cmake: CMake

    @cached_property
    def loaded(self) -> frozenset[str]:
        """The sources of the libraries that components are registered of, and of those that nothing links."""
        names = {component.target.text for component in self.cmake.components}
        targets = [target for name in names if (target := self.cmake.target(name)) is not None]
        links = TargetLinks(self.cmake)
        return sources_of([*targets, *(each for each in self.installed if not links.with_word(each.name))])

    @cached_property
    def linked(self) -> frozenset[str]:
        """The sources of libraries that a target of the package links: a program may make nodes of their classes."""
        return sources_of(self.installed) - self.loaded

    @cached_property
    def installed(self) -> tuple[Target, ...]:
        """The libraries that are certainly installed and not static."""
        installed = TargetLinks(self.cmake).installed
        return tuple(
            each
            for each in self.cmake.targets
            if each.is_library and each.is_built and each.name in installed
            if not (each.call.maybe or each.call.testing or each.options & {"STATIC"})
        )


def sources_of(targets: Iterable[Target]) -> frozenset[str]:
    """Return the paths of the sources of some targets."""
    return frozenset(p for t in targets for w in t.sources if (p := path_in_package(w.text, t.call.folder)))
