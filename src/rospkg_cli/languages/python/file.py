"""A Python file: its imports, and the names at its top level."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator, Mapping
from functools import cached_property
from weakref import ref

from ...lazy_regex import regex
from ...light_dataclasses import dataclass, replace
from ...source import Source, Span
from .constant_truth import constant_truth
from .dynamic_names import has_dynamic_names
from .linux_truth import holds_on_linux
from .nodes import children_of, nodes_of
from .syntax import PythonSyntax, parse

IMPORT_ERRORS = frozenset({"ImportError", "ModuleNotFoundError", "Exception", "BaseException"})
PLATFORM = frozenset({"sys", "os", "platform", "find_spec", "environ"})
STARTERS = frozenset({"spin", "run", "exec", "exec_", "mainloop", "main"})
"""Methods that do not return before the program ends: `rclpy.spin(node)`, `app.exec()`."""
WITHOUT_IMPORTS = frozenset({
    ast.Assign, ast.AugAssign, ast.AnnAssign, ast.Expr, ast.Return, ast.Raise, ast.Assert, ast.Delete, ast.Pass,
    ast.arguments, ast.withitem, ast.keyword,
})  # fmt: skip
"""The statements that hold no others, and parts of the others."""
NEW_SCOPES = frozenset({ast.Lambda, ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp})
BINDERS = NEW_SCOPES | {
    ast.Name, ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef, ast.Import, ast.ImportFrom,
    ast.MatchAs, ast.MatchStar, ast.MatchMapping,
}  # fmt: skip
"""What binds a name in its scope, or none of it."""
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


@dataclass(frozen=True)
class PythonFile(PythonSyntax):
    """A Python file."""

    @cached_property
    def imports(self) -> tuple[Import, ...]:
        """Every import, wherever it stands, in order."""
        return tuple(self.imports_in(self.tree.body, Import("", (), 0, Span(0, 0))))

    def imports_in(self, body: Iterable[ast.AST], under: Import) -> Iterator[Import]:
        """Yield the imports below statements; `under` carries what holds for all of them."""
        for node in body:
            if node.__class__ in WITHOUT_IMPORTS or isinstance(node, ast.expr):
                continue
            match node:
                case ast.Import():
                    for alias in node.names:
                        name = Span(start := self.span(alias).start, start + len(alias.name))
                        yield Import(alias.name, (), 0, name, under.is_optional, under.is_for_typing, under.is_local)
                case ast.ImportFrom():
                    names = tuple(alias.name for alias in node.names)
                    module, span = node.module or "", self.module_span(node)
                    bound = tuple(alias.asname or alias.name for alias in node.names)
                    under_what = (under.is_optional, under.is_for_typing, under.is_local)
                    yield Import(module, names, node.level, span, *under_what, bound)
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
                    typing = under.is_for_typing or is_type_checking(node.test)
                    on_linux = holds_on_linux(node.test)
                    optional = [
                        under.is_optional or (depends_on_platform(node.test) and on_linux is not runs)
                        for runs in (True, False)
                    ]
                    inner = Import("", (), 0, under.span, optional[0], typing, under.is_local)
                    other = Import("", (), 0, under.span, optional[1], under.is_for_typing, under.is_local)
                    for branch, holds in ((node.body, inner), (node.orelse, other)):
                        for each in self.imports_in(branch, holds):
                            yield each.optional() if each.module.partition(".")[0] in asked(node.test) else each
                case ast.With(items=items) if any(suppresses_import_error(item.context_expr) for item in items):
                    inner = Import("", (), 0, under.span, True, under.is_for_typing, under.is_local)
                    yield from self.imports_in(node.body, inner)
                case ast.stmt() | ast.ExceptHandler() | ast.match_case():
                    yield from self.imports_in(children_of(node), under)

    def fixed(self, test: ast.expr) -> bool | None:
        """Return what a condition always is; not of one on the system: an import may be for the others."""
        return None if depends_on_platform(test) else constant_truth(test, self.constants)

    @cached_property
    def constants(self) -> Mapping[str, bool]:
        """What each name is as a truth that the top level alone binds, and to a constant: `DEBUG = False`."""
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

    def module_span(self, node: ast.ImportFrom) -> Span:
        whole = self.span(node)
        match = MODULE.match(self.source.text, whole.start)
        return Span(*match.span(1)) if match else whole

    @cached_property
    def definitions(self) -> dict[str, Span]:
        """The names bound at the top level, also under `if`, `try`, `for` and `with`, and where first."""
        found: dict[str, Span] = {}
        for name, node in bindings(self.tree.body, has_globals="global" in self.source.text):
            found.setdefault(name, self.span(node))
        return found

    @cached_property
    def functions(self) -> dict[str, Span]:
        """The functions defined at the very top level, and where the name of each stands."""
        found: dict[str, Span] = {}
        for node in self.tree.body:
            if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
                start = self.source.text.index(node.name, self.span(node).start + len("def "))
                found[node.name] = Span(start, start + len(node.name))
        return found

    @cached_property
    def runs_when_imported(self) -> bool:
        """Whether a statement at the top level, not under `if __name__ == …`, starts what the module does."""
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


def statement_calls(body: Iterable[ast.stmt]) -> Iterator[ast.Call]:
    """Yield the calls that are statements of their own where a module is imported."""
    for node in body:
        match node:
            case ast.Expr(value=ast.Call() as call):
                yield call
            case ast.If() if any(isinstance(each, ast.Name) and each.id == "__name__" for each in nodes_of(node.test)):
                continue
            case ast.If() | ast.While() | ast.For():
                yield from statement_calls([*node.body, *node.orelse])
            case ast.Try():
                yield from statement_calls([*node.body, *node.orelse, *node.finalbody])
            case ast.With():
                yield from statement_calls(node.body)


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


def handles_import_error(handler: ast.ExceptHandler) -> bool:
    if handler.type is None:
        return True
    return any(isinstance(node, ast.Name) and node.id in IMPORT_ERRORS for node in nodes_of(handler.type))


def suppresses_import_error(manager: ast.expr) -> bool:
    """Return whether this is contextlib.suppress(ImportError)."""
    return (
        isinstance(manager, ast.Call) and {"suppress"} <= names_in(manager) and bool(names_in(manager) & IMPORT_ERRORS)
    )


def depends_on_platform(test: ast.expr) -> bool:
    """Return whether a condition depends on the platform or the environment: code under it is optional."""
    return bool(names_in(test) & PLATFORM)


def names_in(node: ast.expr) -> set[str]:
    """Return the names and attributes in an expression."""
    names = {each.id for each in nodes_of(node) if isinstance(each, ast.Name)}
    return names | {each.attr for each in nodes_of(node) if isinstance(each, ast.Attribute)}


def asked(test: ast.expr) -> frozenset[str]:
    """Return the strings that a condition asks for by a comparison or a call: `'cv2' in installed()`."""
    if not any(isinstance(node, ast.Compare | ast.Call) for node in nodes_of(test)):
        return frozenset()
    values = (node.value for node in nodes_of(test) if isinstance(node, ast.Constant))
    return frozenset(value for value in values if isinstance(value, str))


def is_type_checking(test: ast.expr) -> bool:
    return (isinstance(test, ast.Name) and test.id == "TYPE_CHECKING") or (
        isinstance(test, ast.Attribute) and test.attr == "TYPE_CHECKING"
    )


def bindings(
    body: Iterable[ast.AST], *, has_globals: bool = True
) -> Iterator[tuple[str, ast.stmt | ast.expr | ast.alias | ast.pattern]]:
    """Yield the names that statements bind in their scope, with the binding node.

    Without `has_globals` no function says `global`: then functions are not looked into.
    """
    waiting = [*body][::-1]
    while waiting:  # without recursion, as every expression is looked through
        node = waiting.pop()
        if node.__class__ not in BINDERS:
            waiting += children_of(node)[::-1]
            continue
        match node:
            case ast.Name():
                if isinstance(node.ctx, ast.Store):
                    yield node.id, node
            case ast.FunctionDef() | ast.AsyncFunctionDef() | ast.ClassDef():
                yield node.name, node
                yield from ((name, node) for name in (global_names(node) if has_globals else ()))
            case ast.Import():
                yield from ((alias.asname or alias.name.partition(".")[0], alias) for alias in node.names)
            case ast.ImportFrom():
                yield from ((alias.asname or alias.name, alias) for alias in node.names if alias.name != "*")
            case ast.MatchAs(name=name) | ast.MatchStar(name=name) | ast.MatchMapping(rest=name):
                waiting += children_of(node)[::-1]
                yield from [(name, node)] if name else []


def global_names(function: ast.AST) -> set[str]:
    return {name for node in nodes_of(function) if isinstance(node, ast.Global) for name in node.names}
