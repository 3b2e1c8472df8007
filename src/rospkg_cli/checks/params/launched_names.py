"""Parameters that launch files set by a name which the node's package does not declare."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator

from ...lazy_regex import regex
from ...light_dataclasses import dataclass, replace
from ...package.package_facts import PackageFacts
from ...package.params.parameter_file import ParameterFile
from ...package.workspace import Workspace
from ...ros.known_nodes import KnownParameter
from ...source import Span
from ...suggest import near_names, same_words
from .code_of_programs import is_of_another
from .declaring_packages import ENOUGH, is_its_own
from .idle_nodes import Start, start_of
from .known_given import GivenValue, KnownGroup, KnownNodes
from .launch_parameters import LaunchParameters, NodeArguments
from .unchanged_values import SIM_TIME, declared_defaults, known_defaults, same_as_default, value_text

SHORTEST, WORDY = 4, 6
"""Letters; a shorter name is near to too many others, or the last word of too many."""
SMALL = frozenset({"number", "num", "count", "of", "use", "enable", "is", "has"})
"""Words before a name that change little of what it means: `ransac_` before `height` makes another height of it."""
DIGITS = regex(r"\d")
SIGNS = ":= \t"
SIGN = regex(r":?=\s*$")
ENDINGS = frozenset({"_id", "_name", "_names", "_topic"})
"""What people leave away at the end of a name."""
SAME = frozenset({"_id", "_topic"})
"""What they put there; `camera_name` is not what `camera` is."""


@dataclass(frozen=True, slots=True)
class LaunchedName:
    path: str
    span: Span
    package: str
    name: str
    meant: str
    """"" for nothing: only another program of the package declares a near name."""
    is_removed: bool = False
    """Whether older releases had it, and no supported distribution has."""
    file: ParameterFile | None = None
    """The parameter file that it is in."""
    is_certain: bool = True
    others: tuple[Span, ...] = ()
    """Where other names are that the same release took away."""
    start: Start | None = None
    """Where a launch file starts the node; None for a parameter file."""
    same: str = ""
    """Why nobody misses the value: it is what the parameter is anyway; "" where something may differ."""


@dataclass(frozen=True, slots=True)
class StrangeName:
    """A name that is no parameter of any node, and what may be meant."""

    path: str
    span: Span
    name: str
    meant: str
    start: Start | None
    same: str = ""
    """Why nobody misses the value; "" where something may differ."""


@dataclass(frozen=True, slots=True)
class GivenName:
    """A name and its value, of a launch file or a parameter file."""

    path: str
    span: Span
    name: str
    text: str | None
    """The value; None where it is no single one that is known."""
    start: Start | None = None


@dataclass(frozen=True)
class LaunchedNames:
    launched: LaunchParameters
    workspace: Workspace

    def unknown(self) -> Iterator[LaunchedName]:
        """Yield the literal names that a package of the workspace does not declare, where it declares one near name.

        The node is not given that one, and most of the other names that it is given are declared.
        """
        for each in self.launched.started:
            package = each.node.package.literal if each.node.package else None
            facts = self.workspace.named(package) if package else None
            if facts is not None and facts.parameters:
                yield from self.of_node(each, facts)

    def of_node(self, each: NodeArguments, facts: PackageFacts) -> Iterator[LaunchedName]:
        given = each.names()
        declared = {name for name in given if any(one.fits(name) for one in facts.parameters)}
        free = {one.name for one in facts.parameters if not one.tail} - given
        for entry in each.node.parameters:
            for text, value in entry.values:
                name = text.literal or ""
                others = [other for other in given if other != name and is_its_own(other)]
                known = sum(other in declared or bool(with_dots(other, free)) for other in others)
                if not is_its_own(name) or name in declared or len(name) < SHORTEST or known < ENOUGH * len(others):
                    continue
                bare = [name[1:]] if name[0] == "/" and name[1:] in free else with_dots(name, free)
                near = bare or near_names(name, free, 2 if others else 1) or same_words(name, free)
                near = near or with_another_word(name, free)
                if len(near) == 1 and DIGITS.sub("", near[0]) != DIGITS.sub("", name):
                    start = start_of(each.launch, each.node, self.workspace)
                    started = each.node.executable or each.node.plugin
                    program = started.literal if started is not None else None
                    meant = "" if is_of_another(near[0], program, facts) else near[0]
                    same = same_as_default(value.literal, meant, declared_defaults([facts], meant))
                    place = each.launch.path, text.span, facts.name, name, meant
                    yield LaunchedName(*place, start=start, same=same)


def with_dots(name: str, names: Collection[str]) -> list[str]:
    """Return the name that has dots where another one has the slashes of ROS 1: `arm.rate` for `arm/rate`."""
    dotted = name.strip("/").replace("/", ".")
    return [dotted] if dotted != name and dotted in names else []


def with_another_word(name: str, names: Iterable[str]) -> list[str]:
    """Return the names that say the same with small words before it: `number_of_wheels` for `wheels`."""
    before = {each: each.removesuffix(f"_{name}") for each in names if each.endswith(f"_{name}")}
    return [each for each, words in before.items() if len(name) >= WORDY and SMALL.issuperset(words.split("_"))]


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
    """Yield path, place and name of what no package here declares, and what may be meant.

    That is nearly `use_sim_time`, or has the sign of the command line at its end, `rate:=`, or slashes for dots.
    """
    packages = launched.workspace.packages
    for given in given_names(launched):
        name = given.name
        is_time = name == f"/{SIM_TIME}" or bool(near_names(name, [SIM_TIME]))
        meant = SIM_TIME if is_time else name.rstrip(SIGNS) if SIGN.search(name) else ""
        if meant and not any(each.fits(name) for facts in packages for each in facts.parameters):
            defaults = ("false",) if is_time else declared_defaults(packages, meant)
            same = same_as_default(given.text, meant, defaults)
            yield StrangeName(given.path, given.span, name, meant, given.start, same)
    yield from slashed_names(launched)


def why_dropped(name: str, meant: str) -> str:
    """Return what is said of a strange name."""
    if meant == SIM_TIME:
        return "the node runs on the wall clock"
    return "slashes are of ROS 1" if "/" in name else "`:=` is for the command line alone"


def slashed_names(launched: LaunchParameters) -> Iterator[StrangeName]:
    """Yield path, place and name of what a parameter file gives with slashes, and this package or one that it needs
    declares with dots.
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


def unknown_to_known(nodes: KnownNodes) -> Iterator[LaunchedName]:
    """Yield the names that a well-known package does not declare, where it declares one near name that is not given."""
    for group in nodes.groups():
        found = list(unknown_of(group))
        removed = [each for each in found if each.is_removed]
        yield from (each for each in found if not each.is_removed)
        if removed:
            yield replace(removed[0], others=tuple(each.span for each in removed[1:]))


def unknown_of(group: KnownGroup) -> Iterator[LaunchedName]:
    """Yield the names that none of the packages of a group declares."""
    unknown = [each for each in group.values if not any(may_fit(one, each.name) for one in group.declared)]
    is_owner = len(unknown) <= (1 - ENOUGH) * len(group.values) or len(group.values) == 1
    for each in unknown:
        is_removed = any(one.fits(each.name) for one in group.removed)
        near = list(meant(each, group)) if is_owner or is_removed or "/" in each.name else []
        if len(near) == 1:
            from .switched_off import why_off  # few packages have something to ask it of

            names = each.name, near[0], is_removed, group.file, group.is_certain
            same = same_as_default(each.plain, near[0], known_defaults(group.packages, near[0]))
            same = same or why_off(group, near[0])
            yield LaunchedName(group.path, each.key, group.packages[0], *names, start=group.start, same=same)


def may_fit(known: KnownParameter, name: str) -> bool:
    """Return whether a name may be a parameter, perhaps behind a prefix, as code gives one to a parameter library."""
    return known.fits(name) or name.endswith(f".{known.name}")


def meant(value: GivenValue, group: KnownGroup) -> Iterator[str]:
    """Yield the names that a value may be for: those of a group are compared by their last pieces."""
    given = {each.name for each in group.values}
    before, dot, last = value.name.rpartition(".")
    ends = {one.name.lstrip(".") for one in group.declared if one.is_tail} if dot else set[str]()
    names = {one.name for one in group.declared if not one.is_tail} | {f"{before}.{end}" for end in ends}
    for name in sorted(names - given):
        end = name.removeprefix(f"{before}.") if dot else name
        if (
            f"/{name}" == value.name
            or name == value.name.replace("/", ".")
            or (len(last) >= SHORTEST and is_slip(last, end))
        ):
            yield name


def is_slip(word: str, right: str) -> bool:
    """Return whether one word of a name is misspelt, or the words are joined or in another order."""
    if word.replace("_", "").lower() == right.replace("_", "").lower() or same_words(word, [right]):
        return True
    pairs = [(a, b) for a, b in zip(word.split("_"), right.split("_"), strict=False) if a != b]
    if right.removeprefix(word) in ENDINGS or word.removeprefix(right) in SAME:
        return True
    is_one = len(word.split("_")) == len(right.split("_")) and len(pairs) == 1
    return is_one and min(map(len, pairs[0])) >= SHORTEST and bool(near_names(*pairs[0][:1], pairs[0][1:], 2))
