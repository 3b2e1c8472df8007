"""The Python files of a package, each parsed once and only when asked for."""

from __future__ import annotations

from collections.abc import Iterator

from ..files import PackageFiles, ReaderInput
from ..languages.python.file import PythonFile, parse_python
from ..light_dataclasses import dataclass, field
from ..unreadable import Unreadable, UnreadableError
from .install_table import InstallTable
from .setup.setup_py import SetupPy


@dataclass(frozen=True)
class PythonModules:
    files: PackageFiles
    parsed: dict[str, PythonFile | Unreadable] = field(default_factory=dict)

    def read(self, path: str) -> PythonFile | Unreadable:
        """Return a parsed file, or why it can't be parsed."""
        if path not in self.parsed:
            try:
                self.parsed[path] = parse_python(self.files.source(path))
            except UnreadableError as error:
                self.parsed[path] = error.unreadable
        return self.parsed[path]

    def skip(self, unreadable: Unreadable) -> None:
        """Keep no syntax tree of a file that is said to be skipped."""
        self.parsed[unreadable.path] = unreadable

    def at(self, path: str) -> PythonFile | None:
        """Return the file at a path; None where there is none, or none that can be parsed."""
        found = self.read(path) if self.files.exists(path) else None
        return found if isinstance(found, PythonFile) else None


def read_modules(reading: ReaderInput) -> Iterator[PythonModules]:
    yield PythonModules(reading.files)


def read_installed_modules(reading: ReaderInput) -> Iterator[PythonFile | Unreadable]:
    """Read every module and script that is installed: one that can't be parsed is a fault that shows at run time."""
    setup, modules = reading.parts(SetupPy).only, reading.parts(PythonModules).only
    table = reading.parts(InstallTable).only
    rows = table.rows if table is not None else ()
    paths = {row.source for row in rows if row.what in ("module", "executable") and row.source.endswith(".py")}
    paths |= set(setup.modules.values()) if setup is not None else set()
    if modules is not None:
        for path in sorted(paths):
            yield modules.read(path)
