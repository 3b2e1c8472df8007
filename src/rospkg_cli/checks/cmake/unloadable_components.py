"""Components that are registered of what can't be loaded: a program, or a library that is no shared one."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.cmake.targets import Target
from ...languages.cmake.values import Word
from ...light_dataclasses import dataclass
from ...package.cmake.components import Component
from ..fault import Level
from .component_registration import ComponentRegistration

STARTS = "rclcpp_components_register_node"
UNLOADED = {"STATIC": "a STATIC library", "OBJECT": "an OBJECT library", "INTERFACE": "an INTERFACE library"}


@dataclass(frozen=True)
class UnloadableComponent:
    component: Component
    what: str
    level: Level

    @property
    def is_itself(self) -> bool:
        """Whether the program that the command makes has the name of its target: CMake stops at the second one."""
        return self.component.executable is not None and self.component.executable.text == self.word.text

    @property
    def word(self) -> Word:
        return self.component.target

    @property
    def sentence(self) -> str:
        name, plugin = self.word.text, self.component.plugin.text
        fault = f"`{name}` is {self.what}, and components are loaded from shared libraries alone"
        executable = self.component.executable
        who = f"loading `{plugin}`, which `{executable.text}` does," if executable else f"loading `{plugin}`"
        return f"{fault}: {who} fails; add it to a library (`add_library(… SHARED …)`), and name that here"


def unloadable_components(registration: ComponentRegistration) -> Iterator[UnloadableComponent]:
    """Yield the first component of each such target.

    A class that no source registers is reported for that alone, except where the target is the program that the command
    itself makes. It is an error where the command makes a program, which does nothing else than load it.
    """
    cmake = registration.package.cmake
    if not cmake.is_complete:
        return
    reported = {component.plugin.text for component in registration.without_source()}
    seen: set[str] = set()
    for component in registration.sure():
        name = component.target.text
        made = [target for target in cmake.targets if target.name == name]
        kinds = {kind_of(target) for target in made}
        is_itself = component.executable is not None and component.executable.text == name
        is_reported = component.plugin.text in reported and not is_itself
        if len(kinds) != 1 or name in seen or is_reported or any(each.call.maybe for each in made):
            continue
        seen.add(name)
        if what := kinds.pop():
            loads = component.call.name == STARTS or is_loaded(registration, component)
            yield UnloadableComponent(component, what, "error" if loads else "warning")


def kind_of(target: Target) -> str:
    """Return what a target is, of one that can't be loaded; "" of others, and where that is open."""
    if target.is_executable:
        return "a program"
    found = [what for option, what in UNLOADED.items() if option in target.options and target.is_library]
    return found[0] if found else ""


def is_loaded(registration: ComponentRegistration, component: Component) -> bool:
    facts = registration.package.facts
    return (facts.name, component.plugin.text) in facts.loaded_components
