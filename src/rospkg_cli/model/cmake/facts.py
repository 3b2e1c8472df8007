"""What other packages may know of the components that CMake registers."""

from __future__ import annotations

from ..files import Reading
from .project import CMake
from .read import is_built_with_cmake


def registered_components(reading: Reading) -> tuple[frozenset[str], bool]:
    """Return the class names of the components of a package, and whether these are all."""
    if not is_built_with_cmake(reading):
        return frozenset(), True
    cmake = reading.parts(CMake).only
    if cmake is None:
        return frozenset(), False
    plugins = [component.plugin for component in cmake.components]
    known = frozenset(plugin.text for plugin in plugins if plugin.known)
    return known, cmake.complete and all(plugin.known for plugin in plugins)
