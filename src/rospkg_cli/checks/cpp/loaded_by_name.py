"""Rule input: the components of a package, and what loads one of them by its name (CMK108)."""

from __future__ import annotations

import re

from ...light_dataclasses import dataclass
from ...package.cmake.components import Component
from ..cmake.component_registration import ComponentRegistration
from ..cmake.registered_classes import RegisteredClass
from ..fault import Level
from ..made_classes import MadeClasses
from ..plugins.named_plugins import NamedPlugins


@dataclass(frozen=True)
class LoadedByName:
    registration: ComponentRegistration
    named: NamedPlugins
    made: MadeClasses

    def why_unmissed(self, name: str) -> str:
        """Return why nothing misses a class by its name: code makes it, and nothing here names it; "" for others."""
        return "" if self.is_named(name) else self.made.why_unloaded(name)

    def is_named(self, name: str) -> bool:
        """Return whether a launch file, YAML or code names a class as a text, or a command of a page loads it."""
        package, others = self.named.package.name, self.named.workspace.packages
        if any((package, name) in facts.loaded_components for facts in others) or self.named.is_named([name]):
            return True
        loads = re.compile(rf"\bcomponent[ \t]+(?:load|standalone)\b[^\n]*(?<![\w:]){re.escape(name)}(?![\w:])")
        return any(name in text and loads.search(text) for text in self.named.pages)

    def of_source(self, found: RegisteredClass) -> tuple[str, Level]:
        """Return what is said of a class that CMake does not register, and how bad it is."""
        level: Level = self.registration.harm(found)
        why = self.why_unmissed(found.name) if level != "error" else ""
        return f"{found.unregistered}{why}", "info" if why else level

    def of_cmake(self, component: Component, level: Level, full: str = "") -> tuple[str, Level]:
        """Return why a component that CMake registers and nothing can load is missed by few or none, and the level.

        The program that the command makes does nothing else than load it: it fails for who starts it. `full` is the
        name of the class where CMake has it with other namespaces.
        """
        is_asked = bool(full) and self.is_named(component.plugin.text)
        why = "" if is_asked else self.why_unmissed(full or component.plugin.text)
        if not why or level == "info" or self.is_started(component):
            return "", level
        return why, "warning" if component.executable is not None else "info"

    def is_started(self, component: Component) -> bool:
        """Return whether a launch file or a page starts the program that the command makes."""
        return component.executable is not None and self.is_program_started(component.executable.text)

    def is_program_started(self, name: str) -> bool:
        """Return whether a launch file or a page starts a program of the package."""
        package = self.named.package.name
        run = re.compile(rf"\bros2[ \t]+run[ \t]+{re.escape(package)}[ \t]+{re.escape(name)}(?![\w.-])")
        in_launch = bool(self.named.workspace.having("started_nodes", package, name))
        return in_launch or any(map(run.search, self.named.pages))
