"""Plug-ins of rqt: those in Python are found by package.xml alone, those in C++ by what CMake exports."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from ..manifest import Manifest
from ..uses.roles import role_of
from .description import PluginDescription

PYTHON = ("rqt_gui_py::", "qt_gui_py::")
CPP = "rqt_gui_cpp::"


@dataclass(frozen=True)
class RqtPlugins:
    manifest: Manifest
    descriptions: tuple[PluginDescription, ...]

    def hidden(self) -> Iterator[PluginDescription]:
        """Yield the descriptions of plug-ins in Python that package.xml does not export, and so nobody finds."""
        exported = {each.type.value for one in self.descriptions if one.for_rqt for each in one.classes}
        for description in self.descriptions:
            types = {each.type.value for each in description.classes if each.base.value.startswith(PYTHON)}
            if types and not description.for_rqt and not types & exported and role_of(description.file) == "run":
                yield description

    def odd(self) -> Iterator[tuple[PluginDescription, list[PluginDescription]]]:
        """Yield the descriptions in C++ that CMake alone exports, where package.xml has all others of the package."""
        cpp = [
            each
            for each in self.descriptions
            if each.indexed and any(found.base.value.startswith(CPP) for found in each.classes)
        ]
        listed = [each for each in cpp if each.for_rqt]
        for description in cpp:
            if listed and not description.for_rqt:
                yield description, listed
