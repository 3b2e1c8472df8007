"""Imports of the workspace's own modules and names that are not there (DEP109)."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...files import PackageFiles
from ...languages.python.alias_span import alias_span
from ...languages.python.file import PythonFile
from ...languages.python.imports import Import
from ...light_dataclasses import dataclass, replace
from ...package.cmake.cmake_project import CMake
from ...package.file_role import role_of
from ...package.install_table import InstallTable
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ...ros.imports import STANDARD
from ...ros.interfaces import KINDS
from ...source import Span
from ...suggest import nearest, slips
from ..python.installed_modules import MADE, InstalledModules
from ..python.run_imports import PATHS, RunImports
from ..python.unwritten_modules import why_left_to_write
from ..reached_modules import ReachedModules
from ..reached_places import ReachedPlaces
from .pip_installs import PipInstalls, normalized

LEFT = "; nothing starts or imports this module"
BUILDING = ("ext_modules", "cythonize", "cmdclass", "rust_extensions")
"""How setup.py makes modules that have no file of Python."""


@dataclass(frozen=True, slots=True)
class MissingOwnName:
    """An import that ends with an exception."""

    path: str
    span: Span
    """Of the name that is not there, as it is written."""
    package: str
    """The module or package that should have it."""
    name: str
    near: str | None
    is_module: bool
    """Whether Python looks for a module and nothing else."""
    is_local: bool
    """Whether it is in a function, which may not be called, or in a branch."""
    module: str = ""
    """The whole of what is imported, where that is a module further down."""
    elsewhere: str = ""
    """The module of the same name in another package of the workspace, where there is one."""
    is_reached: bool = True
    """Whether what the package starts, launches or tests imports the file, as far as it can be known."""
    why: str = ""
    """What is said of an import that seldom or never runs: nothing leads to its function or its module."""


@dataclass(frozen=True)
class OwnImports:
    """The imports of installed modules and of what runs next to them, and the modules of the workspace."""

    facts: PackageFacts
    workspace: Workspace
    files: PackageFiles
    run: RunImports
    table: InstallTable
    installed: InstalledModules
    reached: ReachedModules
    places: ReachedPlaces
    cmake: CMake | None = None

    @cached_property
    def may_be_made(self) -> bool:
        """Whether the build may make a module that has no file: it compiles or writes some, or not all is known."""
        if self.facts.build_type == "ament_python":
            return any(word in self.files.readable_text("setup.py") for word in BUILDING)
        if self.cmake is None or not self.cmake.is_complete or self.cmake.reads_unknown_files:
            return True
        from .module_makers import may_make_modules  # for packages of CMake alone

        return any(may_make_modules(call) for call in self.cmake.calls) or any(
            not source for source in self.installed.sources.values()
        )

    def wrong(self) -> Iterator[MissingOwnName]:
        """Yield the imports of modules and names that the workspace's packages do not have."""
        for each in self.absent():
            is_test = role_of(each.path) == "test"
            why = LEFT if self.reached.is_left(each.path) else self.places.why_seldom(each.path, each.span)
            why = why or self.why_left_to_write(each)
            is_local = each.is_local or self.places.is_conditional(each.path, each.span)
            is_reached = self.reached.has(each.path) and not is_test
            yield replace(each, is_local=is_local, is_reached=is_reached, why=why)

    def why_left_to_write(self, each: MissingOwnName) -> str:
        """Return what is said of a name that a comment in its module says is still to be written; "" for others."""
        path = "" if each.is_module else self.installed.sources.get(each.package, "")
        file = self.run.modules.at(path) if path else None
        return why_left_to_write(file, each.name) if file is not None else ""

    def absent(self) -> Iterator[MissingOwnName]:
        is_known = self.table.knows("module")
        for file, each in self.run.certain:
            module = self.installed.absolute(each, file.path)
            top = module.partition(".")[0]
            if top in self.installed.tops:
                if is_known:
                    found = self.of_own(file, each, module)
                    is_open = self.changes_path(file) and not each.level
                    yield from (one for one in found if not is_open or slips(one.name, (one.near or "",)))
            elif module and top not in KINDS:
                yield from self.of_others(file, each, module)

    def changes_path(self, file: PythonFile) -> bool:
        """Return whether an import in a file may find a module that this package does not install."""
        return self.run.changes_path or any(word in file.source.text for word in PATHS)

    def of_own(self, file: PythonFile, each: Import, module: str) -> Iterator[MissingOwnName]:
        missing = self.installed.missing(module)
        if missing is not None and not (each.names and all(map(MADE.fullmatch, each.names))):
            package, name = missing
            near = nearest(name, self.installed.below(package))
            if name not in KINDS and (near or not self.may_be_made):
                span, whole = part_span(file, each, module, name), module if module != f"{package}.{name}" else ""
                other = "" if near else self.elsewhere(module)
                yield MissingOwnName(file.path, span, package, name, near, True, each.is_local, whole, other)
        elif module in self.installed.sources:
            for name in each.names:
                if name in ("*", *KINDS) or name.startswith("__") or self.installed.offers(module, name):
                    continue
                near = nearest(name, self.offered(module))
                yield MissingOwnName(file.path, alias_span(file, each, name), module, name, near, False, each.is_local)

    def elsewhere(self, module: str) -> str:
        """Return the one module of the workspace that has the same name within its package."""
        within = module.partition(".")[2]
        found = [name for each in self.workspace.packages if (name := f"{each.name}.{within}") in each.modules]
        return found[0] if len(found) == 1 else ""

    def offered(self, module: str) -> list[str]:
        """Return the names that a module may be asked for."""
        file = self.run.modules.at(self.installed.sources[module])
        return [*self.installed.below(module), *(file.definitions if file is not None else ())]

    def of_others(self, file: PythonFile, each: Import, module: str) -> Iterator[MissingOwnName]:
        """Yield an import from another package of the workspace, where it has a module of a near name."""
        top = module.partition(".")[0]
        providers = self.workspace.having("modules", top)
        if len(providers) != 1 or not providers[0].knows("modules") or self.changes_path(file):
            return
        parts, known = module.split("."), providers[0].modules
        for end in range(1, len(parts)):
            package, name = ".".join(parts[:end]), parts[end]
            if f"{package}.{name}" not in known:
                start = f"{package}."
                near = nearest(name, {other[len(start) :] for other in known if other.startswith(start)})
                if near and name not in KINDS:
                    span = part_span(file, each, module, name)
                    yield MissingOwnName(file.path, span, package, name, near, True, each.is_local)
                return

    def has_all(self, each: Import, module: str) -> bool:
        """Return whether the package's own module is there, with all that an import takes out of it."""
        names = (name for name in each.names if name != "*")
        return module in self.installed.sources and all(self.installed.offers(module, name) for name in names)

    def is_from_pip(self, top: str) -> bool:
        """Return whether the repository has pip install a distribution of that name."""
        return normalized(top) in PipInstalls(self.files).names

    def is_found(self, top: str) -> bool:
        """Return whether Python may find a module of that name outside of the importing file's folder.

        What is installed beside the programs is found by all of them.
        """
        beside = f"lib/{self.facts.name}/{top}.py"
        own = top in self.installed.tops or top in STANDARD or self.files.exists(f"{top}.py")
        own = own or any(row.destination == beside for row in self.table.rows)
        return own or bool(self.workspace.providers_of(top)) or top in {each.name for each in self.facts.dependencies}


def part_span(file: PythonFile, each: Import, module: str, name: str) -> Span:
    """Return where one part of an imported module's name is written, for the whole of it where that is not plain."""
    text = file.source.slice(each.span)
    written = text.lstrip(".")
    if written != each.module:
        return each.span
    before = len(module.split(".")) - len(written.split("."))
    parts = module.split(".")
    at = next((i for i, part in enumerate(parts) if i >= before and i > 0 and part == name), None)
    if at is None:
        return each.span
    start = each.span.start + len(text) - len(written) + sum(len(part) + 1 for part in parts[before:at])
    return Span(start, start + len(name))
