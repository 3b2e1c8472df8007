"""Types of other packages in interface files that package.xml does not declare (DEP108)."""

from __future__ import annotations

from ...light_dataclasses import dataclass
from ...package.interfaces.interface_file import InterfaceFile
from ...source import Span
from ...suggest import near_names
from ..interfaces.package_interfaces import InterfaceGeneration
from .declared_dependencies import DeclaredDependencies
from .name_source import source_of

OF_ACTIONS, CANCELS = "action_msgs", "action_msgs/srv/CancelGoal"
"""The package of what every action is made of, and its service."""


@dataclass(frozen=True, slots=True)
class InterfaceTypeUse:
    path: str
    span: Span
    type: str


@dataclass(frozen=True)
class InterfaceTypeDependencies:
    declared: DeclaredDependencies
    interfaces: tuple[InterfaceFile, ...]
    generation: InterfaceGeneration

    def undeclared(self) -> dict[str, list[InterfaceTypeUse]]:
        """Return the packages whose types are used and which are not declared, with the places."""
        found: dict[str, list[InterfaceTypeUse]] = {}
        for interface in self.interfaces if self.is_generated else ():
            for each in interface.types if self.generation.may_read(interface.path) else ():
                if each.package and not self.declared.has([each.package]):
                    use = InterfaceTypeUse(interface.path, each.base_span, f"{each.package}/{each.base}")
                    found.setdefault(each.package, []).append(use)
            if interface.path.endswith(".action") and self.comes_with_generators(OF_ACTIONS):
                found.setdefault(OF_ACTIONS, []).append(InterfaceTypeUse(interface.path, Span(0, 0), CANCELS))
        return found

    def comes_with_generators(self, package: str) -> bool:
        """Return whether generated code uses a package that others bring; without generators XML305 reports it."""
        return not self.declared.has([package]) and self.declared.bringer([package], runs=False) is not None

    def intended(self, package: str) -> str | None:
        """Return the one declared dependency whose name is a letter or two off that of an unknown package."""
        if source_of(self.declared, package) != "unknown":
            return None
        near = near_names(package, (each.name for each in self.declared.manifest.dependencies))
        return near[0] if len(near) == 1 else None

    @property
    def is_generated(self) -> bool:
        return self.declared.is_checked and self.declared.facts.build_type != "ament_python"
