"""Names that modules of Python's standard library do not have: `os.path.joint`, `from xml.etree import ET`."""

from __future__ import annotations

import ast
from collections.abc import Collection, Iterator

from ...languages.python.attributes import attribute_span
from ...languages.python.called_modules import is_bound
from ...languages.python.file import PythonFile
from ...languages.python.guarded_nodes import guarded_nodes
from ...languages.python.nodes import nodes_of_kind
from ...languages.python.place_kinds import is_in_branch
from ...languages.python.version_guards import guarded_by_version
from ...light_dataclasses import dataclass
from ...ros.module_attributes import ATTRIBUTES, BY_PLATFORM, MEANT, OPEN
from ...source import Span
from ...suggest import near_names

PYTHON_2 = frozenset({"itertools.izip", "os.getcwdu", "sys.maxint", "time.clock"})
"""Names that code for both Pythons reads in a branch."""
CATCHING = frozenset({"AttributeError", "ImportError", "Exception", "BaseException"})


@dataclass(frozen=True, slots=True)
class AbsentAttribute:
    """A name that a module does not have."""

    module: str
    name: str
    span: Span
    intended: str
    """The name to write instead; "" where that is not known."""
    raised: str
    root: Span
    """The name that the module has in the file, or the imported one."""

    @property
    def advice(self) -> str:
        return f"; did you mean `{self.intended}`?" if self.intended else "; no version of Python has it there"


def absent_attributes(file: PythonFile, local: Collection[str] = ()) -> Iterator[AbsentAttribute]:
    """Yield each absent name of a module once; none in code that asks for names, for the version of Python, or
    catches that they are missing.

    Modules that are called like a local one are left alone: of a script, its own folder comes first.
    """
    modules = imported_modules(file)
    both = [*absent_imports(file), *(read_from(file, modules) if modules else ())]
    found = [(node, each) for node, each in both if each.module.partition(".")[0] not in local]
    asks = found and any(each.id in ("hasattr", "setattr") for each in nodes_of_kind(file.tree, ast.Name))
    guarded = frozenset((*guarded_nodes(file.tree.body, CATCHING), *guarded_by_version(file)) if found else ())
    reported: set[tuple[str, str]] = set()
    for node, each in found:
        in_vain = not each.intended or f"{each.module}.{each.name}" in PYTHON_2 or each.span == each.root
        is_old = in_vain and is_in_branch(file, each.span)
        if not (asks or is_old) and id(node) not in guarded and (each.module, each.name) not in reported:
            reported.add((each.module, each.name))
            yield each


def imported_modules(file: PythonFile) -> dict[str, str]:
    """Return the modules that names of a file stand for, where no other import binds these."""
    found: dict[str, str] = {}
    for node in nodes_of_kind(file.tree, ast.Import):
        for alias in node.names:
            name = alias.name if alias.asname else alias.name.partition(".")[0]
            known = found.setdefault(alias.asname or name, name)
            if known != name:
                found[alias.asname or name] = ""
    taken = {alias.asname or alias.name for node in nodes_of_kind(file.tree, ast.ImportFrom) for alias in node.names}
    usable = {name: module for name, module in found.items() if module in ATTRIBUTES and name not in taken}
    return {} if "*" in taken else usable


def read_from(file: PythonFile, modules: dict[str, str]) -> Iterator[tuple[ast.AST, AbsentAttribute]]:
    stored = {each.attr for each in nodes_of_kind(file.tree, ast.Attribute) if not isinstance(each.ctx, ast.Load)}
    for node in nodes_of_kind(file.tree, ast.Attribute):
        module = module_of(node.value, modules)
        if not module or node.attr in stored or not is_absent(module, node.attr):
            continue
        root = root_of(node)
        if not is_bound(file, root.id):
            span, near = attribute_span(file, node), meant_by(module, node.attr)
            yield node, AbsentAttribute(module, node.attr, span, near, "AttributeError", file.span(root))


def absent_imports(file: PythonFile) -> Iterator[tuple[ast.AST, AbsentAttribute]]:
    for node in nodes_of_kind(file.tree, ast.ImportFrom):
        for alias in node.names if not node.level and node.module else ():
            module = node.module or ""
            if is_absent(module, alias.name):
                start = file.span(alias).start
                span = Span(start, start + len(alias.name))
                yield node, AbsentAttribute(module, alias.name, span, meant_by(module, alias.name), "ImportError", span)


def module_of(node: ast.expr, modules: dict[str, str]) -> str:
    """Return the module that an expression is: `os.path` of `os.path.join`."""
    if isinstance(node, ast.Attribute):
        around = module_of(node.value, modules)
        return f"{around}.{node.attr}" if around and f"{around}.{node.attr}" in ATTRIBUTES else ""
    return modules.get(node.id, "") if isinstance(node, ast.Name) else ""


def root_of(node: ast.expr) -> ast.Name:
    """Return the name that an attribute of a module begins with."""
    while isinstance(node, ast.Attribute):
        node = node.value
    assert isinstance(node, ast.Name)
    return node


def is_absent(module: str, name: str) -> bool:
    """Return whether no version of a module has a name, on any platform."""
    if module not in ATTRIBUTES or name in ATTRIBUTES[module] or name.startswith("_") or name == "*":
        return False
    return bool(meant_by(module, name)) or not (module in OPEN or (module in BY_PLATFORM and name.isupper()))


def meant_by(module: str, name: str) -> str:
    """Return what an absent name is a slip of, or where it is; "" where that is not certain."""
    if f"{module}.{name}" in MEANT:
        return MEANT[f"{module}.{name}"]
    alike = (each for each in ATTRIBUTES[module] if each.islower() == name.islower() and not each.isupper())
    near = near_names(name, alike, 1) if len(name) > 3 and not name.isupper() else []
    return f"{module}.{near[0]}" if len(near) == 1 else ""
