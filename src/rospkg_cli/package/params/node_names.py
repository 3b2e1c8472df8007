"""The names that code gives its nodes, which a launch file without `name=` leaves as they are."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cached_property

from ...files import PackageFiles, ReaderInput
from ...languages.cpp.read import SUFFIXES
from ...light_dataclasses import dataclass
from ..cmake.cmake_project import CMake
from ..file_role import role_of
from ..install_table import InstallTable
from ..setup.setup_py import SetupPy
from .declared_parameter import NodeName
from .node_sources import registrations, sources
from .node_texts import NodeText, of_cpp, of_python


def node_names(reading: ReaderInput) -> tuple[NodeName, ...]:
    """Return the executables and components of which all code has one literal name of a node."""
    found = {**dict(of_cmake(reading)), **dict(of_programs(reading))}
    named = ((starts, only_name(texts)) for starts, texts in found.items())
    return tuple(NodeName(starts, name) for starts, name in named if name)


def only_name(texts: list[NodeText]) -> str:
    """Return the one name that texts give nodes; "" where there is none, several, or one that is computed.

    A class that is elsewhere may give its node a name as well.
    """
    names = frozenset[str]().union(*(text.names for text in texts))
    made = frozenset[str]().union(*(text.made for text in texts))
    is_alone = len(names) == 1 and len(made) <= any(text.is_own for text in texts)
    return next(iter(names)) if is_alone else ""


def of_cmake(reading: ReaderInput) -> Iterator[tuple[str, list[NodeText]]]:
    """Yield what CMake builds, each with the texts of its sources and of their headers."""
    cmake = reading.parts(CMake).only
    if cmake is None:
        return
    code = CodeOfNodes(reading.files)
    registered = {name: path for path, name in registrations(reading)}
    for target in cmake.targets:
        if target.is_executable and target.word.is_known:
            yield target.name, list(code.reached(sources(cmake, target)))
    for component in cmake.components:
        if path := registered.get(component.plugin.text):
            texts = list(code.reached([path]))
            yield component.plugin.text, texts
            if component.executable:
                yield component.executable.text, texts


@dataclass(frozen=True)
class CodeOfNodes:
    """The C++ files of a package, each read once: many programs share the files of a library."""

    files: PackageFiles

    @cached_property
    def texts(self) -> dict[str, NodeText]:
        return {}

    @cached_property
    def paths(self) -> list[str]:
        return [path for path in self.files.paths if path.endswith(SUFFIXES) and role_of(path) == "run"]

    @cached_property
    def by_end(self) -> dict[str, str]:
        """The paths by what an include may write of them."""
        names = {path.rpartition("/")[2]: path for path in self.paths}
        return names | {path.rpartition("include/")[2]: path for path in self.paths}

    @cached_property
    def alike(self) -> dict[str, list[str]]:
        found: dict[str, list[str]] = {}
        for path in self.paths:
            found.setdefault(stem_of(path), []).append(path)
        return found

    def text(self, path: str) -> NodeText:
        if path not in self.texts:
            self.texts[path] = of_cpp(self.files.readable_text(path))
        return self.texts[path]

    def reached(self, paths: Iterable[str]) -> Iterator[NodeText]:
        """Yield the texts of sources, of the package's headers that they include, and of the sources of these."""
        waiting, seen = list(paths), set[str]()
        while waiting:
            path = waiting.pop()
            if path in seen or not self.files.exists(path):
                continue
            seen.add(path)
            text = self.text(path)
            yield text
            headers = [self.by_end[name] for name in text.included if name in self.by_end]
            stems = sorted({stem_of(header) for header in headers})
            waiting += [*headers, *(each for stem in stems for each in self.alike[stem])]


def stem_of(path: str) -> str:
    return path.rpartition("/")[2].partition(".")[0]


def of_programs(reading: ReaderInput) -> Iterator[tuple[str, list[NodeText]]]:
    """Yield the programs in Python: entry points, and files that are installed as they are."""
    setup, table = reading.parts(SetupPy).only, reading.parts(InstallTable).only
    for each in setup.entry_points if setup is not None else ():
        path = f"{each.module.replace('.', '/')}.py"
        if reading.files.exists(path):
            yield each.name, [of_python(reading.files.readable_text(path))]
    for row in table.rows if table is not None else ():
        if row.what == "executable" and row.source.endswith(".py") and role_of(row.source) == "run":
            yield row.destination.rpartition("/")[2], [of_python(reading.files.readable_text(row.source))]
