"""Parameter names that no package declares: like use_sim_time, with the := of the command line, or with slashes."""

from __future__ import annotations

from collections.abc import Iterator

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...source import Span
from ...suggest import near_names
from .idle_nodes import Start, start_of
from .launch_parameters import LaunchParameters
from .unchanged_values import SIM_TIME, declared_defaults, same_as_default, value_text

SIGNS = ":= \t"
SIGN = regex(r":?=\s*$")


@dataclass(frozen=True, slots=True)
class StrangeName:
    """A name that is no parameter of any node, and the name that is probably intended."""

    path: str
    span: Span
    name: str
    intended: str
    start: Start | None
    same: str = ""
    """Why the lost value changes nothing; "" where something may differ."""


@dataclass(frozen=True, slots=True)
class GivenName:
    """A name and its value, of a launch file or a parameter file."""

    path: str
    span: Span
    name: str
    text: str | None
    """The value; None where it is no single one that is known."""
    start: Start | None = None


def given_names(launched: LaunchParameters) -> Iterator[GivenName]:
    """Yield what launch files and parameter files give."""
    for each in launched.started:
        for entry in each.node.parameters:
            start = start_of(each.launch, each.node, launched.workspace)
            named = ((name.literal, name.span, value) for name, value in entry.values)
            yield from (
                GivenName(each.launch.path, at, name, value.literal, start) for name, at, value in named if name
            )
    for file in launched.files:
        for one in (one for block in file.blocks for one in block.parameters):
            yield GivenName(file.path, one.key.span, one.name, value_text(one.value))


def strange_names(launched: LaunchParameters) -> Iterator[StrangeName]:
    """Yield the names that no package here declares, with the one that is probably intended.

    That is nearly `use_sim_time`, or has the sign of the command line at its end, `rate:=`, or slashes for dots.
    """
    packages = launched.workspace.packages
    for given in given_names(launched):
        name = given.name
        is_time = name == f"/{SIM_TIME}" or bool(near_names(name, [SIM_TIME]))
        intended = SIM_TIME if is_time else name.rstrip(SIGNS) if SIGN.search(name) else ""
        if intended and not any(each.fits(name) for facts in packages for each in facts.parameters):
            defaults = ("false",) if is_time else declared_defaults(packages, intended)
            same = same_as_default(given.text, intended, defaults)
            yield StrangeName(given.path, given.span, name, intended, given.start, same)
    yield from slashed_names(launched)


def why_dropped(name: str, intended: str) -> str:
    """Return why a strange name is dropped, as part of a message."""
    if intended == SIM_TIME:
        return "the node runs on the wall clock"
    return "slashes are of ROS 1" if "/" in name else "`:=` is for the command line alone"


def slashed_names(launched: LaunchParameters) -> Iterator[StrangeName]:
    """Yield the names that a parameter file gives with slashes, and a package declares with dots.

    That is this package, or one that it depends on.
    """
    needed = [launched.workspace.named(each.name) for each in launched.package.dependencies]
    owners = [launched.package, *(facts for facts in needed if facts is not None)]
    for file in launched.files:
        for block in file.blocks:
            given = {each.name for each in block.parameters}
            for each in block.parameters:
                dotted = each.name.strip("/").replace("/", ".")
                if "/" not in each.name.strip("/") or dotted in given:
                    continue
                declared = [one for facts in owners for one in facts.parameters]
                if any(one.name == dotted for one in declared) and not any(one.fits(each.name) for one in declared):
                    same = same_as_default(value_text(each.value), dotted, declared_defaults(owners, dotted))
                    yield StrangeName(file.path, each.key.span, each.name, dotted, None, same)
