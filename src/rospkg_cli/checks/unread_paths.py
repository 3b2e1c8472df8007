"""Rule input: paths that Python code puts into a variable, a constant or a member that nothing reads."""

from __future__ import annotations

import ast
import posixpath
from collections.abc import Iterator
from functools import cached_property

from ..languages.python.attributes import is_of_self
from ..languages.python.bound_again import bound_again, members_bound_again
from ..languages.python.file import PythonFile
from ..languages.python.nodes import FunctionNode, last_name, nodes_below, nodes_of, nodes_of_kind
from ..light_dataclasses import dataclass
from ..package.install_table import InstallTable
from ..package.python.share_paths import SHARE
from ..package.workspace import Workspace
from ..source import Span
from .python.named_definitions import is_open
from .python.run_imports import RunImports

OPENS_NOTHING = SHARE | frozenset(
    {"join", "joinpath", "Path", "PurePath", "str", "expanduser", "abspath", "normpath", "dirname", "format"}
)
"""Calls that make a path and look at no file."""
DYNAMIC = frozenset({"locals", "vars", "globals", "eval", "exec"})
"""What may read a variable whose name does not stand there."""


@dataclass(frozen=True)
class UnreadPaths:
    run: RunImports
    workspace: Workspace | None = None
    table: InstallTable | None = None

    def has(self, path: str, span: Span) -> bool:
        """Return whether all that becomes of a path is a value that nothing reads."""
        file = self.run.modules.at(path) if path.endswith(".py") else None
        if file is None or self.is_bound_away(file, span):
            return file is not None
        for owner, target, value in assigned(file):
            if file.span(value).holds(span) and opens_nothing(value):
                return self.is_unread(file, owner, target)
        return self.is_left_constant(file, span)

    def is_bound_away(self, file: PythonFile, span: Span) -> bool:
        """Return whether a name or a member is given something else before anything reads a path."""
        values = (*(each.value for each in bound_again(file)), *members_bound_again(file))
        return any(file.span(each).holds(span) and opens_nothing(each) for each in values)

    def is_left_constant(self, file: PythonFile, span: Span) -> bool:
        """Return whether a path is all that a constant of a module or a class has, and no code of the run reads it.

        What a library has is for others: the package must have programs.
        """
        if self.table is None or not any(True for _ in self.table.of("executable")):
            return False
        closed = (each for each in nodes_of_kind(file.tree, ast.ClassDef) if not is_open(file, each, ()))
        for each in (*file.tree.body, *(each for owner in closed for each in owner.body)):
            match each:
                case ast.Assign(targets=[ast.Name(id=name)], value=value) if file.span(value).holds(span):
                    return opens_nothing(value) and not self.may_be_read(file, name)
        return False

    def may_be_read(self, file: PythonFile, name: str) -> bool:
        """Return whether any code of the run has a name elsewhere than where it is bound, or takes all of a module."""
        loads = (each for each in nodes_of_kind(file.tree, ast.Name) if isinstance(each.ctx, ast.Load))
        imports = (each for _, one in self.run.files for each in one.imports)
        stem = posixpath.basename(file.path).removesuffix(".py")
        whole = {each for module, each in self.taken_elsewhere if each or module.rpartition(".")[2] == stem}
        taken = {each for one in imports for each in one.names} | whole
        is_taken = not taken.isdisjoint((name, "", "*")) or name in self.read
        return is_taken or any(each.id in (name, *DYNAMIC) for each in loads)

    @cached_property
    def taken_elsewhere(self) -> frozenset[tuple[str, str]]:
        """What packages take out of modules, each with the module; "" where they import all of one."""
        others = self.workspace.packages if self.workspace is not None else ()
        return frozenset(each for facts in others for each in facts.taken_names)

    def is_unread(self, file: PythonFile, owner: FunctionNode, target: ast.expr) -> bool:
        """Return whether nothing reads a name in its function, or a member in the package, and it is bound once."""
        if isinstance(target, ast.Name):
            uses = [each for each in nodes_of_kind(owner, ast.Name) if each.id == target.id]
            shared = (each for each in nodes_below(owner) if isinstance(each, ast.Global | ast.Nonlocal))
            return len(uses) == 1 and not is_dynamic(owner) and not any(target.id in each.names for each in shared)
        around = [each for each in nodes_of_kind(file.tree, ast.ClassDef) if owner in each.body]
        is_closed = len(around) == 1 and not is_open(file, around[0], ())  # a base of others may read it
        return is_of_self(target) and is_closed and target.attr not in self.read

    @cached_property
    def read(self) -> frozenset[str]:
        """The attributes that any code of the package reads, and the texts that may name one."""
        nodes = [node for _, file in self.run.files for node in nodes_of(file.tree)]
        texts = (each.value for each in nodes if isinstance(each, ast.Constant) and isinstance(each.value, str))
        members = (each.attr for each in nodes if isinstance(each, ast.Attribute) and isinstance(each.ctx, ast.Load))
        return frozenset((*texts, *members))


def assigned(file: PythonFile) -> Iterator[tuple[FunctionNode, ast.expr, ast.expr]]:
    """Yield the innermost functions with what they bind once and to what."""
    functions = [each for each in nodes_of(file.tree) if isinstance(each, FunctionNode)]
    for owner in reversed(functions):
        for each in nodes_below(owner):
            match each:
                case (
                    ast.Assign(targets=[target], value=value) | ast.AnnAssign(target=target, value=ast.expr() as value)
                ):
                    yield owner, target, value


def opens_nothing(value: ast.expr) -> bool:
    calls = (each for each in (value, *nodes_below(value)) if isinstance(each, ast.Call))
    return all(last_name(each.func) in OPENS_NOTHING for each in calls)


def is_dynamic(owner: FunctionNode) -> bool:
    return any(last_name(each.func) in DYNAMIC for each in nodes_of_kind(owner, ast.Call))
