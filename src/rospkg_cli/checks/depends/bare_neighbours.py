"""Imports of a module of the same package, or of a file in the same folder, by its bare name (DEP110)."""

from __future__ import annotations

import ast
import posixpath
from collections.abc import Iterator

from ...languages.python.branches import asks_how_started
from ...languages.python.called_modules import is_bound
from ...languages.python.file import PythonFile
from ...languages.python.imports import Import
from ...languages.python.nodes import nodes_of_kind
from ...light_dataclasses import dataclass
from ..repository.foreign_images import foreign_image
from .hand_installs import HandInstalls
from .own_imports import OwnImports

BUSES = frozenset("board busio gpiod Jetson lgpio pigpio RPi smbus smbus2 spidev".split())
"""Modules for the pins of a board: a module that imports one drives a device."""
DRIVES = "; it drives a device, whose maker may have put it there as a library"
BY_HAND = "; a page or script here has a library of that name installed by hand"


@dataclass(frozen=True, slots=True)
class BareNeighbour:
    file: PythonFile
    each: Import
    full: str
    """The name that Python finds."""


@dataclass(frozen=True)
class BareNeighbours:
    imports: OwnImports

    def all(self) -> Iterator[BareNeighbour]:
        """Yield imports of a bare name that only the file's own folder has."""
        imports = self.imports
        programs = {row.source for row in imports.table.rows if row.what == "executable"}
        for file, each in imports.run.certain:
            name = imports.installed.names.get(file.path, "")
            package = name.rpartition(".")[0] if name in imports.reached.started else ""
            top = each.module.partition(".")[0]
            if each.level or not package or file.path in programs or imports.is_found(each):
                continue
            if imports.changes_path(file) or asks_how_started(file, each.span):
                continue  # Python looks next to a file that is started by its path
            full = f"{package}.{each.module}"
            if full != name and self.is_intended(file, each, package) and not imports.is_from_pip(top):
                yield BareNeighbour(file, each, full)

    def may_be_brought(self, found: BareNeighbour) -> str:
        """Return what else than a package may install the imported name, as the end of a message; "" for nothing."""
        each, source = found.each, self.imports.installed.sources.get(found.full, "")
        image = foreign_image(self.imports.files)
        if image is not None:
            return image.may_bring
        is_by_hand = HandInstalls(self.imports.files).has((each.module.partition(".")[0],))
        own = self.imports.run.modules.at(source) if source else None
        drives = own is not None and any(one.module.partition(".")[0] in BUSES for one in own.imports)
        return BY_HAND if is_by_hand else DRIVES if drives else ""

    def is_intended(self, file: PythonFile, each: Import, package: str) -> bool:
        """Return whether the package's own module exists and has all names that a file takes from it."""
        full, top = f"{package}.{each.module}", each.module.partition(".")[0]
        is_own = f"{package}.{top}" in self.imports.installed.sources
        if is_own and full in self.imports.installed.sources:
            offers = self.imports.installed.offers
            return self.imports.has_all(each, full) and all(offers(full, name) for name in attributes(file, each))
        return self.is_in_same_folder(file, each)

    def is_in_same_folder(self, file: PythonFile, each: Import) -> bool:
        """Return whether a module lies in a folder next to a file, which nothing installs as a Python package."""
        folder, below = posixpath.dirname(file.path), each.module.replace(".", "/")
        start = f"{folder}/{below}"
        inner = [f"{start}/{name}" for name in each.names]
        modules = [start] if "/" in below else inner
        if not folder or not modules or not all(self.imports.files.exists(f"{path}.py") for path in modules):
            return False
        return modules == inner or all(self.has(f"{start}.py", name) for name in each.names)

    def has(self, path: str, name: str) -> bool:
        """Return whether a module that nothing installs binds a name at its top level, or may do so."""
        file = self.imports.run.modules.at(path)
        return file is None or name in ("*", *file.definitions) or file.has_dynamic_names or bool(file.star_imports)


def attributes(file: PythonFile, each: Import) -> Iterator[str]:
    """Yield the attributes that a file reads of a module which it imports as a whole."""
    aliases = (alias for node in nodes_of_kind(file.tree, ast.Import) for alias in node.names)
    bound = {alias.asname or alias.name for alias in aliases if not each.names and alias.name == each.module}
    for node in nodes_of_kind(file.tree, ast.Attribute) if bound else ():
        name = ast.unparse(node.value) if isinstance(node.value, ast.Name | ast.Attribute) else ""
        is_read = name in bound and isinstance(node.ctx, ast.Load)
        if is_read and not is_bound(file, name.partition(".")[0]):
            yield node.attr
