"""Attributes that a class reads of `self`, and that neither it, its bases nor other code ever sets (DEP117)."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import cached_property

from ...languages.python.attributes import attribute_span
from ...languages.python.class_members import attributes_set, members_bound
from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_of_kind
from ...languages.python.own_reads import own_reads
from ...languages.python.undefined_names import UndefinedName
from ...languages.python.unreached_places import is_unreached
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.file_role import Role
from ...ros.rclpy_names import members_of_nodes
from ...source import Span
from ...suggest import nearest
from .handed_out import is_handed_out
from .own_classes import Line, OwnClass, OwnClasses
from .undefined_uses import UndefinedUses
from .unknown_rclpy_names import UnknownRclpyNames
from .unwritten_parts import LOUD, is_member_unwritten
from .use_times import When

DYNAMIC = regex(r"__[gs]etattr(?:ibute)?__|__dict__|__slots__|\b(?:vars|setattr|exec|locals)\(")
"""Functions by which code sets attributes by computed names."""
ASKING = frozenset({"hasattr", "getattr", "setattr", "delattr", "attrgetter", "methodcaller"})
VERBS = frozenset(
    "add call count create declare describe destroy get has is list register remove resolve set undeclare wait".split()
)


@dataclass(frozen=True, slots=True)
class UnsetMember:
    file: PythonFile
    span: Span
    others: tuple[Span, ...]
    name: str
    owner: str
    better: str
    """What may be intended; "" where that is unknown, "Node" where the class has no base and uses what nodes have."""
    when: When
    is_unwritten: bool = False
    """Whether a comment says that it is still to be written."""


@dataclass(frozen=True)
class UnsetMembers:
    uses: UndefinedUses

    def all(self) -> Iterator[UnsetMember]:
        """Yield each name once a class."""
        roles = {file.path: role for role, file in self.uses.files}
        for owner in self.classes.all:
            is_asked = owner.file.path in roles and self.classes.has_objects(owner)
            line = self.classes.line(owner) if is_asked else None
            if line is not None and not self.is_dynamic(line):
                yield from self.of(owner, line, roles[owner.file.path])

    def of(self, owner: OwnClass, line: Line, role: Role) -> Iterator[UnsetMember]:
        reads = [each for each in own_reads(owner.node) if each.attr not in self.stored | self.asked]
        if not reads:
            return
        file, own = owner.file, {name for each in line.classes for name in members_bound(each.node.body)}
        known = own | {name for each in self.classes.heirs(owner.node.name) for name in members_bound(each.node.body)}
        known |= self.misspelt(file)
        places: dict[str, list[ast.Attribute]] = {}
        for each in reads:
            is_known = each.attr in known or (line.is_node and may_be_of_node(each.attr))
            if not is_known and not is_unreached(file, file.span(each.value)):
                is_of_node = not line.is_node and each.attr in members_of_nodes()
                places.setdefault("" if is_of_node else each.attr, []).append(each)
        certain = self.uses.places.certain.spans(file) if places else ()
        for name, found in places.items():
            first = next((each for each in found if file.span(each.value) in certain), found[0])
            span = attribute_span(file, first)
            others = tuple(attribute_span(file, each) for each in found if each is not first)
            use = UndefinedName(first.attr, file.span(first.value), frozenset())
            better = (nearest(name, frozenset(own | stored_in(line))) if name else "Node") or ""
            when = self.uses.times.of_attribute(role, file, use, certain)
            is_left = when in LOUD and is_member_unwritten(file, owner.node, name, (span, *others))
            yield UnsetMember(file, span, others, first.attr, owner.node.name, better, when, is_left)

    def misspelt(self, file: PythonFile) -> set[str]:
        """Return the names that are nearly one of a node's, which another rule reports."""
        return {each.attr for each, _, _ in UnknownRclpyNames(self.uses).of_nodes(file)}

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
        return is_set or any(is_handed_out(each, self.uses.installed) for each in line.classes)

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


def stored_in(line: Line) -> set[str]:
    return {name for each in line.classes for name in attributes_set(each.node)}
