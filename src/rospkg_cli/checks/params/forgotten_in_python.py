"""Parameters that nodes in Python get of themselves, and that no code declares under any similar name."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator
from functools import cached_property

from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_of_kind
from ...light_dataclasses import dataclass
from ...package.params.declared_parameter import DeclaredParameter
from ...package.params.python_parameters import has_computed_names, read_in
from ...ros.known_nodes import known_parameters
from ..python.node_bases import is_of_rclpy
from .declaring_packages import is_its_own
from .own_python_reads import hands_itself, modules_of
from .parameter_reads import ParameterReads, allows_any
from .unknown_read import MILD, UnknownRead
from .unread_variables import is_dropped_in_python

OF_LIBRARIES = ("robot_description", "diagnostic_updater.")
OWN = "def get_parameter"


@dataclass(frozen=True)
class ForgottenInPython:
    reads: ParameterReads

    def all(self) -> Iterator[UnknownRead]:
        """Yield the parameters that node classes get of themselves, and whose names occur nowhere else in the code."""
        texts = [each.source.text for each in self.modules]
        if any(OWN in text for text in texts) or any(map(is_open, self.modules)):
            return
        for file in self.modules if any("rclpy" in text for text in texts) else ():
            seen: set[str] = set()
            own = {
                span
                for each in classes(file)
                if not hands_itself(file, each, self.own_modules)
                for span in own_reads(file, each)
            }
            for read, span, throws in read_in(file):
                is_lone = self.counts.get(read.name) == self.texts.get(read.name)
                if throws and span.start in own and is_lone and read.name not in seen:
                    seen.add(read.name)
                    if not is_declared(self.reads, read):
                        certain = not MILD.search(file.source.text)
                        dropped = not certain and is_dropped_in_python(file, span, self.modules)
                        yield UnknownRead(file.source.path, span, read.name, "", certain, True, is_dropped=dropped)

    @cached_property
    def modules(self) -> tuple[PythonFile, ...]:
        return tuple(self.reads.run_files)

    @cached_property
    def own_modules(self) -> frozenset[str]:
        return modules_of(self.reads.modules.files.paths)

    @cached_property
    def counts(self) -> dict[str, int]:
        return counted(read.name for file in self.modules for read, _, _ in read_in(file))

    @cached_property
    def texts(self) -> dict[str, int]:
        """How often each text stands in the code."""
        constants = (each.value for file in self.modules for each in nodes_of_kind(file.tree, ast.Constant))
        return counted(each for each in constants if isinstance(each, str))


def is_declared(reads: ParameterReads, read: DeclaredParameter) -> bool:
    """Return whether any code, or a library that package.xml names, may declare what is read."""
    if not is_its_own(read.name) or read.name.startswith(OF_LIBRARIES) or reads.is_declared(read):
        return True
    libraries = {each.name for each in reads.package.dependencies}
    return any(each.fits(read.name) for name in libraries for each in known_parameters(name))


def is_open(file: PythonFile) -> bool:
    """Return whether nodes may have parameters that the code does not name."""
    return allows_any(file.source) or has_computed_names(file)


def counted(names: Iterable[str]) -> dict[str, int]:
    found: dict[str, int] = {}
    for name in names:
        found[name] = found.get(name, 0) + 1
    return found


def classes(file: PythonFile) -> Iterator[ast.ClassDef]:
    """Yield the classes of a file that are nodes of rclpy and nothing else."""
    for each in nodes_of_kind(file.tree, ast.ClassDef):
        is_given = any(word.arg is None for word in nodes_of_kind(each, ast.keyword))  # **options
        if len(each.bases) == 1 and is_of_rclpy(file, each.bases[0]) and not is_given:
            yield each


def own_reads(file: PythonFile, owner: ast.ClassDef) -> Iterator[int]:
    """Yield where the names of the parameters begin that a class gets by `self.get_parameter`."""
    for call in nodes_of_kind(owner, ast.Call):
        match call:
            case ast.Call(func=ast.Attribute(value=ast.Name(id="self")), args=[name, *_]):
                yield file.span(name).start
