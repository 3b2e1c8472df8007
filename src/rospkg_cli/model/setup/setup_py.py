"""setup.py as rules see it: what setuptools is told, merged with setup.cfg as setuptools merges them."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property

from ...source import Source, Span
from ..evaluate.evaluator import Evaluator
from ..evaluate.folder import Folder, Kind, OutsideError
from ..evaluate.plain import unknowns
from ..evaluate.values import Argument, Call, Constant, Globbed, Sequence, Text, Unknown, Value
from ..evaluate.values import Mapping as MappingValue
from ..files import Reading
from ..manifest import Manifest
from ..python import PythonFile, parse_python
from . import data_files, entry_points
from .cfg import SetupCfg
from .data_files import DataEntry, DataFile
from .entry_points import EntryPoint
from .from_cfg import FromCfg
from .packages import Search, knows, package_folder
from .said import Said

ARGUMENTS = (
    "name version packages py_modules package_dir package_data scripts data_files entry_points extras_require"
    " tests_require install_requires cmdclass"
).split()
"""The arguments of setup() that rules and the install table are made of."""

HARMLESS = frozenset(
    ("setuptools", "distutils", "os", "sys", "pathlib", "glob", "io", "codecs", "re", "platform", "warnings")
)
"""Modules whose functions make no file that would be installed, but for what WRITES names."""

GENERATORS = frozenset({"generate_parameter_library_py.setup_helper.generate_parameter_module"})
"""Functions that write a module of the name they are given into the installed Python package, and nothing else."""

WRITES = frozenset({"os.system", "os.makedirs", "os.mkdir", "os.symlink", "os.rename", "os.popen"})


@dataclass(frozen=True)
class SetupPy:
    file: PythonFile
    folder: Folder
    call: Call | None
    """The call of setup(); None where it can't be told."""
    doubt: Unknown | None
    """Why not."""
    calls: tuple[Call, ...]
    """Every call of setup.py that was left alone."""
    globs: tuple[Globbed, ...]
    searches: tuple[Search, ...]
    """Every find_packages()."""
    names: Mapping[str, Value]
    """What the names of setup.py are bound to in the end."""
    cwd: str
    cfg: SetupCfg | None
    cfg_broken: bool = False
    """Whether setup.cfg is there and can't be read, or pyproject.toml may say more."""

    @property
    def source(self) -> Source:
        return self.file.source

    @property
    def path(self) -> str:
        return self.file.path

    @property
    def span(self) -> Span:
        """Of `setup` in the call of setup()."""
        return Span(self.call.span.start, self.call.span.start + 5) if self.call else Span(0, 0)

    def argument(self, name: str) -> Argument | None:
        return self.call.argument(name) if self.call else None

    def name_span(self, name: str) -> Span:
        """Return where an argument is named; the name of the function where it isn't given there."""
        found = self.argument(name)
        if found is None or self.call is None or not self.call.span.start < found.span.start < self.call.span.end:
            return self.span
        return Span(found.span.start, found.span.start + len(name))

    def value_span(self, name: str) -> Span:
        """Return where the value of an argument stands; the name of the function where it isn't given there."""
        found, name_at = self.argument(name), self.name_span(name)
        if found is None or name_at == self.span:
            return self.span
        equals = self.source.text.index("=", name_at.end) + 1
        blanks = len(self.source.text[equals:]) - len(self.source.text[equals:].lstrip())
        return Span(equals + blanks, found.span.end)

    def used_elsewhere(self, said: Said) -> bool:
        """Return whether a text stands outside of the call of setup(), in a variable that others may use."""
        return self.call is None or not self.call.span.start < said.span.start < self.call.span.end

    @property
    def extras_for_tests(self) -> bool:
        """Whether colcon finds the tests' requirements in extras_require, or can't be told not to."""
        if not self.knows("extras_require"):
            return True
        value = self.value("extras_require")
        keys = {str(key) for key in value.items} if isinstance(value, MappingValue) else self.from_cfg.extras
        return bool(keys & {"test", "tests", "testing"})

    def value(self, name: str) -> Value | None:
        """Return what setup() is given; None where setup.cfg or nobody says it; Unknown where it can't be told."""
        if self.call is None:
            return self.doubt
        found = self.call.get(name)
        if found is None:
            return self.call.rest
        return None if isinstance(found, Constant) and not found.value else found

    def absent(self, name: str) -> Unknown | None:
        """Return why a missing argument may yet be given elsewhere."""
        if self.cfg_broken:
            return Unknown(self.span, "setup.cfg can't be read, or pyproject.toml says more")
        return None

    def said(self, name: str) -> Said | None:
        """Return a text of the metadata, as setup.py or setup.cfg gives it; None where it isn't known."""
        value = self.value(name)
        if value is None and self.cfg is not None:
            return self.from_cfg.text(name)
        return Said.of(self.path, value) if isinstance(value, Text) else None

    def knows(self, name: str) -> bool:
        """Return whether everything that the argument holds could be evaluated."""
        return name not in self.unknown

    @cached_property
    def unknown(self) -> Mapping[str, Unknown]:
        """Why an argument could not be evaluated, or not all of it."""
        found: dict[str, Unknown] = {}
        for name in ARGUMENTS:
            value = self.value(name)
            reasons = list(unknowns(value)) if value is not None else [u for u in [self.absent(name)] if u]
            if isinstance(value, Call):
                reasons = [Unknown(value.span, f"{value.callee or 'a call'} is not known here")]
            if reasons:
                found[name] = reasons[0]
        found |= {name: why for name, why in self.from_cfg.unknown.items() if self.value(name) is None}
        parts: dict[str, list[Unknown]] = {"data_files": self._data[1], "entry_points": self._entries[1]}
        found |= {name: whys[0] for name, whys in parts.items() if whys}
        return found

    @cached_property
    def from_cfg(self) -> FromCfg:
        return FromCfg(self.cfg, self.folder)

    def texts(self, name: str) -> tuple[Said, ...]:
        """Return the texts of a list: those that are known."""
        value = self.value(name)
        if value is None:
            return self.from_cfg.texts(name)
        if isinstance(value, Text):
            return (Said.of(self.path, value),)
        items = value.items if isinstance(value, Sequence) else []
        return tuple(Said.of(self.path, item) for item in items if isinstance(item, Text))

    @cached_property
    def packages(self) -> tuple[Said, ...]:
        return self.texts("packages")

    @cached_property
    def py_modules(self) -> tuple[Said, ...]:
        return self.texts("py_modules")

    @cached_property
    def scripts(self) -> tuple[Said, ...]:
        return self.texts("scripts")

    @cached_property
    def package_dir(self) -> Mapping[str, str]:
        """Where packages lie: name of a package, or "" for all, to folder."""
        value = self.value("package_dir")
        if value is None:
            return self.from_cfg.package_dir
        pairs = value.items.items() if isinstance(value, MappingValue) else ()
        return {str(key): item.text.rstrip("/") for key, (_, item) in pairs if isinstance(item, Text)}

    @cached_property
    def package_data(self) -> Mapping[str, tuple[str, ...]]:
        """Patterns of files that are installed beside modules: name of a package, or "" for all, to patterns."""
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
        """The modules that are installed: dotted name to file."""
        found: dict[str, str] = {}
        for package in self.packages:
            name_of, folder = package.text.replace("/", "."), self.folder_of(package.text)
            for name in self.folder.children.get(folder, {}):
                path = f"{folder}/{name}" if folder else name
                if name.endswith(".py") and path != "setup.py" and self.folder.kind(path) == "file":
                    stem = name[: -len(".py")]
                    found[name_of if stem == "__init__" else f"{name_of}.{stem}"] = path
        for module in self.py_modules:
            if (file := self.file_of(module.text)) is not None:
                found[module.text] = file
        return found

    def kind(self, path: str) -> Kind | None:
        """Return what stands at a path; "unknown" where a link leads out of the package."""
        try:
            return self.folder.kind(path)
        except OutsideError:
            return "unknown"

    def file_of(self, module: str) -> str | None:
        """Return the file of a module as it lies on disk, whether it is installed or not."""
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
        """Those that are known, in order."""
        return tuple(self._entries[0])

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
        """The modules that setup.py lets be written into the package, by their last name."""
        asked = [call.get("module_name", 0) for call in self.calls if call.callee in GENERATORS]
        return tuple(value.text for value in asked if isinstance(value, Text))

    @cached_property
    def makes_files(self) -> bool:
        """Whether setup.py may write files that it then installs: by a custom command or a call that isn't known."""
        return bool(self.value("cmdclass")) or any(may_write(call) for call in self.calls if call is not self.call)


def may_write(call: Call) -> bool:
    if call.callee in GENERATORS:
        return not isinstance(call.get("module_name", 0), Text)
    root = call.callee.partition(".")[0]
    if call.receiver is not None:
        return False
    return call.callee in WRITES or call.callee in ("open", "exec") or ("." in call.callee and root not in HARMLESS)


def read_setup_py(reading: Reading) -> Iterator[SetupPy]:
    """Evaluate setup.py where it is what colcon runs; raises UnreadableError where it is no Python."""
    if not reading.files.exists("setup.py") or not runs_setup_py(reading):
        return
    file = parse_python(reading.files.source("setup.py"))
    searches: list[Search] = []
    folder = Folder(reading.files)
    evaluator = Evaluator(file, folder, knows(searches))
    evaluator.run_file()
    cfg = reading.parts(SetupCfg)
    call, doubt = setup_call(evaluator)
    broken = bool(cfg.broken) or has_project_table(reading)
    calls, globs = tuple(evaluator.calls), tuple(evaluator.globs)
    yield SetupPy(
        file, folder, call, doubt, calls, globs, tuple(searches), evaluator.scope.names, evaluator.cwd, cfg.only, broken
    )


def runs_setup_py(reading: Reading) -> bool:
    """Return whether the package is built with its setup.py: ament_python, or nothing else is said or there."""
    manifest = reading.parts(Manifest).only
    types = {element.text for element in manifest.exports if element.tag == "build_type"} if manifest else set()
    return "ament_python" in types or (not types and not reading.files.exists("CMakeLists.txt"))


def has_project_table(reading: Reading) -> bool:
    if not reading.files.exists("pyproject.toml"):
        return False
    return "\n[project]" in "\n" + reading.files.source("pyproject.toml").text


def setup_call(evaluator: Evaluator) -> tuple[Call | None, Unknown | None]:
    """Return the one call of setup(), or why there is none to rely on."""
    found = [call for call in evaluator.calls if call.callee.rpartition(".")[2] == "setup" and call.receiver is None]
    if len(found) == 1 and found[0].certain:
        return found[0], None
    why = evaluator.gave_up or ("setup() is not called" if not found else "which setup() is called can't be told")
    return None, Unknown(found[0].span if found else Span(0, 0), why)
