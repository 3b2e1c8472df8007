"""What a class reads of its own objects, and that neither it, its bases nor other code ever sets (DEP117)."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import cached_property

from ...languages.python.attributes import attribute_span
from ...languages.python.file import PythonFile
from ...languages.python.guarded_nodes import guarded_nodes
from ...languages.python.nodes import FunctionNode, children_of, nodes_of, nodes_of_kind
from ...languages.python.undefined_names import UndefinedName
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.file_role import Role
from ...ros.imports import STANDARD
from ...ros.names import BUILT_IN
from ...ros.rclpy_names import members_of_nodes
from ...source import Span
from ...suggest import nearest
from .own_classes import Line, OwnClass, OwnClasses
from .undefined_uses import UndefinedUses, When
from .unknown_rclpy_names import UnknownRclpyNames

DYNAMIC = regex(r"__[gs]etattr(?:ibute)?__|__dict__|__slots__|\b(?:vars|setattr|exec|locals)\(")
"""How code sets attributes by names that it makes."""
ASKING = frozenset({"hasattr", "getattr", "setattr", "delattr", "attrgetter", "methodcaller"})
VERBS = frozenset(
    "add call count create declare describe destroy get has is list register remove resolve set undeclare wait".split()
)
FILLING = frozenset({"setupUi", "setup_ui", "loadUi", "load_ui"})


@dataclass(frozen=True, slots=True)
class UnsetMember:
    file: PythonFile
    span: Span
    others: tuple[Span, ...]
    name: str
    owner: str
    better: str
    """What may be meant; "" where that is unknown, "Node" where the class has no base and uses what nodes have."""
    when: When


@dataclass(frozen=True)
class UnsetMembers:
    uses: UndefinedUses

    def all(self) -> Iterator[UnsetMember]:
        """Yield each name once a class."""
        roles = {file.path: role for role, file in self.uses.files}
        for owner in self.classes.all:
            line = self.classes.line(owner) if owner.file.path in roles else None
            if line is not None and self.classes.has_objects(owner) and not self.is_dynamic(line):
                yield from self.of(owner, line, roles[owner.file.path])

    def of(self, owner: OwnClass, line: Line, role: Role) -> Iterator[UnsetMember]:
        reads = [each for each in self.reads(owner) if each.attr not in self.stored | self.asked]
        if not reads:
            return
        file, own = owner.file, {name for each in line.classes for name in bound_in(each.node.body)}
        known = own | {name for each in self.classes.heirs(owner.node.name) for name in bound_in(each.node.body)}
        known |= self.told(file)
        places: dict[str, list[ast.Attribute]] = {}
        for each in reads:
            if each.attr not in known and not (line.is_node and may_be_of_node(each.attr)):
                is_of_node = not line.is_node and each.attr in members_of_nodes()
                places.setdefault("" if is_of_node else each.attr, []).append(each)
        certain = self.uses.certain_spans(file) if places else ()
        for name, found in places.items():
            first = next((each for each in found if file.span(each.value) in certain), found[0])
            span = attribute_span(file, first)
            others = tuple(attribute_span(file, each) for each in found if each is not first)
            use = UndefinedName(first.attr, file.span(first.value), frozenset())
            better = (nearest(name, frozenset(own | stored_in(line))) if name else "Node") or ""
            when = self.uses.of_attribute(role, file, use, certain)
            yield UnsetMember(file, span, others, first.attr, owner.node.name, better, when)

    def told(self, file: PythonFile) -> set[str]:
        """Return the names that are nearly one of a node's, which another rule tells."""
        return {each.attr for each, _, _ in UnknownRclpyNames(self.uses).of_nodes(file)}

    def reads(self, owner: OwnClass) -> Iterator[ast.Attribute]:
        """Yield the attributes that methods read of their object, but for those that code is ready to miss."""
        ready = set(guarded_nodes([owner.node], {"AttributeError"}))
        for method in owner.node.body:
            if not isinstance(method, FunctionNode) or not method.args.args or is_static(method):
                continue
            own = method.args.args[0].arg
            if own != "self" or rebinds(method, own):
                continue
            for each in below(method):
                node = each.target if isinstance(each, ast.AugAssign) else each
                is_read = node is not each or (isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Load))
                match node:
                    case ast.Attribute(value=ast.Name(id=name)) if name == own and is_read:
                        if id(node) not in ready and not node.attr.startswith("__"):
                            yield node

    @cached_property
    def classes(self) -> OwnClasses:
        return OwnClasses(self.uses.run, self.uses.installed)

    @cached_property
    def dynamic(self) -> tuple[PythonFile, ...]:
        return tuple(file for _, file in self.uses.run.files if DYNAMIC.search(file.source.text))

    def is_dynamic(self, line: Line) -> bool:
        """Return whether code that has or names a class, or a base of it, sets attributes by made names."""
        names = {each.node.name for each in line.classes}
        is_set = any(name in file.source.text for file in self.dynamic for name in names)
        return is_set or any(self.is_handed_out(each) for each in line.classes)

    def is_handed_out(self, owner: OwnClass) -> bool:
        """Return whether a class hands its object to a library that may fill it: `Machine(model=self)`, `setupUi`."""
        imported = dict(imported_from(owner.file))
        for call in nodes_of_kind(owner.node, ast.Call):
            if any(is_self(each) for each in (*call.args, *(keyword.value for keyword in call.keywords))):
                *_, root = chain(call.func)
                top = imported.get(root, "").partition(".")[0]
                is_known = top in STANDARD or top in self.uses.installed.tops or BUILT_IN.is_package(top)
                if not (is_known or top == "") or chain(call.func)[0] in FILLING:
                    return True
        return False

    @cached_property
    def stored(self) -> frozenset[str]:
        """Every attribute that code of the package sets, of whatever object; `+=` sets none that is not there."""
        return frozenset(name for _, file in self.uses.run.files for name in attributes_set(file.tree))

    @cached_property
    def asked(self) -> frozenset[str]:
        """The names that code asks for by a string: `hasattr(self, 'name')`."""
        calls = (each for _, file in self.uses.run.files for each in nodes_of_kind(file.tree, ast.Call))
        asking = (each for each in calls if ast.unparse(each.func).rpartition(".")[2] in ASKING)
        return frozenset(
            arg.value
            for call in asking
            for arg in call.args
            if isinstance(arg, ast.Constant) and isinstance(arg.value, str)
        )


def may_be_of_node(name: str) -> bool:
    """Return whether a node has a name, or a newer one may: a verb, behind it words that names of nodes have."""
    words, known = name.split("_"), members_of_nodes()
    of_nodes = {word.removesuffix("s") for each in known for word in each.split("_")}
    is_like_one = len(words) > 1 and words[0] in VERBS and all(word.removesuffix("s") in of_nodes for word in words)
    return name in known or is_like_one


def imported_from(file: PythonFile) -> Iterator[tuple[str, str]]:
    """Yield the names that a file imports, with the modules that they are or come from."""
    for each in nodes_of_kind(file.tree, ast.Import):
        yield from ((alias.asname or alias.name.partition(".")[0], alias.name) for alias in each.names)
    for one in nodes_of_kind(file.tree, ast.ImportFrom):
        yield from ((alias.asname or alias.name, "" if one.level else one.module or "") for alias in one.names)


def chain(node: ast.expr) -> list[str]:
    """Return the names of an attribute, the last one first: `["spin", "rclpy"]`."""
    names = []
    while isinstance(node, ast.Attribute):
        names.append(node.attr)
        node = node.value
    return [*names, node.id if isinstance(node, ast.Name) else ""]


def is_self(node: ast.expr) -> bool:
    return isinstance(node, ast.Name) and node.id == "self"


def attributes_set(tree: ast.AST) -> Iterator[str]:
    grown = {id(each.target) for each in nodes_of_kind(tree, ast.AugAssign)}
    for each in nodes_of_kind(tree, ast.Attribute):
        if isinstance(each.ctx, ast.Store) and id(each) not in grown:
            yield each.attr


def stored_in(line: Line) -> set[str]:
    return {name for each in line.classes for name in attributes_set(each.node)}


def bound_in(body: list[ast.stmt]) -> Iterator[str]:
    """Yield what the body of a class binds, also in branches."""
    for node in below_statements(body):
        match node:
            case ast.FunctionDef(name=name) | ast.AsyncFunctionDef(name=name) | ast.ClassDef(name=name):
                yield name
            case ast.Name(id=name, ctx=ast.Store()):
                yield name
            case ast.alias():
                yield (node.asname or node.name).partition(".")[0]


def below_statements(body: list[ast.stmt]) -> Iterator[ast.AST]:
    waiting: list[ast.AST] = [*body]
    while waiting:
        node = waiting.pop()
        yield node
        waiting += [] if isinstance(node, FunctionNode | ast.ClassDef | ast.Lambda) else children_of(node)


def below(method: FunctionNode) -> Iterator[ast.AST]:
    """Yield the nodes of a method, without those of classes in it and of functions that have a `self` of their own."""
    waiting: list[ast.AST] = [*method.body]
    while waiting:
        node = waiting.pop()
        if isinstance(node, ast.ClassDef) or (isinstance(node, FunctionNode) and has_own_self(node)):
            continue
        yield node
        waiting += children_of(node)


def has_own_self(function: FunctionNode) -> bool:
    return any(each.arg == "self" for each in function.args.args)


def rebinds(method: FunctionNode, name: str) -> bool:
    return any(n.id == name and isinstance(n.ctx, ast.Store) for n in nodes_of(method) if isinstance(n, ast.Name))


def is_static(method: FunctionNode) -> bool:
    return any(ast.unparse(each) in ("staticmethod", "classmethod") for each in method.decorator_list)
