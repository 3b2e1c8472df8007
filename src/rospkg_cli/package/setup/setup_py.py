"""setup.py as rules see it: the arguments of setup(), merged with setup.cfg as setuptools merges them."""

from __future__ import annotations

import posixpath
from collections.abc import Mapping
from functools import cached_property

from ...languages.python.evaluate.conversion import unknowns
from ...languages.python.evaluate.sandbox_filesystem import Kind, OutsideError
from ...languages.python.evaluate.values import Call, GlobResult, Sequence, Text, Unknown, Value
from ...languages.python.evaluate.values import Mapping as MappingValue
from ...light_dataclasses import dataclass
from ...source import Span
from . import data_files, entry_points
from .data_files import DataEntry, DataFile
from .entry_points import EntryPoint
from .file_writing_calls import GENERATORS, may_write
from .find_packages import PackageSearch, dotted, package_folder
from .setup_arguments import SetupArguments
from .setup_text import SetupText

ARGUMENTS = (
    "name version packages py_modules package_dir package_data scripts data_files entry_points extras_require"
    " tests_require install_requires cmdclass"
).split()
"""The arguments of setup() that rules and the install table are made of."""


@dataclass(frozen=True)
class SetupPy(SetupArguments):
    calls: tuple[Call, ...]
    """Every call in setup.py that was not evaluated."""
    globs: tuple[GlobResult, ...]
    searches: tuple[PackageSearch, ...]
    """Every find_packages()."""
    names: Mapping[str, Value]
    """What the names of setup.py are bound to in the end."""
    cwd: str
    """The folder that relative paths start from, when setup() is called."""

    def used_elsewhere(self, setup_text: SetupText) -> bool:
        """Return whether a text is outside of the call of setup(), in a variable that others may use."""
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
    def packages(self) -> tuple[SetupText, ...]:
        return self.texts("packages")

    @cached_property
    def package_names(self) -> frozenset[str]:
        """The dotted names of the packages that are installed."""
        return frozenset(dotted(said.text) for said in self.packages)

    @cached_property
    def py_modules(self) -> tuple[SetupText, ...]:
        return self.texts("py_modules")

    @cached_property
    def scripts(self) -> tuple[SetupText, ...]:
        return self.texts("scripts")

    @cached_property
    def package_dir(self) -> Mapping[str, str]:
        """The folders of packages: name of a package, or "" for all, to folder."""
        value = self.value("package_dir")
        if value is None:
            return self.from_cfg.package_dir
        pairs = value.items.items() if isinstance(value, MappingValue) else ()
        return {str(key): item.text.rstrip("/") for key, (_, item) in pairs if isinstance(item, Text)}

    @cached_property
    def package_data(self) -> Mapping[str, tuple[str, ...]]:
        """Patterns of files that are installed with modules: name of a package, or "" for all, to patterns."""
        value = self.value("package_data")
        if value is None:
            return self.from_cfg.package_data
        found: dict[str, tuple[str, ...]] = {}
        for key, (_, patterns) in value.items.items() if isinstance(value, MappingValue) else ():
            items = patterns.items if isinstance(patterns, Sequence) else []
            found[str(key)] = tuple(item.text for item in items if isinstance(item, Text))
        return found

    def folder_of(self, package: str) -> str:
        """Return the folder of a package, relative to setup.py."""
        found = package_folder(package, self.package_dir)
        return "" if found == "." else found

    @cached_property
    def modules(self) -> Mapping[str, str]:
        """The modules that are installed: dotted name to file.

        Beside a module of `py_modules` setuptools installs the `__init__.py` of its folder, too.
        """
        found: dict[str, str] = {}
        for package in self.packages:
            name_of, folder = dotted(package.text), self.folder_of(package.text)
            for name in self.folder.children.get(folder, {}):
                path = f"{folder}/{name}" if folder else name
                if name.endswith(".py") and path != "setup.py" and self.folder.kind(path) == "file":
                    stem = name[: -len(".py")]
                    found[name_of if stem == "__init__" else f"{name_of}.{stem}"] = path
        for module in self.py_modules:
            if (file := self.file_of(module.text)) is not None:
                found[module.text] = file
                init = posixpath.join(posixpath.dirname(file), "__init__.py")
                if (above := module.text.rpartition(".")[0]) and self.kind(init) == "file":
                    found.setdefault(above, init)
        return found

    def kind(self, path: str) -> Kind | None:
        """Return the kind of entry at a path; "unknown" where a link leads out of the package."""
        try:
            return self.folder.kind(path)
        except OutsideError:
            return "unknown"

    def file_of(self, module: str) -> str | None:
        """Return the file of a module in the package, whether it is installed or not."""
        package, _, name = module.rpartition(".")
        folder = self.folder_of(package) if package else self.package_dir.get("", "")
        for path in (posixpath.join(folder, f"{name}.py"), posixpath.join(self.folder_of(module), "__init__.py")):
            if self.kind(posixpath.normpath(path)) == "file":
                return posixpath.normpath(path)
        return None

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
        """The modules that setup.py has generated into the package, by their last name."""
        generated = [call.get("module_name", 0) for call in self.calls if call.callee in GENERATORS]
        return tuple(value.text for value in generated if isinstance(value, Text))

    @cached_property
    def may_write_files(self) -> bool:
        """Whether setup.py may write files that it then installs: by a custom command or a call that isn't known."""
        return bool(self.value("cmdclass")) or any(may_write(call) for call in self.calls if call is not self.call)
