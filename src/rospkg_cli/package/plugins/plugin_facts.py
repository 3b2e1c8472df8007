"""The plugins of a package for PackageFacts."""

from __future__ import annotations

from ...files import ReaderInput
from ..cmake.cmake_project import CMake
from ..plugin import Plugin
from .description import PluginDescription
from .loaders import PluginLoaders
from .read_descriptions import EXPORT, by_cmake


def loaded_bases(reading: ReaderInput) -> tuple[frozenset[tuple[str, str]], bool]:
    """Return what a package loads, as PackageFacts has it, and whether that is all."""
    loaders = reading.parts(PluginLoaders).only or PluginLoaders()
    return frozenset(each.names for each in loaders.loaders), loaders.is_complete


def described_plugins(reading: ReaderInput) -> tuple[tuple[Plugin, ...], bool]:
    """Return the plugins that a package describes, and whether these are all."""
    plugins = [plugin for each in reading.parts(PluginDescription).good for plugin in plugins_of(each)]
    return tuple(plugins), are_complete(reading)


def plugins_of(description: PluginDescription) -> list[Plugin]:
    return [
        Plugin(
            each.lookup_name,
            each.type.value,
            each.base.value,
            description.bases,
            description.file,
            (each.name or each.type).value_span,
        )
        for each in description.classes
        if description.exported
    ]


def are_complete(reading: ReaderInput) -> bool:
    """Return whether every description that CMake exports is known, is there, and can be read, and no other is here.

    A description that nothing exports has a finding of its own, and its plugins can't be found.
    """
    if reading.parts(PluginDescription).broken or reading.parts(CMake).broken:
        return False
    from .other_exports import is_registered  # few packages have plugins

    if any(map(is_registered, reading.parts(CMake).good)):
        return False
    if any(each.classes and not each.exported for each in reading.parts(PluginDescription).good):
        return False
    exported = [path for path, _ in by_cmake(reading)]
    calls = sum(len(cmake.named(EXPORT)) for cmake in reading.parts(CMake).good)
    complete = all(cmake.is_complete for cmake in reading.parts(CMake).good)
    return complete and len(exported) == calls and all(map(reading.files.exists, exported))
