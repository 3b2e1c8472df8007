"""Values of another type than the code here declares, which launch files give to its nodes (PRM006)."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...lazy_regex import regex
from ...package.launch.argument_defaults import literal_defaults
from ...package.launch.launch_file import LaunchFile
from ...package.launch.text import LaunchText, Substitution
from ...package.package_facts import PackageFacts
from ...package.params.declared_parameter import DeclaredParameter, type_named
from ...package.params.scalar_types import DOUBLE
from ...source import Span
from ..launch.action_conditions import conditional
from .code_of_programs import is_of
from .declaring_packages import ENOUGH, is_its_own
from .given_values import GivenValue, is_cast_behind, launch_value
from .idle_nodes import hardest, level_of, start_of
from .launch_parameters import LaunchParameters
from .mistyped_known import MistypedValue
from .node_parameters import NodeArguments
from .rcl_types import type_of_text

PERFORMED = regex(r"\s*\.perform\s*\(")
WRAPPED = regex(r"(?:ParameterValue|value|[A-Za-z_]\w*)\s*[(=]\s*$")
"""A call around a value that may give it another type."""
NOTHING = frozenset({"null", "Null", "NULL", "~"})
TEXT, PERFORM = "string", "perform()"


def mistyped_launched(launched: LaunchParameters) -> Iterator[MistypedValue]:
    """Yield the values whose type differs from that of all declarations of the name in the package of the node."""
    return iter(hardest(((each.path, each.value.value), each) for each in all_mistyped(launched)))


def all_mistyped(launched: LaunchParameters) -> Iterator[MistypedValue]:
    for each in launched.started:
        package = each.node.package.literal if each.node.package else None
        facts = launched.workspace.named(package) if package else None
        for value, how in given_values(each) if facts is not None and is_owner(each, facts) else ():
            places = declared(each, facts, value.name) if facts is not None else []
            wanted = type_named(places, value.name)
            if wanted and value.type and value.type != wanted:
                path, start = each.launch.path, start_of(each.launch, each.node, launched.workspace)
                yield MistypedValue(path, value, wanted, places[0].path, "node", how=how, start=start)


def is_owner(each: NodeArguments, facts: PackageFacts) -> bool:
    """Return whether a package declares most of what its node is given."""
    names = [name for name in each.names() if is_its_own(name)]
    return sum(any(one.fits(name) for one in facts.parameters) for name in names) >= ENOUGH * len(names)


def declared(each: NodeArguments, facts: PackageFacts, name: str) -> list[DeclaredParameter]:
    """Return what declares a name: the code of the node, where that is known and does."""
    started = each.node.executable or each.node.plugin
    fitting = [one for one in facts.parameters if one.name == name and not one.tail]
    codes = [code.paths for code in facts.node_code if started is not None and code.starts == started.literal]
    near = [one for one in fitting if any(one.path in paths for paths in codes)]
    return near if codes else [one for one in fitting if started is not None and is_of(one.path, started.literal)]


def given_values(each: NodeArguments) -> Iterator[tuple[GivenValue, str]]:
    """Yield the last value of each name, and where it comes from: "" for what is written there."""
    entries = each.node.parameters
    last = max((index for index, entry in enumerate(entries) if entry.file is not None), default=-1)
    found: dict[str, tuple[GivenValue, str]] = {}
    for index, entry in enumerate(entries):
        for name, value in entry.values if index > last else ():
            for one in value_of(each.launch, name, value):
                found[one[0].name] = one
    yield from found.values()


def value_of(launch: LaunchFile, name: LaunchText, value: LaunchText) -> Iterator[tuple[GivenValue, str]]:
    """Yield one value with its type: that of a text, of what `perform` returns, or of the default of an argument."""
    written = list(launch_value(launch, name, value))
    match value.parts:
        case (Substitution(name="var", arguments=(argument, *_)),) if written and argument.literal:
            after = PERFORMED.match(launch.source.text, value.span.end) if launch.frontend == "python" else None
            how = PERFORM if after else argument.literal
            is_asked = not after and is_asked_for(launch, argument.literal, value.span)
            kind = TEXT if after else "" if is_asked else type_of_default(launch, argument.literal, value)
            yield GivenValue(written[0].name, name.span, value.span, "", kind), how
        case _:
            yield from ((one, "") for one in written)


def is_asked_for(launch: LaunchFile, name: str, place: Span) -> bool:
    """Return whether a place is under a condition that asks for an argument, and that may not hold for its default."""
    conditions = (launch.source.slice(each.written) for each in conditional(launch) if each.guards(place))
    return any(re.search(rf"\b{re.escape(name)}\b", text) for text in conditions)


def type_of_default(launch: LaunchFile, name: str, value: LaunchText) -> str:
    """Return the type that launch_ros gives the default of an argument; "" where it may be another one."""
    default = literal_defaults(launch.arguments, launch.assigned).get(name, "")
    text = launch.source.text
    is_wrapped = launch.frontend == "python" and WRAPPED.search(text, max(0, value.span.start - 80), value.span.start)
    is_cast = is_cast_behind(launch, value)
    kind = type_of_text(default)
    may_be_number = kind == TEXT and DOUBLE.fullmatch(default)
    return "" if is_wrapped or is_cast or may_be_number or default in NOTHING else kind


def what_stops(each: MistypedValue) -> str:
    """Return what is said of a value that a launch file gives to a node whose code is here."""
    kind = article(each.value.type)
    what = f"the default of `{each.how}` is {kind}, which" if each.how else kind
    what = "`perform` returns a string, which" if each.how == PERFORM else what
    start = f"`{each.value.name}` is declared as {each.wanted} in `{each.package}`"
    return f"{start}: {what} stops the node when it starts{level_of(each.start)[1]}; write {article(each.wanted)}"


def article(kind: str) -> str:
    """Return a type with its article: "a list of double", "an int"."""
    one = kind.removesuffix("[]")
    return f"a list of {one}" if one != kind else f"an {one}" if one == "int" else f"a {one}"
