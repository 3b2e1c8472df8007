"""What a CMake package exports by name: targets, libraries, and the packages that its users find with it."""

from __future__ import annotations

from functools import cached_property

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.values import UNKNOWN
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.workspace import Workspace
from .found_with import found_with

BY_MACRO = {
    "generate_parameter_library": frozenset(
        "fmt rclcpp rclcpp_lifecycle rsl tcb_span tl_expected parameter_traits generate_parameter_library".split()
    ),
    "rosidl_generate_interfaces": frozenset({"rosidl_default_runtime"}),
}
"""Macro → the packages that it exports itself."""


@dataclass(frozen=True)
class ExportedNames:
    cmake: CMake
    workspace: Workspace

    @cached_property
    def targets(self) -> frozenset[str]:
        """The names that are exported as targets."""
        exports = {text for call in self.cmake.exports for text in call.texts}
        rules = [rule for rule in self.cmake.installs if rule.export is not None and rule.export.text in exports]
        return frozenset(word.text for rule in rules for word in rule.items)

    @cached_property
    def libraries(self) -> frozenset[str]:
        """The libraries that are exported, for other packages to link."""
        old = {text for call in self.cmake.named("ament_export_libraries") if not call.folder for text in call.texts}
        named = self.targets | old
        targets = (self.cmake.target(name) for name in named)
        return frozenset(
            each.name for each in targets if each is not None and each.is_library and not each.call.testing
        )

    @cached_property
    def calls(self) -> tuple[EvaluatedCommand, ...]:
        return tuple(c for c in self.cmake.named("ament_export_dependencies") if not c.folder)

    @cached_property
    def packages(self) -> frozenset[str]:
        """The packages that are exported; UNKNOWN among them where one can't be evaluated."""
        names = {UNKNOWN if UNKNOWN in text else text for call in self.calls for text in call.texts}
        for each in self.cmake.interface_targets:
            names |= {UNKNOWN if UNKNOWN in word.text else word.text for word in each.dependencies}
        for name, brought in BY_MACRO.items():
            names |= brought if self.cmake.named(name) else frozenset()
        return frozenset(names)

    @cached_property
    def there(self) -> tuple[frozenset[str], bool]:
        """What is exported, directly or through another package, and whether that is known of all ROS packages."""
        return found_with(self.packages, self.workspace)
