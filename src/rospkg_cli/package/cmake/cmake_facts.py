"""The components that CMake registers, and the targets that it has and exports, for PackageFacts."""

from __future__ import annotations

from ...files import ReaderInput
from .build import is_built_with_cmake
from .cmake_project import CMake


def registered_components(reading: ReaderInput) -> tuple[frozenset[str], bool]:
    """Return the class names of the components of a package, and whether these are all."""
    if not is_built_with_cmake(reading):
        return frozenset(), True
    cmake = reading.parts(CMake).only
    if cmake is None:
        return frozenset(), False
    plugins = [component.plugin for component in cmake.components]
    known = frozenset(plugin.text for plugin in plugins if plugin.is_known)
    return known, cmake.is_complete and all(plugin.is_known for plugin in plugins)


def has_targets(reading: ReaderInput) -> bool:
    """Return whether a package has libraries or programs of its own, or may have such."""
    cmake = reading.parts(CMake).only
    return cmake is None or bool(cmake.targets) or not cmake.is_complete


def exported_targets(reading: ReaderInput) -> tuple[str, ...]:
    """Return the targets that a package exports, as others name them: `pkg::library`."""
    cmake = reading.parts(CMake).only
    if cmake is None:
        return ()
    exports = cmake.exports
    names = {text for call in exports for text in call.texts}
    spaces = [call.texts[call.texts.index("NAMESPACE") + 1] for call in exports if "NAMESPACE" in call.texts[:-1]]
    space = spaces[0] if spaces else f"{cmake.project_name}::"
    found = [
        f"{space}{cmake.export_names.get(word.text, word.text)}"
        for rule in cmake.installs
        if rule.export is not None and rule.export.text in names
        for word in rule.items
        if word.is_known
    ]
    return tuple(dict.fromkeys(found))
