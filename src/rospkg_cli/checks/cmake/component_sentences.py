"""Messages on components that no source registers, or whose target does not exist."""

from __future__ import annotations

from ...package.cmake.components import Component
from ...suggest import did_you_mean
from .component_registration import ComponentRegistration
from .registered_classes import MACRO


def unknown_class(components: ComponentRegistration, component: Component, full: str = "") -> str:
    """Return what is said of a class that no source registers; `full` is its name where CMake has another one."""
    names = [each.name for each in components.in_sources]
    name = component.plugin.text
    there = f"it is `{names[0]}` that is registered" if len(set(names)) == 1 else "they register others"
    near = did_you_mean(name, names) or f" ({there})" if names else ""
    fails = f'no source registers `{name}`{near}: loading it ends with "Failed to find class with the requested plugin'
    if full:
        return f'{fails} name"; the class is `{full}`: write `{MACRO}({full})`, and that name here'
    return f'{fails} name"; write `{MACRO}({name})`, or the right name'


def unknown_target(components: ComponentRegistration, component: Component) -> str:
    cmake, word = components.package.cmake, component.target
    near = did_you_mean(word.text, [target.name for target in cmake.targets])
    fault = f"nothing makes the target {cmake.quoted(word)}{near}: CMake stops"
    return f"{fault}; name the library that holds `{component.plugin.text}`"
