"""The imports of a Python file, and under what conditions each of them runs."""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterable, Iterator

from ...lazy_regex import regex
from ...light_dataclasses import dataclass, replace
from ...source import Span
from .import_conditions import (
    asked,
    depends_on_platform,
    handles_import_error,
    is_type_checking,
    suppresses_import_error,
)
from .linux_truth import holds_on_linux
from .nodes import children_of
from .syntax import PythonSyntax

WITHOUT_IMPORTS = frozenset({
    ast.Assign, ast.AugAssign, ast.AnnAssign, ast.Expr, ast.Return, ast.Raise, ast.Assert, ast.Delete, ast.Pass,
    ast.arguments, ast.withitem, ast.keyword,
})  # fmt: skip
"""The statements that hold no others, and parts of the others."""
MODULE = regex(r"from[\s\\]*(\.*(?:[\s\\]*(?!import\b)[^\W\d][\w.]*)?)")


@dataclass(frozen=True, slots=True)
class Import:
    """One imported module: `import a.b` and `from .a import b, c` are one each, `import a, b` are two."""

    module: str
    """Without the leading dots; "" in `from . import x`."""
    names: tuple[str, ...]
    """What `from` takes out of it, `*` included; empty for a plain import."""
    level: int
    """The number of leading dots."""
    span: Span
    """Of the module's name (of the dots and the name)."""
    is_optional: bool = False
    """In a `try` that survives an ImportError or its handler, or under a condition on the platform."""
    is_for_typing: bool = False
    """Under `if TYPE_CHECKING`."""
    is_local: bool = False
    """In a function."""
    bound: tuple[str, ...] = ()
    """What the file calls each of the names: `b` of `from a import c as b`."""

    def optional(self) -> Import:
        return replace(self, is_optional=True)


@dataclass(frozen=True, slots=True)
class ImportReader:
    """Reads the imports of one file; `fixed` returns what a condition in it always is, None where it may be both."""

    file: PythonSyntax
    fixed: Callable[[ast.expr], bool | None]

    def all(self) -> Iterator[Import]:
        """Yield every import, wherever it is, in order."""
        return self.imports_in(self.file.tree.body, Import("", (), 0, Span(0, 0)))

    def imports_in(self, body: Iterable[ast.AST], under: Import) -> Iterator[Import]:
        """Yield the imports below statements; `under` has the conditions that hold for all of them."""
        for node in body:
            if node.__class__ in WITHOUT_IMPORTS or isinstance(node, ast.expr):
                continue
            match node:
                case ast.Import() | ast.ImportFrom():
                    yield from self.imported(node, under)
                case ast.FunctionDef() | ast.AsyncFunctionDef():
                    inner = Import("", (), 0, under.span, under.is_optional, under.is_for_typing, True)
                    yield from self.imports_in(children_of(node), inner)
                case ast.Try():
                    survives = under.is_optional or any(handles_import_error(handler) for handler in node.handlers)
                    inner = Import("", (), 0, under.span, survives, under.is_for_typing, under.is_local)
                    yield from self.imports_in([*node.body, *node.handlers, *node.orelse], inner)
                    yield from self.imports_in(node.finalbody, under)
                case ast.If() | ast.While() if (always := self.fixed(node.test)) is not None:
                    yield from self.imports_in(node.body if always else node.orelse, under)
                case ast.If():
                    yield from self.in_branches(node, under)
                case ast.With(items=items) if any(suppresses_import_error(item.context_expr) for item in items):
                    inner = Import("", (), 0, under.span, True, under.is_for_typing, under.is_local)
                    yield from self.imports_in(node.body, inner)
                case ast.stmt() | ast.ExceptHandler() | ast.match_case():
                    yield from self.imports_in(children_of(node), under)

    def imported(self, node: ast.Import | ast.ImportFrom, under: Import) -> Iterator[Import]:
        """Yield what one statement imports."""
        conditions = (under.is_optional, under.is_for_typing, under.is_local)
        if isinstance(node, ast.Import):
            for alias in node.names:
                name = Span(start := self.file.span(alias).start, start + len(alias.name))
                yield Import(alias.name, (), 0, name, *conditions)
            return
        names = tuple(alias.name for alias in node.names)
        bound = tuple(alias.asname or alias.name for alias in node.names)
        yield Import(node.module or "", names, node.level, module_span(self.file, node), *conditions, bound)

    def in_branches(self, node: ast.If, under: Import) -> Iterator[Import]:
        """Yield the imports in the branches of a condition that may be both."""
        typing = under.is_for_typing or is_type_checking(node.test)
        on_linux = holds_on_linux(node.test)
        optional = [
            under.is_optional or (depends_on_platform(node.test) and on_linux is not runs) for runs in (True, False)
        ]
        inner = Import("", (), 0, under.span, optional[0], typing, under.is_local)
        other = Import("", (), 0, under.span, optional[1], under.is_for_typing, under.is_local)
        for branch, holds in ((node.body, inner), (node.orelse, other)):
            for each in self.imports_in(branch, holds):
                yield each.optional() if each.module.partition(".")[0] in asked(node.test) else each


def module_span(file: PythonSyntax, node: ast.ImportFrom) -> Span:
    """Return the span of the dots and the name behind `from`."""
    whole = file.span(node)
    match = MODULE.match(file.source.text, whole.start)
    return Span(*match.span(1)) if match else whole
