"""A file of launch/ or config/ in the share directory: in the entry or rule of its folder, or in a new one."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from ..change import NotUnderstoodError, Paste
from ..edits.cmake_commands import remove
from ..edits.cmake_install import SHARE, install_folder
from ..edits.cmake_rule_place import block
from ..edits.data_files import glob_code, share_code
from ..edits.list_item import append_item, removals
from ..edits.setup_py import own_arguments, quoted
from ..finding import Edit
from ..languages.python.evaluate.values import Sequence, Symbol
from ..light_dataclasses import dataclass
from ..package.cmake.cmake_project import CMake
from ..package.install_table import InstallTable
from ..package.package import Package
from ..package.setup.setup_py import SetupPy
from ..source import Span
from .cmake_block import argument_removals, block_removals
from .dependency import manifest_of
from .entry_point import is_written, setup_of
from .part import Operations


@dataclass(frozen=True)
class ShareFile:
    path: str

    def add(self, package: Package) -> Operations:
        """Return the edits, nothing where the file is installed already; raises NotUnderstoodError."""
        name = manifest_of(package).name
        if self.is_installed(package, name):
            return ()
        cmake = package.parts(CMake).only
        if cmake is not None:
            return self.in_cmake(cmake)
        setup = setup_of(package)
        edits = self.in_entry(setup, name) or self.in_data_files(setup, name) or self.in_call(setup, name)
        if edits:
            return edits
        line = f"('share/{name}/{self.folder}', ['{self.path}']),"
        raise NotUnderstoodError(
            f"`{self.path}` can't be put among the data files, which are computed: put the line where it belongs, and "
            "run the command again",
            Paste("setup.py, in data_files", line),
        )

    @property
    def folder(self) -> str:
        return posixpath.dirname(self.path)

    def is_installed(self, package: Package, name: str) -> bool:
        """Return whether the build puts it into the share directory, as far as that is known."""
        table = package.parts(InstallTable).only
        return table is not None and any(row.source == self.path for _, row in table.below(f"share/{name}"))

    def in_cmake(self, cmake: CMake) -> Operations:
        return (install_folder(cmake, self.folder),)

    def in_entry(self, setup: SetupPy, name: str) -> Operations:
        """Return the edit of a list of names for the same folder."""
        place = posixpath.join(f"share/{name}", self.folder)
        for entry in setup.data_entries:
            found = entry.sources if entry.folder == place and entry.path == setup.path else None
            if found is not None and found.items and is_written(setup, found):
                return append_item(setup.source, found.span, found.places, quoted(setup, self.path))
        return ()

    def in_data_files(self, setup: SetupPy, name: str) -> Operations:
        value = setup.value("data_files")
        if not isinstance(value, Sequence) or not is_written(setup, value):
            return ()
        return append_item(setup.source, value.span, value.places, self.entry(setup, name))

    def in_call(self, setup: SetupPy, name: str) -> Operations:
        """Return a new argument of setup()."""
        if setup.value("data_files") is not None or setup.argument("data_files") is not None or setup.call is None:
            return ()
        if setup.cfg is not None and setup.from_cfg.data_entries:
            return ()
        start = setup.source.text.index("(", setup.call.span.start)
        spans = [argument.span for argument in own_arguments(setup)]
        code = f"data_files=[{self.entry(setup, name)}]"
        return append_item(setup.source, Span(start, setup.call.span.end), spans, code)

    def entry(self, setup: SetupPy, name: str) -> str:
        """Return a tuple for the folder: with a glob where setup.py imports one, else with the name of the file."""
        bound = setup.names.get("glob")
        sources = f"[{quoted(setup, self.path)}]"
        if isinstance(bound, Symbol) and bound.name in ("glob", "glob.glob"):
            pattern = f"{self.folder}/*{posixpath.splitext(self.path)[1]}"
            sources = f"{glob_code(setup)}({quoted(setup, pattern)})"
        return f"({share_code(setup, name, *self.folder.split('/'))}, {sources})"

    def remove(self, package: Package) -> Iterator[Operations]:
        """Yield the removal of what installs this file alone."""
        cmake = package.parts(CMake).only
        if cmake is not None:
            yield from self.from_cmake(package, cmake)
            return
        setup = setup_of(package)
        for entry in setup.data_entries:
            mine = [file for file in entry.files if file.source == self.path]
            if not mine or entry.path != setup.path:
                continue
            if len(entry.files) > 1:
                if entry.sources is not None and is_written(setup, entry.sources) and entry.glob is None:
                    yield from removals(setup.source, mine[0].position)
                continue
            for argument in own_arguments(setup):
                if argument.name == "data_files" and len(setup.data_entries) == 1:
                    yield from removals(setup.source, argument.span)
            yield from removals(setup.source, entry.position)

    def from_cmake(self, package: Package, cmake: CMake) -> Iterator[Operations]:
        """Yield the removal of the folder's rule, where the folder has no other file."""
        others = [path for path in package.files.below(self.folder) if path != self.path]
        if others:
            return
        for rule in cmake.installs:
            mine = [word for word in rule.items if word.text.rstrip("/") == self.folder]
            file = cmake.file(rule.call.path)
            if rule.kind != "DIRECTORY" or not mine or not file.is_top(rule.call.command):
                continue
            if len(rule.items) > 1:
                yield from argument_removals(file, mine[0].span)
            elif rule.call.name == "install":
                yield from block_removals(file, block(file, "DIRECTORY", self.folder, SHARE))
                yield (remove(file, rule.call.command),)
            else:
                yield from argument_removals(file, mine[0].span)
                yield from keyword_removals(file.path, file.source.text, self.folder, file.indent)


def keyword_removals(path: str, text: str, folder: str, indent: str) -> Iterator[Operations]:
    """Yield the removal of INSTALL_TO_SHARE with its one folder, as it is written into ament_auto_package()."""
    written = f"\n{indent}INSTALL_TO_SHARE\n{indent * 2}{folder}\n"
    at = text.rfind(written)
    if at >= 0:
        yield (Edit(path, Span(at, at + len(written)), ""),)
