"""Launch configurations that are used before they are set, that are never set, or never used."""

from __future__ import annotations

import ast
import re
from collections import Counter
from collections.abc import Iterator
from functools import cached_property
from typing import Annotated, Literal

from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_of_kind
from ...languages.python.unread_values import never_added
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.file_role import role_of
from ...package.launch.configuration_events import LaunchEvent
from ...package.launch.launch_file import DeclaredArgument, LaunchFile
from ...package.workspace import Workspace
from ...source import Span
from ...suggest import near_names, nearest
from ...unreadable import READABLE
from .entity_schema import entity_faults
from .idle_actions import level_at

State = Literal["undeclared", "late", "not added"]
"""`not added`: it is declared, and the launch description that the file returns does not hold the declaration."""

OWN = frozenset("ros_namespace ros_params ros_remaps launch-prefix sigterm_timeout sigkill_timeout log_dir".split())
"""Those that launch and launch_ros use and set themselves."""

SETS = ("declare", "define")
SHORTEST = 5
DIGITS = regex(r"\d")
MENTION = regex(r"(?<!<param name=)['\"]([\w.-]+)['\"](?!\s*:)|\$\(var\s+([\w.-]+)\s*\)")
"""Where a launch configuration may be named: not as the name of a parameter, nor as the key of a dict."""


@dataclass(frozen=True, slots=True)
class UnsetConfiguration:
    name: str
    span: Span
    state: State
    declared: tuple[str, ...]
    """The arguments that the file declares."""
    is_passed_on: bool = False
    """Whether it is only passed on to an included file, under its own name."""
    is_lookup: bool = False
    """Whether Python looks it up in a dict."""
    may_be_included: bool = False
    """Whether a file that is included before, and is not here, may set it; none of the workspace does."""
    has_default: bool = False
    """Whether it has a default, which is what it always is."""
    is_guess: bool = False
    """Whether the use may never run, or another name may be meant."""
    is_unread: bool = False
    """Whether it is bound to a local name that nothing reads: launch never asks for it."""
    is_inherited: bool = False
    """Whether a file that includes this one sets it; `declared` is the argument of no use that is likely meant."""


@dataclass(frozen=True)
class LaunchConfigurations:
    workspace: Workspace
    file: LaunchFile
    around: Annotated[tuple[LaunchFile, ...], READABLE] = ()
    """All launch files of the package that can be read."""

    @cached_property
    def is_startable(self) -> bool:
        """Whether this is a launch file for users, of which everything is known."""
        file = self.file
        is_known = file.has_entry_point and file.is_complete and file.events is not None and not file.is_ros1
        return is_known and role_of(file.path) == "launch" and not any(entity_faults(file))

    @property
    def file_name(self) -> str:
        return self.file.path.rpartition("/")[2]

    @property
    def is_included(self) -> bool:
        """Whether a launch file of the workspace includes it, or its name begins with `include`."""
        named = "include" in self.file.path.rpartition("launch/")[2]
        return named or self.file_name in self.workspace.launch.included

    def unset(self) -> Iterator[UnsetConfiguration]:
        """Yield each name once, where it is first used, and under no condition that is off by default if it can be."""
        told: set[str] = set()
        for each in (*self.certainly_unset(), *self.slips(), *self.unset_in_classes(), *self.only_inherited()):
            if each.name not in told:
                told.add(each.name)
                yield each

    def certainly_unset(self) -> Iterator[UnsetConfiguration]:
        """Yield what is unset in a file that is all known, as those are that include it."""
        inherited = self.workspace.launch.inherited(self.file_name) if self.is_startable else None
        if inherited is None:
            return
        events = self.file.events or ()
        declared = tuple(event.name for event in events if event.kind == "declare")
        uses: dict[str, list[tuple[int, LaunchEvent, bool]]] = {}
        for each in self.missing(events, inherited | OWN):
            uses.setdefault(each[1].name, []).append(each)
        for name, several in uses.items():
            index, event, unsure = next((each for each in several if self.is_met(each[1])), several[0])
            state = self.state(name, index)
            if state is not None and not (unsure and self.may_be_set_there(name, state, declared)):
                passed = event.passed_as == name
                yield UnsetConfiguration(name, event.span, state, declared, passed, event.is_lookup, unsure)

    def is_met(self, use: LaunchEvent) -> bool:
        """Return whether a plain `ros2 launch` may come to a use."""
        return use.is_lookup or level_at(self.file, use.span)[0] != "info"

    def may_be_set_there(self, name: str, state: State, declared: tuple[str, ...]) -> bool:
        """Return whether a file that is included, and is not known, is likely to set a name: where this one declares
        none at all, or another one of the workspace has it."""
        is_elsewhere = state != "not added" and self.workspace.launch.has(name, besides=self.file_name)
        return not declared or is_elsewhere

    def slips(self) -> Iterator[UnsetConfiguration]:
        """Yield what a file that is not all known uses under a name of its own, like that of an argument of no use.

        Neither name stands anywhere else in the file, and no other launch file has the one that is used, or none has
        the one that is declared, where a default hides the slip.
        """
        file = self.file
        if not file.has_entry_point or file.is_ros1 or role_of(file.path) != "launch":
            return
        alone = {
            name
            for each in file.arguments
            if (name := each.name.literal or "") and self.mentions[name] == 1 and len(name) >= SHORTEST
        }
        for use in file.configurations() if alone else ():
            name, has_default = use.arguments[0].literal or "" if use.arguments else "", len(use.arguments) > 1
            near, is_far = near_names(name, alone, 1), False
            if not near and not has_default and (alike := nearest(name, alone)):
                near, is_far = [alike], True
            near = [each for each in near if DIGITS.sub("", each) != DIGITS.sub("", name)]
            if len(near) == 1 and self.mentions[name] == 1 and not self.is_elsewhere(name, near[0], has_default):
                is_guess = is_far or (has_default and bool(file.includes))
                yield UnsetConfiguration(
                    name,
                    use.span,
                    "undeclared",
                    (near[0],),
                    has_default=has_default,
                    is_guess=is_guess,
                    is_unread=not self.is_read(use.span),
                )

    def unset_in_classes(self) -> Iterator[UnsetConfiguration]:
        """Yield what a class of the file uses, of a name that no launch file here has; whether it runs is not known."""
        file = self.file
        spans = tuple(used_classes(file.python)) if file.python is not None else ()
        inherited = self.workspace.launch.inherited(self.file_name) if spans and self.is_startable else None
        if inherited is None or self.may_set_any:
            return
        known = inherited | OWN | file.set_configurations
        declared = tuple(name for each in file.arguments if (name := each.name.literal))
        for use in file.configurations() if declared else ():
            name = use.arguments[0].literal or "" if len(use.arguments) == 1 else ""
            is_inside = any(span.holds(use.span) for span in spans)
            if name and is_inside and name not in known and not self.workspace.launch.has(name):
                may_be = bool(file.includes)
                yield UnsetConfiguration(
                    name,
                    use.span,
                    "undeclared",
                    declared,
                    may_be_included=may_be,
                    is_guess=True,
                    is_unread=not self.is_read(use.span),
                )

    def only_inherited(self) -> Iterator[UnsetConfiguration]:
        """Yield what only files that include this one set, where this one declares a like name that nothing uses.

        `R` is like `roll`: the one that includes passes `roll`, and who starts the file itself can give `R` alone.
        """
        inherited = self.workspace.launch.inherited(self.file_name) if self.is_startable else None
        if not inherited or self.may_set_any:
            return
        idle = [name for each in self.file.arguments if (name := each.name.literal or "") and self.mentions[name] == 1]
        events = self.file.events or ()
        told: set[str] = set()
        for index, event, _ in self.missing(events, OWN) if idle else ():
            name = event.name
            near = [each for each in idle if is_short_for(each, name) or near_names(name, [each], 1)]
            is_free = name in inherited and name not in told and self.state(name, index) == "undeclared"
            if is_free and len(near) == 1:
                told.add(name)
                yield UnsetConfiguration(name, event.span, "undeclared", (near[0],), is_guess=True, is_inherited=True)

    def is_elsewhere(self, used: str, declared: str, has_default: bool) -> bool:
        """Return whether another launch file has the name that is used; with a default, the one that is declared."""
        launch = self.workspace.launch
        return launch.has(declared, besides=self.file_name) if has_default else launch.has(used)

    @cached_property
    def mentions(self) -> Counter[str]:
        """How often each name stands in quotes or as `$(var name)`."""
        return Counter(one or other for one, other in MENTION.findall(self.file.source.text))

    def state(self, name: str, index: int) -> State | None:
        """Return why a name is not set at an event; None where it may be set in some scope.

        An argument without a default has to be given wherever it is declared: then it is set from the start.
        """
        if self.is_required(name):
            return None
        if self.may_set_any:
            return "late" if self.last_set["declare"].get(name, -1) >= index else None
        last = max(self.last_set[kind].get(name, -1) for kind in ("declare", "define"))
        if last > index:
            return "late"
        if last >= 0:
            return None
        return "not added" if name in self.file.set_configurations else "undeclared"

    def is_required(self, name: str) -> bool:
        """Return whether all that sets a name are declarations of an argument that the user has to give."""
        kinds = {
            (each.kind, each.is_optional) for each in self.file.events or () if each.name == name and each.kind in SETS
        }
        return kinds == {("declare", True)}

    @cached_property
    def may_set_any(self) -> bool:
        """Whether something in the file may set configurations of any name."""
        return any(each.kind == "open" for each in self.file.events or ())

    @cached_property
    def last_set(self) -> dict[str, dict[str, int]]:
        """The index of the last event of each kind that sets a name."""
        found: dict[str, dict[str, int]] = {"declare": {}, "define": {}}
        for index, event in enumerate(self.file.events or ()):
            if event.kind in found:
                found[event.kind][event.name] = index
        return found

    def missing(
        self, events: tuple[LaunchEvent, ...], known: frozenset[str]
    ) -> Iterator[tuple[int, LaunchEvent, bool]]:
        """Yield the uses of what nothing has set by then, and whether an included file that is not here may do so."""
        names, open_, unsure = set(known), False, False
        stack: list[tuple[set[str], bool, bool]] = []
        for index, event in enumerate(events):
            match event.kind:
                case "declare" | "define" | "pass":
                    names.add(event.name)
                    open_ = open_ or not event.name
                case "open":
                    open_ = True
                case "include":
                    found = self.workspace.launch.defined_by(event.name)
                    unsure = unsure or found is None
                    names |= found or set()
                case "push":
                    stack.append((set(names), open_, unsure))
                case "pop":
                    names, open_, unsure = stack.pop()
                case "later":
                    names |= {each.name for each in events if each.kind in ("declare", "define")}
                case "use" if event.name and not event.is_optional and not open_ and event.name not in names:
                    yield index, event, unsure

    def unused(self) -> Iterator[DeclaredArgument]:
        """Yield the arguments that nothing in the file uses; none where it includes files, which see them."""
        events = self.file.events or ()
        is_passed_on = any(event.kind in ("include", "open") for event in events)
        if not self.is_startable or is_passed_on or "launch_configurations" in self.file.source.text:
            return
        used = {event.name for event in events if event.kind == "use"}
        used |= {nearest(each.name, each.declared) or "" for each in self.unset()} - {""}
        used |= {
            s.arguments[0].literal or "" for s in self.file.configurations() if s.arguments and self.is_read(s.span)
        }
        if "" in used:
            return
        used |= OWN
        for argument in self.file.arguments:
            name = argument.name.literal
            if name and name not in used and not self.has_other_mention(name, argument.span):
                yield argument

    @cached_property
    def unread(self) -> tuple[Span, ...]:
        """What a Python file binds to a local name that nothing reads."""
        return tuple(never_added(self.file.python)) if self.file.python is not None else ()

    def is_read(self, span: Span) -> bool:
        return not any(each.contains(span) for each in self.unread)

    def has_other_mention(self, name: str, declared: Span, *, in_comments: bool = True) -> bool:
        """Return whether a Python file has the name in quotes at another place, which something reads.

        What is taken out for now may come back, and is no reader.
        """
        if self.file.frontend != "python":
            return False
        text = self.file.source.text
        found = re.finditer(rf"(['\"]){re.escape(name)}\1", text)
        found = (each for each in found if in_comments or not is_in_comment(text, each.start()))
        places = (Span(each.start(), each.end()) for each in found)
        return any(not declared.holds(at) and self.is_read(at) for at in places)


def is_in_comment(text: str, at: int) -> bool:
    """Return whether a place of a Python file is on a line that is a comment."""
    return text[text.rfind("\n", 0, at) + 1 : at].lstrip().startswith("#")


def is_short_for(short: str, name: str) -> bool:
    """Return whether a name begins with another one, whatever their case."""
    return len(short) < len(name) and name.lower().startswith(short.lower())


def used_classes(file: PythonFile) -> Iterator[Span]:
    """Yield the classes of a file that it makes objects of itself."""
    made = {each.func.id for each in nodes_of_kind(file.tree, ast.Call) if isinstance(each.func, ast.Name)}
    for each in nodes_of_kind(file.tree, ast.ClassDef):
        if each.name in made:
            yield file.span(each)
