"""Headers that a package exports: whether they are installed, and the packages whose headers they include."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...languages.cmake.evaluated_command import EvaluatedCommand, path_in_package
from ...languages.cpp.file import CppFile, IncludeDirective
from ...light_dataclasses import dataclass
from ..install_table import InstallTable
from .cmake_package import CMakePackage

HEADERS = (".hpp", ".h", ".hh", ".hxx")
INCLUDES = ("ament_export_include_directories",)
TARGETS = ("ament_export_targets", "ament_export_interfaces")
LIBRARIES = "ament_export_libraries"
PLUGINS = "pluginlib_export_plugin_description_file"
INTERFACE = "_INTERFACE:"
REGISTERS = ("PLUGINLIB_EXPORT_CLASS", "CLASS_LOADER_REGISTER_CLASS")


@dataclass(frozen=True)
class PublicHeaders:
    package: CMakePackage
    table: InstallTable
    sources: tuple[CppFile, ...]

    @cached_property
    def exports(self) -> tuple[EvaluatedCommand, ...]:
        """The calls that export headers to other packages; the targets of a plugin are exported for other reasons."""
        cmake = self.package.cmake
        is_for_others = not cmake.named(PLUGINS) or self.exports_plain_library
        names = (*INCLUDES, *TARGETS) if is_for_others else INCLUDES
        return tuple(call for call in cmake.named(*names) if not call.testing and not call.maybe and not call.folder)

    @property
    def exports_plain_library(self) -> bool:
        """Whether a set of targets has a library that registers no plugin and names a folder of headers for users."""
        cmake = self.package.cmake
        words = [word for rule in cmake.installs if rule.kind == "TARGETS" and rule.export for word in rule.items]
        telling = {
            call.texts[0] for call in cmake.named("target_include_directories") if INTERFACE in "".join(call.texts)
        }
        targets = [cmake.target(word.text) for word in words if word.text in telling]
        registering = {file.path for file in self.sources if any(file.calls_to(*REGISTERS))}
        return any(
            each.is_library
            and registering.isdisjoint(path_in_package(w.text, each.call.folder) or "" for w in each.sources)
            for each in targets
            if each is not None
        )

    @cached_property
    def offered(self) -> tuple[str, ...]:
        """The headers in include/, relative to the package."""
        return tuple(path for path in self.package.cmake.package_files.below("include") if path.endswith(HEADERS))

    @property
    def installed(self) -> frozenset[str]:
        return frozenset(row.source for row in self.table.rows if row.source.endswith(HEADERS))

    def are_uninstalled(self) -> bool:
        """Return whether headers are offered and none of them is installed."""
        unclear = not self.table.knows("header") or not self.package.cmake.is_complete
        automatic = self.package.cmake.named("ament_auto_package", "autoware_ament_auto_package")
        if unclear or automatic or not self.offered or not self.exports:
            return False
        return not self.installed.intersection(self.offered)

    def leading_to(self, package: str) -> frozenset[str]:
        """Return the headers of include/, as others include them, that include headers of a package, at second hand
        too."""
        own = {file.path: file for file in self.sources if file.path in self.offered}
        reached = {file.path for file, _, name in self.included_packages() if name == package}
        waiting = [*reached]
        while waiting:
            ending = waiting.pop().rpartition("/")[2]
            named = ((path, each.path.rpartition("/")[2]) for path, file in own.items() for each in file.includes)
            more = {path for path, name in named if name == ending}
            waiting += more - reached
            reached |= more
        return frozenset(path.removeprefix("include/") for path in reached)

    def included_packages(self) -> Iterator[tuple[CppFile, IncludeDirective, str]]:
        """Yield what public headers include by a package's name: `<rclcpp/rclcpp.hpp>`."""
        for file in self.sources:
            if file.path in self.installed:
                for include in file.includes:
                    if "/" in include.path and not include.is_conditional:
                        yield file, include, include.path.partition("/")[0]
