"""setup.py as rules see it: the arguments of setup(), merged with setup.cfg as setuptools merges them."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property

from ...languages.python.evaluate.conversion import unknowns
from ...languages.python.evaluate.values import Call, GlobResult, Text, Unknown, Value
from ...languages.python.evaluate.values import Mapping as MappingValue
from ...light_dataclasses import dataclass
from ...source import Span
from . import data_files, entry_points
from .data_files import DataEntry, DataFile
from .entry_point import EntryPoint
from .file_writing_calls import GENERATORS, may_write
from .find_packages import PackageSearch
from .setup_modules import SetupModules
from .setup_text import SetupText

ARGUMENTS = (
    "name version packages py_modules package_dir package_data scripts data_files entry_points extras_require"
    " tests_require install_requires cmdclass"
).split()
"""The arguments of setup() that rules and the install table use."""


@dataclass(frozen=True)
class SetupPy(SetupModules):
    calls: tuple[Call, ...]
    """Every call in setup.py that was not evaluated."""
    globs: tuple[GlobResult, ...]
    searches: tuple[PackageSearch, ...]
    """Every find_packages()."""
    names: Mapping[str, Value]
    """The values of the names of setup.py at its end."""
    cwd: str
    """The folder that relative paths start from, when setup() is called."""

    def used_elsewhere(self, setup_text: SetupText) -> bool:
        """Return whether a text is written outside of the call of setup(), in a variable that other code may use."""
        return self.call is None or not self.call.span.start < setup_text.span.start < self.call.span.end

    @property
    def has_test_extras(self) -> bool:
        """Whether colcon finds the tests' requirements in extras_require, or may find them."""
        if not self.knows("extras_require"):
            return True
        value = self.value("extras_require")
        keys = {str(key) for key in value.items} if isinstance(value, MappingValue) else self.from_cfg.extras
        return bool(keys & {"test", "tests", "testing"})

    def knows(self, name: str) -> bool:
        """Return whether everything that the argument holds could be evaluated."""
        return name not in self.unknown

    @cached_property
    def unknown(self) -> Mapping[str, Unknown]:
        """Why an argument could not be evaluated, or not all of it."""
        found: dict[str, Unknown] = {}
        for name in ARGUMENTS:
            value = self.value(name)
            reasons = (
                list(unknowns(value)) if value is not None else [u for u in [self.may_be_given_elsewhere(name)] if u]
            )
            if isinstance(value, Call):
                reasons = [Unknown(value.span, f"{value.callee or 'a call'} is not known here")]
            if reasons:
                found[name] = reasons[0]
        found |= {name: why for name, why in self.from_cfg.unknown.items() if self.value(name) is None}
        parts: dict[str, list[Unknown]] = {"data_files": self._data[1], "entry_points": self._entries[1]}
        found |= {name: whys[0] for name, whys in parts.items() if whys}
        return found

    @cached_property
    def _entries(self) -> tuple[list[EntryPoint], list[Unknown]]:
        value = self.value("entry_points")
        if value is None:
            return list(self.from_cfg.entry_points), []
        found = list(entry_points.from_value(self.path, value))
        return [e for e in found if isinstance(e, EntryPoint)], [u for u in found if isinstance(u, Unknown)]

    @property
    def entry_points(self) -> tuple[EntryPoint, ...]:
        """The entry points that are known, in order."""
        return tuple(self._entries[0])

    @property
    def group_spans(self) -> Mapping[str, Span]:
        """Where the groups of entry points are written in setup.py, each as a string of the dict."""
        value = self.value("entry_points")
        keys = [key for key, _ in value.items.values()] if isinstance(value, MappingValue) else []
        return {key.text: key.literal for key in keys if isinstance(key, Text) and key.literal is not None}

    @cached_property
    def _data(self) -> tuple[list[DataEntry], list[Unknown]]:
        value = self.value("data_files")
        if value is None:
            return list(self.from_cfg.data_entries), []
        found = list(data_files.from_value(self.path, value, self.folder, self.cwd))
        entries = [each for each in found if isinstance(each, DataEntry)]
        inner = [why for each in entries for why in each.unknown]
        return entries, [u for u in found if isinstance(u, Unknown)] + inner

    @property
    def data_entries(self) -> tuple[DataEntry, ...]:
        return tuple(self._data[0])

    @property
    def data_files(self) -> tuple[DataFile, ...]:
        return tuple(file for entry in self.data_entries for file in entry.files)

    @cached_property
    def generated(self) -> tuple[str, ...]:
        """The modules that setup.py generates in the package, by the last part of their names."""
        generated = [call.get("module_name", 0) for call in self.calls if call.callee in GENERATORS]
        return tuple(value.text for value in generated if isinstance(value, Text))

    @cached_property
    def may_write_files(self) -> bool:
        """Whether setup.py may write files that it then installs: by a custom command or a call that isn't known."""
        return bool(self.value("cmdclass")) or any(may_write(call) for call in self.calls if call is not self.call)
