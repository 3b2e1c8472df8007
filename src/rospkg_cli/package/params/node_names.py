"""The names that code gives its nodes, which a launch file without `name=` leaves as they are."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from ...files import ReaderInput
from ...languages.cpp.read import SUFFIXES
from ...lazy_regex import regex
from ..cmake.cmake_project import CMake
from ..file_role import role_of
from ..install_table import InstallTable
from ..setup.setup_py import SetupPy
from .declared_parameter import NodeName
from .node_sources import registrations, sources

COMMENT = regex(r'"(?:[^"\\\n]|\\.)*"|//[^\n]*|/\*.*?\*/', re.DOTALL)
IN_CPP = regex(
    r"(?<![\w~])(?:Lifecycle)?Node(?:\s*>)?(?:\s*::\s*make_shared)?\s*(?:\(\s*(\"\w*\"|[^)\s])|\{\s*(\"\w*\"))"
)
"""A call of a constructor of a node, with its first argument."""
OWN_CLASS = regex(r"[:,]\s*(?:\w+::)*(?:Lifecycle)?Node\s*[({]\s*\"")
"""A class that hands its base class the name."""
MAIN = regex(r"\bint\s+main\s*\(")
MADE = regex(r"(?:make_(?:shared|unique)\s*<|\bnew\b)\s*(?!rclcpp::(?:Node|executors)\b)([\w:]+)")
"""An object that may be a node, with its class."""
IN_PYTHON = regex(
    r"(?:super\([^)\n]*\)\.__init__|\bNode\.__init__|\bcreate_node|\bNode)"
    r"\(\s*(?:self\s*,\s*)?(?:node_name\s*=\s*)?(['\"]\w*['\"]|[^\s'\")]|\))"
)
NODE_CLASS = regex(r"\bclass\s+\w+\s*\([^)]*Node\s*[,)]|\bcreate_node\s*\(|\brclpy\.node\.Node\s*\(")
INCLUDED = regex(r'#[ \t]*include[ \t]*["<]([^">\n]+)[">]')
OPTIONS = regex(r"__node\b|__name\b")
"""Arguments of a node by which code renames it."""
IN_LINE = regex(r"(?m)^[ \t]*#[^\n]*")
PYTHON = "\0"
"""Stands before a text of Python."""


def node_names(reading: ReaderInput) -> tuple[NodeName, ...]:
    """Return the executables and components of which all code has one literal name of a node."""
    found = {**dict(of_cmake(reading)), **dict(of_programs(reading))}
    named = ((starts, only_name(texts)) for starts, texts in found.items())
    return tuple(NodeName(starts, name) for starts, name in named if name)


def only_name(texts: list[str]) -> str:
    """Return the one name that texts give nodes; "" where there is none, several, or one that is computed.

    A class that is elsewhere may give its node a name as well.
    """
    names = {name for text in texts for name in names_in(text)}
    made = {found[1] for text in texts if MAIN.search(text) for found in MADE.finditer(text)}
    is_own = any(OWN_CLASS.search(text) for text in texts)
    return names.pop() if len(names) == 1 and len(made) <= is_own else ""


def names_in(text: str) -> Iterator[str]:
    """Yield the names of the nodes that a text makes; "" for one that is computed."""
    is_python = text.startswith(PYTHON)
    if is_python and not NODE_CLASS.search(text):
        return
    if OPTIONS.search(text):
        yield ""
    for found in (IN_PYTHON if is_python else IN_CPP).finditer(text):
        name = found[found.lastindex or 1]
        yield name[1:-1] if name[0] in "'\"" else ""


def of_cmake(reading: ReaderInput) -> Iterator[tuple[str, list[str]]]:
    """Yield what CMake builds, each with the texts of its sources and of their headers."""
    cmake = reading.parts(CMake).only
    if cmake is None:
        return
    registered = {name: path for path, name in registrations(reading)}
    for target in cmake.targets:
        if target.is_executable and target.word.is_known:
            yield target.name, list(texts_of(reading, sources(cmake, target)))
    for component in cmake.components:
        if path := registered.get(component.plugin.text):
            texts = list(texts_of(reading, [path]))
            yield component.plugin.text, texts
            if component.executable:
                yield component.executable.text, texts


def texts_of(reading: ReaderInput, paths: Iterable[str]) -> Iterator[str]:
    """Yield the texts of sources, of the headers of the package that they include, and of the sources of these."""
    code = [path for path in reading.files.paths if path.endswith(SUFFIXES) and role_of(path) == "run"]
    ends = {path.rpartition("/")[2]: path for path in code} | {path.rpartition("include/")[2]: path for path in code}
    alike: dict[str, list[str]] = {}
    for path in code:
        alike.setdefault(stem_of(path), []).append(path)
    waiting, seen = list(paths), set[str]()
    while waiting:
        path = waiting.pop()
        if path in seen or not reading.files.exists(path):
            continue
        seen.add(path)
        text = COMMENT.sub(lambda each: each[0] if each[0][0] == '"' else " ", reading.files.readable_text(path))
        yield text
        headers = [ends[name] for name in INCLUDED.findall(text) if name in ends]
        stems = sorted({stem_of(header) for header in headers})
        waiting += [*headers, *(each for stem in stems for each in alike[stem])]


def stem_of(path: str) -> str:
    return path.rpartition("/")[2].partition(".")[0]


def of_programs(reading: ReaderInput) -> Iterator[tuple[str, list[str]]]:
    """Yield the programs in Python: entry points, and files that are installed as they are."""
    setup, table = reading.parts(SetupPy).only, reading.parts(InstallTable).only
    for each in setup.entry_points if setup is not None else ():
        path = f"{each.module.replace('.', '/')}.py"
        if reading.files.exists(path):
            yield each.name, [python_text(reading, path)]
    for row in table.rows if table is not None else ():
        if row.what == "executable" and row.source.endswith(".py") and role_of(row.source) == "run":
            yield row.destination.rpartition("/")[2], [python_text(reading, row.source)]


def python_text(reading: ReaderInput, path: str) -> str:
    return PYTHON + IN_LINE.sub("", reading.files.readable_text(path))
