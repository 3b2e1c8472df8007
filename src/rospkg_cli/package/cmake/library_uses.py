"""What does not work without a shared library of the package: components, installed targets, other packages."""

from __future__ import annotations

from functools import cached_property

from ...languages.cmake.targets import Target
from ...languages.cmake.values import BINARY
from ...light_dataclasses import dataclass
from .cmake_project import CMake
from .installed_headers import HEADERS
from .target_links import TargetLinks
from .uninstalled_target import TargetUse

RPATHS = frozenset({"CMAKE_INSTALL_RPATH", "INSTALL_RPATH"})


@dataclass(frozen=True)
class LibraryUses:
    cmake: CMake
    links: TargetLinks

    def has_code(self, target: Target) -> bool:
        """Return whether there may be more in a library than headers: the linker drops an empty one."""
        only = bool(target.sources) and all(word.is_known and word.text.endswith(HEADERS) for word in target.sources)
        return not only or target.name in self.added_to

    @cached_property
    def added_to(self) -> frozenset[str]:
        """The targets that get sources of target_sources."""
        return frozenset(text for call in self.cmake.named("target_sources") for text in call.texts[:1])

    def needed_by(self, target: Target) -> TargetUse | None:
        """Return what does not work where a library is not installed; None where all does."""
        if not self.links.shared(target) or not self.has_code(target):
            return None
        if target.name in self.promised and target.name not in self.plugins:
            return TargetUse("exporter")
        return self.loaded_by(target)

    def loaded_by(self, target: Target) -> TargetUse | None:
        """Return what can't start without a library: a component of it, or an installed target linked with it."""
        if (plugin := self.plugins.get(target.name)) is not None:
            return TargetUse("component", plugin)
        for link in self.links.with_word(target.name):
            if link.target in self.links.installed and not link.package and not self.runs_from_build:
                return TargetUse("linked target", link.target)
        return None

    @cached_property
    def runs_from_build(self) -> bool:
        """Whether installed programs look for libraries in the build folder, too, by an RPATH that CMake sets."""
        calls = self.cmake.named("set", "set_target_properties", "set_property")
        return any(RPATHS.intersection(call.texts) and any(BINARY in text for text in call.texts) for call in calls)

    @cached_property
    def plugins(self) -> dict[str, str]:
        """Target → the first component that is registered of it."""
        return {each.target.text: each.plugin.text for each in reversed(self.cmake.components)}

    @cached_property
    def promised(self) -> frozenset[str]:
        """The libraries that `ament_export_libraries` exports to other packages."""
        return frozenset(text for call in self.cmake.named("ament_export_libraries") for text in call.texts)
