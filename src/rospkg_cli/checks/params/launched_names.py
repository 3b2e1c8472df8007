"""Parameters that launch files set by a name which the node's package does not declare."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.package_facts import PackageFacts
from ...package.params.parameter_file import ParameterFile
from ...package.workspace import Workspace
from ...source import Span
from ...suggest import near_names, same_words
from .declaring_packages import ENOUGH, is_its_own
from .idle_nodes import Start, start_of
from .launch_parameters import LaunchParameters
from .node_parameters import NodeArguments
from .unchanged_values import declared_defaults, same_as_default

SHORTEST, WORDY = 4, 6
"""Letters; a shorter name is near to too many others, or the last word of too many."""
SMALL = frozenset({"number", "num", "count", "of", "use", "enable", "is", "has"})
"""Words before a name that change little of what it means: `ransac_` before `height` makes another height of it."""
DIGITS = regex(r"\d")


@dataclass(frozen=True, slots=True)
class LaunchedName:
    path: str
    span: Span
    package: str
    name: str
    intended: str
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
    """Why the lost value changes nothing: the parameter has it by default; "" where something may differ."""


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
                    from .code_of_programs import is_of_another  # few names are misspelt

                    start = start_of(each.launch, each.node, self.workspace)
                    started = each.node.executable or each.node.plugin
                    program = started.literal if started is not None else None
                    intended = "" if is_of_another(near[0], program, facts) else near[0]
                    same = same_as_default(value.literal, intended, declared_defaults([facts], intended))
                    place = each.launch.path, text.span, facts.name, name, intended
                    yield LaunchedName(*place, start=start, same=same)


def with_dots(name: str, names: Collection[str]) -> list[str]:
    """Return the name that has dots where another one has the slashes of ROS 1: `arm.rate` for `arm/rate`."""
    dotted = name.strip("/").replace("/", ".")
    return [dotted] if dotted != name and dotted in names else []


def with_another_word(name: str, names: Iterable[str]) -> list[str]:
    """Return the names that say the same with small words before it: `number_of_wheels` for `wheels`."""
    before = {each: each.removesuffix(f"_{name}") for each in names if each.endswith(f"_{name}")}
    return [each for each, words in before.items() if len(name) >= WORDY and SMALL.issuperset(words.split("_"))]
