"""Fields that Python code sets or reads and that the message does not have (IDL010)."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Mapping
from functools import cached_property

from ...languages.python.constant_truth import unreached_nodes
from ...languages.python.file import Import, PythonFile
from ...languages.python.guarded_nodes import BLOCKS, guarded_nodes
from ...light_dataclasses import dataclass
from ...ros.interface_fields import ros1_fields
from ...ros.interfaces import CONSTANT_NAME, KINDS
from ...source import Span
from ...suggest import near_names, nearest
from ..fault import Level
from ..python.run_imports import RunImports
from ..python.wrong_calls import CATCHES as TYPE_ERROR
from ..reached_definitions import ReachedDefinitions
from ..reached_modules import ReachedModules
from ..reached_places import ReachedPlaces
from ..repository.older_distribution import OlderDistribution
from .idle_objects import IdleObjects
from .known_interfaces import KnownInterfaces
from .message_classes import MessageClasses, changed_messages, names_interfaces
from .message_scopes import MessageScopes
from .message_variables import Bindings, Environment, held_by
from .seldom_run import is_called_with_care, is_in_handler, is_replaced
from .uncalled_methods import UncalledMethods
from .worded_types import is_told_by_word

GENERATED = frozenset({"get_fields_and_field_types", "SLOT_TYPES", "check_fields"})
CATCHES = frozenset({"AttributeError", "Exception", "BaseException"})


@dataclass(frozen=True, slots=True)
class UnknownField:
    path: str
    span: Span
    """Of the field's name."""
    message: str
    """`package/msg/Name`."""
    name: str
    near: str | None
    is_keyword: bool
    """Whether it is passed to the constructor."""
    is_ros1: bool
    is_by_place: bool = False
    """Whether it is passed to the constructor without a name, which is then empty: that takes none so."""


@dataclass(frozen=True)
class FieldUses:
    known: KnownInterfaces
    run: RunImports
    reached: ReachedModules | None = None
    definitions: ReachedDefinitions | None = None
    distribution: OlderDistribution | None = None
    places: ReachedPlaces | None = None

    def unknown(self) -> Iterator[UnknownField]:
        """Yield the unknown fields of each file, in the order of its text."""
        for file in self.run.running:
            if any(imports_interfaces(each) for each in file.imports) and names_interfaces(file):
                classes = MessageClasses(file)
                found = {each.span: each for each in self.in_file(file, classes)}
                yield from (found[span] for span in sorted(found))

    def level_of(self, use: UnknownField) -> Level | None:
        """Return the level of a keyword that messages do not have: up to Iron they raise, later ones ask for it alone.

        It is None where the pages name none from Jazzy on, and for a field that is set or read: that always raises.
        """
        if not use.is_keyword or self.distribution is None or self.distribution.is_before_jazzy:
            return None
        return "info" if self.distribution.is_from_jazzy_on else "warning"

    def is_left(self, path: str) -> bool:
        """Return whether a file is a module that nothing starts or imports, beside programs."""
        return self.reached is not None and self.reached.is_left(path)

    @cached_property
    def uncalled(self) -> UncalledMethods:
        return UncalledMethods(self.run)

    def is_uncalled(self, use: UnknownField) -> bool:
        """Return whether a use is in a method that no code of the package names."""
        return self.uncalled.has(use.path, use.span)

    def is_unreached(self, use: UnknownField) -> bool:
        """Return whether no program of the package leads to the function around a use."""
        file = self.run.modules.at(use.path)
        return file is not None and self.places is not None and self.places.is_idle(file, use.span)

    def is_late(self, use: UnknownField) -> bool:
        """Return whether a use stands behind a `spin` that Ctrl-C leaves."""
        file = self.run.modules.at(use.path)
        return file is not None and self.places is not None and self.places.is_late(file, use.span)

    def is_ended(self, use: UnknownField) -> bool:
        """Return whether a use stands behind the loop of a constructor."""
        file = self.run.modules.at(use.path)
        return file is not None and self.places is not None and self.places.is_ended(file, use.span)

    def is_unspun(self, use: UnknownField) -> bool:
        """Return whether a use is in a callback of a node that nothing spins."""
        file = self.run.modules.at(use.path)
        return file is not None and self.places is not None and self.places.shown.is_unspun(file, use.span)

    def is_by_path(self, use: UnknownField) -> bool:
        """Return whether only who starts a module by its path comes to a use, which an entry point starts as well."""
        file = self.run.modules.at(use.path)
        return file is not None and self.places is not None and self.places.is_by_path(file, use.span)

    def is_turned_off(self, use: UnknownField) -> bool:
        """Return whether a use is under a switch that nothing throws."""
        file = self.run.modules.at(use.path)
        if file is not None and self.places is not None and self.places.is_off(file, use.span):
            return True
        return file is not None and self.definitions is not None and self.definitions.is_turned_off(file, use.span)

    def is_conditional(self, use: UnknownField) -> bool:
        """Return whether a use is in a branch of its function."""
        return self.places is not None and self.places.is_conditional(use.path, use.span)

    def conditions(self, use: UnknownField) -> int | None:
        """Return how many conditions stand on the shortest way that is shown to a use; None where none is shown."""
        file = self.run.modules.at(use.path)
        return self.places.conditions(file, use.span) if file is not None and self.places is not None else None

    def is_unshown(self, use: UnknownField) -> bool:
        return self.conditions(use) is None

    def is_seldom(self, use: UnknownField) -> bool:
        """Return whether several conditions stand on each way that is shown to a use, if one is."""
        return self.is_under(use, 2)

    def is_at_times(self, use: UnknownField) -> bool:
        """Return whether a condition stands on each way."""
        return self.is_under(use, 1)

    def is_under(self, use: UnknownField, least: int) -> bool:
        conditions = self.conditions(use)
        return conditions is None or conditions >= least

    @cached_property
    def idle(self) -> IdleObjects:
        return IdleObjects(self.run)

    def is_idle(self, use: UnknownField) -> bool:
        """Return whether a use is in a method of an object that is made and never used."""
        return self.idle.has(use.path, use.span)

    def is_in_handler(self, use: UnknownField) -> bool:
        """Return whether a use is in an `except` branch."""
        file = self.run.modules.at(use.path)
        return file is not None and is_in_handler(file, use.span)

    def is_called_with_care(self, use: UnknownField) -> bool:
        """Return whether a use is in a function whose callers catch what it raises."""
        file = self.run.modules.at(use.path)
        return file is not None and is_called_with_care(file, use.span, CATCHES)

    def is_by_word(self, use: UnknownField) -> bool:
        """Return whether an annotation alone says what a use is of, in a function that code hands something."""
        file = self.run.modules.at(use.path)
        return file is not None and is_told_by_word(file, use.span, use.message, self.run.running)

    def is_replaced(self, use: UnknownField) -> bool:
        """Return whether a use is in a class that the module defines again further down."""
        file = self.run.modules.at(use.path)
        return file is not None and is_replaced(file, use.span)

    def in_file(self, file: PythonFile, classes: MessageClasses) -> Iterator[UnknownField]:
        for body, variables in MessageScopes(file, classes, self.known.fields).bodies():
            yield from self.in_body(file, body, variables, classes)

    def in_body(
        self, file: PythonFile, body: Bindings, variables: Environment, classes: MessageClasses
    ) -> Iterator[UnknownField]:
        passed_over = set(guarded_nodes((node for node in body.nodes if isinstance(node, BLOCKS)), CATCHES))
        passed_over.update(unreached_nodes(body.nodes, file.constants))
        caught = frozenset(guarded_nodes((node for node in body.nodes if isinstance(node, BLOCKS)), TYPE_ERROR))
        for node in body.nodes:
            if id(node) in passed_over:
                continue
            if isinstance(node, ast.Attribute):
                message = held_by(node.value, variables, classes, self.known.fields)
                if node.attr.isupper() and not message:
                    message = classes.message(node.value)
                if message:
                    end = file.span(node).end
                    span = Span(end - len(node.attr), end)
                    is_set = isinstance(node.ctx, ast.Store)
                    yield from self.judged(file.path, span, message, node.attr, is_set=is_set)
            elif isinstance(node, ast.Call) and (message := classes.message(node.func)):
                if id(node) not in caught and "rospy" not in file.source.text:
                    yield from self.by_place(file, node, message)
                for keyword in node.keywords:
                    if keyword.arg is not None:
                        start = file.span(keyword).start
                        span = Span(start, start + len(keyword.arg))
                        yield from self.judged(file.path, span, message, keyword.arg, is_set=True, is_keyword=True)

    @cached_property
    def changed(self) -> frozenset[str]:
        """The messages to whose classes a module of the package adds attributes: `Point.norm = norm`."""
        every = (changed_messages(file) for file in self.run.running if names_interfaces(file))
        return frozenset(each for found in every for each in found)

    def by_place(self, file: PythonFile, call: ast.Call, message: str) -> Iterator[UnknownField]:
        """Yield the first argument that a message is made with by its position."""
        given = next((each for each in call.args if not isinstance(each, ast.Starred)), None)
        if given is not None and self.known.fields(message) is not None:
            yield UnknownField(file.path, file.span(given), message, "", None, False, False, is_by_place=True)

    def judged(
        self, path: str, span: Span, message: str, name: str, *, is_set: bool, is_keyword: bool = False
    ) -> Iterator[UnknownField]:
        fields = self.known.fields(message) if message else None
        if fields is None or name in fields or name in GENERATED or name.startswith("_") or name.endswith("__DEFAULT"):
            return
        if any(message.endswith(kind) and name in around for kind, around in AROUND.items()):
            return
        is_ros1 = name in ros1_fields(message)
        here = self.known.is_here(message.partition("/")[0])
        near = similar(name, settable(fields) if is_set else fields, is_certain=here)
        if (near or is_ros1 or here) and message not in self.changed:
            yield UnknownField(path, span, message, name, near, is_keyword, is_ros1)


AROUND = {"_Feedback": ("feedback", "goal_id"), "_Result": ("result", "status")}
"""What an action client is handed: a message around the feedback or result, which annotations often take for it."""


def imports_interfaces(each: Import) -> bool:
    kind = each.module.partition(".")[2]
    return kind in KINDS or (not kind and not any(name in KINDS for name in each.names))


def settable(fields: Mapping[str, str]) -> Mapping[str, str]:
    """Return fields without the constants among them, whose names have capitals alone: nobody may assign to one."""
    return {name: kind for name, kind in fields.items() if not CONSTANT_NAME.fullmatch(name)}


def similar(name: str, fields: Mapping[str, str], *, is_certain: bool) -> str | None:
    """Return the one field that is near to a name; of messages that may have got others meanwhile only a clear one.

    Of names as short as `rx` it is the same in other letters, or none; a name in small letters means no constant.
    """
    fields = settable(fields) if name.islower() else fields
    alike = [each for each in fields if each.lower() == name.lower()]
    if not alike and len(name) > len("xy"):
        alike = near_names(name, fields, 1) if not is_certain else [near] if (near := nearest(name, fields)) else []
    return alike[0] if len(alike) == 1 else None
