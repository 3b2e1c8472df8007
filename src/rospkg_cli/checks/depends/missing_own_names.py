"""Imports of modules and names that the packages of the workspace do not have (DEP109)."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.python.alias_span import alias_span
from ...languages.python.file import PythonFile
from ...languages.python.imports import Import
from ...light_dataclasses import dataclass, replace
from ...package.file_role import role_of
from ...ros.interfaces import KINDS
from ...source import Span
from ...suggest import nearest, slips
from ..python.installed_modules import MADE, InstalledModules
from ..python.unwritten_modules import why_left_to_write
from .own_imports import OwnImports

LEFT = "; nothing starts or imports this module"


@dataclass(frozen=True, slots=True)
class MissingOwnName:
    """An import that ends with an exception."""

    path: str
    span: Span
    """The place of the missing name, as it is written."""
    package: str
    """The module or package that should have it."""
    name: str
    near: str | None
    is_module: bool
    """Whether Python looks for a module and nothing else."""
    is_local: bool
    """Whether it is in a function, which may not be called, or in a branch."""
    module: str = ""
    """The full name of the imported module, where the missing part is one of its parents."""
    elsewhere: str = ""
    """The module of the same name in another package of the workspace, where there is one."""
    is_reached: bool = True
    """Whether what the package starts, launches or tests imports the file, as far as it can be known."""
    why: str = ""
    """Why the import seldom or never runs, as the end of a message."""


@dataclass(frozen=True)
class MissingOwnNames:
    imports: OwnImports

    @property
    def installed(self) -> InstalledModules:
        return self.imports.installed

    def all(self) -> Iterator[MissingOwnName]:
        """Yield the imports of modules and names that the workspace's packages do not have."""
        for each in self.absent():
            is_test = role_of(each.path) == "test"
            reached, places = self.imports.reached, self.imports.places
            why = LEFT if reached.is_left(each.path) else places.why_seldom(each.path, each.span)
            why = why or self.why_left_to_write(each)
            is_local = each.is_local or places.is_conditional(each.path, each.span)
            is_reached = reached.has(each.path) and not is_test
            yield replace(each, is_local=is_local, is_reached=is_reached, why=why)

    def why_left_to_write(self, each: MissingOwnName) -> str:
        """Return that a comment in the module says that the name is still to be written; "" for other names."""
        path = "" if each.is_module else self.installed.sources.get(each.package, "")
        file = self.imports.run.modules.at(path) if path else None
        return why_left_to_write(file, each.name) if file is not None else ""

    def absent(self) -> Iterator[MissingOwnName]:
        """Yield the missing names, without what is known of their places."""
        is_known = self.imports.table.knows("module")
        for file, each in self.imports.run.certain:
            module = self.installed.absolute(each, file.path)
            top = module.partition(".")[0]
            if top in self.installed.tops:
                if is_known:
                    found = self.of_own(file, each, module)
                    is_open = self.imports.changes_path(file) and not each.level
                    yield from (one for one in found if not is_open or slips(one.name, (one.near or "",)))
            elif module and top not in KINDS:
                yield from self.of_others(file, each, module)

    def of_own(self, file: PythonFile, each: Import, module: str) -> Iterator[MissingOwnName]:
        """Yield what an import from the package's own modules lacks."""
        missing = self.installed.missing(module)
        if missing is not None and not (each.names and all(map(MADE.fullmatch, each.names))):
            package, name = missing
            near = nearest(name, self.installed.below(package))
            if name not in KINDS and (near or not self.imports.may_be_made):
                span, whole = part_span(file, each, module, name), module if module != f"{package}.{name}" else ""
                other = "" if near else self.elsewhere(module)
                yield MissingOwnName(file.path, span, package, name, near, True, each.is_local, whole, other)
        elif module in self.installed.sources:
            for name in each.names:
                if name in ("*", *KINDS) or name.startswith("__") or self.installed.offers(module, name):
                    continue
                near = nearest(name, self.imports.offered(module))
                yield MissingOwnName(file.path, alias_span(file, each, name), module, name, near, False, each.is_local)

    def elsewhere(self, module: str) -> str:
        """Return the one module of the workspace that has the same name within its package."""
        within = module.partition(".")[2]
        found = [name for each in self.imports.workspace.packages if (name := f"{each.name}.{within}") in each.modules]
        return found[0] if len(found) == 1 else ""

    def of_others(self, file: PythonFile, each: Import, module: str) -> Iterator[MissingOwnName]:
        """Yield an import from another package of the workspace, where it has a module of a near name."""
        top = module.partition(".")[0]
        providers = self.imports.workspace.having("modules", top)
        if len(providers) != 1 or not providers[0].knows("modules") or self.imports.changes_path(file):
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
