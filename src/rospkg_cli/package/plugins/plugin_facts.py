"""The plugins of a package for PackageFacts."""

from __future__ import annotations

from typing import NamedTuple

from ...files import ReaderInput
from ..cmake.cmake_project import CMake
from ..package_facts import Plugin, PluginUse, UnknownField
from .description import PluginDescription
from .loaders import PluginLoaders
from .plugin_uses import plugin_uses
from .read_descriptions import EXPORT, by_cmake


class PluginFacts(NamedTuple):
    plugins: tuple[Plugin, ...]
    uses: tuple[PluginUse, ...]
    loaders: frozenset[tuple[str, str]]
    unknown: frozenset[UnknownField]


def plugin_facts(reading: ReaderInput) -> PluginFacts:
    unknown: set[UnknownField] = set()
    loaders = reading.parts(PluginLoaders).only or PluginLoaders()
    unknown |= set() if loaders.is_complete else {"loaders"}
    unknown |= set() if are_complete(reading) else {"plugins"}
    plugins = [plugin for each in reading.parts(PluginDescription).good for plugin in plugins_of(each)]
    names = frozenset(each.names for each in loaders.loaders)
    return PluginFacts(tuple(plugins), plugin_uses(reading), names, frozenset(unknown))


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
    """Return whether every description that CMake exports is known, is there, and can be read."""
    if reading.parts(PluginDescription).broken or reading.parts(CMake).broken:
        return False
    exported = [path for path, _ in by_cmake(reading)]
    calls = sum(len(cmake.named(EXPORT)) for cmake in reading.parts(CMake).good)
    complete = all(cmake.is_complete for cmake in reading.parts(CMake).good)
    return complete and len(exported) == calls and all(map(reading.files.exists, exported))
