"""What CMK108 says of components that can't be loaded, by who misses them."""

from __future__ import annotations

from collections.abc import Iterator

from ..checks.cmake.component_registration import ComponentRegistration
from ..checks.cmake.component_sentences import unknown_class
from ..checks.cmake.misread_keywords import misread_keywords
from ..checks.cmake.unloadable_components import unloadable_components
from ..checks.cpp.components_elsewhere import components_elsewhere
from ..checks.cpp.defined_classes import defined_as
from ..checks.cpp.loaded_by_name import LoadedByName
from ..finding import Hit, Related, Severity
from ..package.cmake.components import Component
from ..suggest import nearest
from .same_infos import same_infos_once


def of_keywords(loaded: LoadedByName) -> Iterator[Hit]:
    """Yield a hit for each command that takes keywords for classes; a program that it does not make may be missed."""
    for each in misread_keywords(loaded.registration.package):
        is_started = bool(each.program) and loaded.is_program_started(each.program)
        is_missed = each.asks and is_started and not each.is_made
        level = Severity.WARNING if is_missed else Severity.INFO
        yield Hit(each.word.path, each.word.span, each.sentence(is_started=is_started), level)


def of_sources(loaded: LoadedByName) -> Iterator[Hit]:
    """Yield a hit for each class that a source registers and CMake does not."""
    found = ((each, *loaded.of_source(each)) for each in loaded.registration.without_cmake())
    yield from same_infos_once((Hit(e.path, e.span, message, Severity(level)) for e, message, level in found), "")


def of_names(loaded: LoadedByName) -> Iterator[Hit]:
    """Yield a hit for each class that CMake registers and no source does; a slip of a name is one for everybody."""
    components = loaded.registration
    for each in components.without_source():
        related = meant(components, each)
        full = "" if related else defined_as(each.plugin.text, components.sources)
        why, level = ("", "error") if related else loaded.of_cmake(each, "error", full)
        message = unknown_class(components, each, full)
        yield Hit(each.plugin.path, each.plugin.span, message + why, Severity(level), related)


def of_libraries(loaded: LoadedByName) -> Iterator[Hit]:
    """Yield a hit for each component that is registered of what does not have it, or of what nothing loads."""
    for found in unloadable_components(loaded.registration):
        why, level = ("", found.level) if found.is_itself else loaded.of_cmake(found.component, found.level)
        yield Hit(found.word.path, found.word.span, found.sentence + why, Severity(level))
    for other in components_elsewhere(loaded.registration):
        why, level = loaded.of_cmake(other.component, "warning" if other.is_loaded_by_another else "error")
        plugin = other.component.plugin
        yield Hit(plugin.path, plugin.span, other.sentence + why, Severity(level))


def meant(components: ComponentRegistration, component: Component) -> tuple[Related, ...]:
    found = nearest(component.plugin.text, [each.name for each in components.in_sources])
    return tuple(
        Related(each.path, each.span, "this one is registered") for each in components.in_sources if each.name == found
    )
