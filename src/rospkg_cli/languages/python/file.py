"""A Python file: its imports, and the names at its top level."""

from __future__ import annotations

import ast
from collections.abc import Mapping
from functools import cached_property
from weakref import ref

from ...light_dataclasses import dataclass
from ...source import Source, Span
from .bindings import bindings
from .constant_truth import constant_truth
from .dynamic_names import has_dynamic_names
from .import_conditions import depends_on_platform
from .imports import Import, ImportReader
from .nodes import nodes_of
from .started_calls import STARTERS, statement_calls
from .syntax import PythonSyntax, parse


@dataclass(frozen=True)
class PythonFile(PythonSyntax):
    """A Python file."""

    @cached_property
    def imports(self) -> tuple[Import, ...]:
        """Every import, wherever it is, in order."""
        return tuple(ImportReader(self, self.fixed).all())

    def fixed(self, test: ast.expr) -> bool | None:
        """Return what a condition always is; None for one on the platform, as an import may be for another one."""
        return None if depends_on_platform(test) else constant_truth(test, self.constants)

    @cached_property
    def constants(self) -> Mapping[str, bool]:
        """Names that only the top level binds, to a constant, with its truth value: `DEBUG = False`."""
        found: dict[str, bool] = {}
        for node in self.tree.body:
            match node:
                case ast.Assign(targets=[ast.Name(id=name)], value=ast.Constant(value=value)):
                    found[name] = bool(value)
        if not found:
            return found
        stored = [n.id for n in nodes_of(self.tree) if isinstance(n, ast.Name) and not isinstance(n.ctx, ast.Load)]
        shared = {name for node in nodes_of(self.tree) if isinstance(node, ast.Global) for name in node.names}
        return {name: value for name, value in found.items() if stored.count(name) == 1 and name not in shared}

    @cached_property
    def definitions(self) -> dict[str, Span]:
        """The names bound at the top level, also under `if`, `try`, `for` and `with`, and where first."""
        found: dict[str, Span] = {}
        for name, node in bindings(self.tree.body, has_globals="global" in self.source.text):
            found.setdefault(name, self.span(node))
        return found

    @cached_property
    def functions(self) -> dict[str, Span]:
        """The functions defined directly at the top level, and where the name of each is."""
        found: dict[str, Span] = {}
        for node in self.tree.body:
            if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
                start = self.source.text.index(node.name, self.span(node).start + len("def "))
                found[node.name] = Span(start, start + len(node.name))
        return found

    @cached_property
    def runs_when_imported(self) -> bool:
        """Whether a statement at the top level, not under `if __name__ == …`, does the work of the module."""
        return any(self.starts(call) for call in statement_calls(self.tree.body))

    def starts(self, call: ast.Call) -> bool:
        name = call.func.attr if isinstance(call.func, ast.Attribute) else ""
        return name in STARTERS or (isinstance(call.func, ast.Name) and call.func.id in self.functions)

    @cached_property
    def star_imports(self) -> tuple[Import, ...]:
        """The modules of which everything is imported at the top level."""
        return tuple(each for each in self.imports if "*" in each.names and not each.is_local)

    @cached_property
    def has_dynamic_names(self) -> bool:
        """Whether the module may have names that are not bound in its text."""
        return "__getattr__" in self.definitions or has_dynamic_names(self.tree)


def parse_python(source: Source) -> PythonFile:
    """Read a Python file, once for each Source that can be read.

    Raises UnreadableError, with `grammar` where a newer Python may well understand it.
    """
    known: ref[PythonFile] | None = vars(source).get("python_file")
    file = known() if known is not None else None
    if file is None:
        file = PythonFile(source, parse(source))
        vars(source)["python_file"] = ref(file)  # weakly: the two could not be freed at once
    return file
