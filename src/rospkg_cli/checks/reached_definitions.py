"""Rule input: the functions, methods and classes of a package that its programs use, as far as names show."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property

from ..languages.python.file import PythonFile
from ..languages.python.nodes import FunctionNode
from ..light_dataclasses import dataclass
from ..package.file_role import role_of
from ..package.install_table import InstallTable
from ..source import Span
from .python.class_families import class_families
from .python.named_definitions import Named, closed_classes, definitions, takes_no_object
from .python.own_names import SELF, own_names
from .python.run_imports import RunImports
from .python.switches import Switches
from .started_by_path import StartedByPath

OF_MODULES = ("__getattr__", "__dir__")
"""Functions of a module that Python calls; other names with `__` count only in classes."""
SHAPING = frozenset(
    "staticmethod classmethod property setter getter deleter cached_property cache lru_cache abstractmethod final "
    "override overload dataclass total_ordering contextmanager no_type_check typechecked jit njit".split()
)
"""Decorators that neither call what they decorate nor register it for a call."""


@dataclass(frozen=True)
class ReachedDefinitions:
    run: RunImports
    table: InstallTable
    by_path: StartedByPath

    def leads_to(self, file: PythonFile, span: Span) -> bool:
        """Return whether programs lead to all definitions around a place in a function, as far as names tell.

        A mention of its name leads to a definition. Without programs, whoever imports a module calls what is there.
        The body of a class runs wherever the class stands.
        """
        around = [each for each in self.of_files.get(file.path, ()) if file.span(each.node).holds(span)]
        bodies = (each.node.body[0] for each in around if isinstance(each.node, FunctionNode))
        is_inside = any(file.span(first).start <= span.start for first in bodies)
        return not is_inside or all(id(each.node) in self.reached for each in around)

    def is_turned_off(self, file: PythonFile, span: Span) -> bool:
        """Return whether a place is under a switch that nothing throws: `TESTING = False`."""
        statements, choices = self.switches.statements(file), self.switches.choices(file)
        return any(file.span(each).holds(span) for part in (statements, choices) for each in part)

    @cached_property
    def switches(self) -> Switches:
        return Switches(file for _, file in self.run.files)

    @cached_property
    def families(self) -> dict[str, str]:
        return class_families(file for _, file in self.run.files)

    @cached_property
    def of_files(self) -> dict[str, tuple[Named, ...]]:
        files = [file for _, file in self.run.files]
        return {file.path: tuple(definitions(file, self.switches.turned_off(file), self.closed)) for file in files}

    @cached_property
    def closed(self) -> frozenset[str]:
        return closed_classes(file for _, file in self.run.files)

    def is_entry(self, path: str, name: str) -> bool:
        entries = self.by_path.entries
        return (path, name) in entries or ("", name) in entries

    def unrun(self, file: PythonFile) -> frozenset[int]:
        """Return the identities of nodes that never run: under a switch, or in a `__main__` block of a module."""
        return self.switches.turned_off(file) | self.by_path.in_vain(file)

    @cached_property
    def reached(self) -> frozenset[int]:
        """The identities of the definitions that programs use."""
        every: dict[str, list[Named]] = {}
        for each in (one for found in self.of_files.values() for one in found):
            if each.owner or not each.node.name.startswith("__") or each.node.name in OF_MODULES:
                every.setdefault(each.node.name, []).append(each)
        waiting = [each for path, found in self.of_files.items() for each in found if self.is_start(path, each)]
        names = {(file, name) for _, file in self.run.files for name in own_names(file, file.tree, self.unrun(file))}
        waiting += [each for file, name in names for each in self.led_to_by(file, name, every)]
        found: set[int] = set()
        while waiting:
            each = waiting.pop()
            if id(each.node) not in found:
                found.add(id(each.node))
                waiting += each.by_others
                waiting += [one for name in each.names for one in self.led_to(each, name, every)]
        return frozenset(found)

    def led_to_by(self, file: PythonFile, name: str, every: Mapping[str, Sequence[Named]]) -> Iterable[Named]:
        """Return the definitions that a name means at the top level of a file: `main` is its own one, if it has one."""
        found = definitions_named(name.removeprefix(SELF), every)
        own = self.of_files[file.path] if name in file.functions else ()
        return [each for each in own if each.node.name == name] or found

    def led_to(self, each: Named, name: str, every: Mapping[str, Sequence[Named]]) -> Iterator[Named]:
        """Yield the definitions that a name means where it stands: `self.go` is a member of the class or its kin."""
        bare = name.removeprefix(SELF)
        is_own = bare != name and each.around in self.families
        for one in definitions_named(bare, every):
            if not is_own or self.families.get(one.owner) == self.families[each.around]:
                yield one

    def is_start(self, path: str, each: Named) -> bool:
        """Return whether a definition counts as called: by a decorator, a framework, or who imports the package."""
        has_programs = bool(self.by_path.entries) or any(True for _ in self.table.of("executable"))
        is_called = each.node.name.startswith("generate_") or self.is_test(path, each)  # by ros2 launch, by pytest
        is_called = is_called or self.is_entry(path, each.node.name)
        return registers(each.node.decorator_list) or is_called or not (has_programs or takes_no_object(each))

    def is_test(self, path: str, each: Named) -> bool:
        """Return whether pytest calls a definition: in the files that it collects, also in a `TestCase` of any name."""
        is_case = isinstance(each.node, ast.ClassDef) and any(
            "TestCase" in ast.unparse(base) for base in each.node.bases
        )
        if is_case and is_collected(path):
            return True
        is_of_tests = not each.owner or each.owner.startswith("Test") or each.owner not in self.closed
        return is_collected(path) and is_of_tests and each.node.name.startswith(("test", "Test"))


def registers(decorators: Iterable[ast.expr]) -> bool:
    """Return whether decorators may call a definition, or hand it to something that does."""
    names = (ast.unparse(each).partition("(")[0].rpartition(".")[2] for each in decorators)
    return any(name not in SHAPING for name in names)


def is_collected(path: str) -> bool:
    """Return whether pytest looks for tests in a file."""
    name = path.rpartition("/")[2]
    return role_of(path) == "test" or name.startswith("test_") or name.endswith("_test.py")


def definitions_named(name: str, every: Mapping[str, Sequence[Named]]) -> Iterator[Named]:
    """Yield the definitions that a name may refer to; one with `_` at its end may be the beginning of a longer name."""
    yield from every.get(name, ())
    if name.endswith("_") and name.strip("_"):
        yield from (each for full, found in every.items() if full.startswith(name) for each in found)
