"""Values of another type than well-known packages declare, and what is known of the files that hold them (PRM006)."""

from __future__ import annotations

from collections.abc import Iterator

from ...light_dataclasses import dataclass
from ...package.params.parameter_file import ParameterFile
from ...ros.known_nodes import newer_parameters
from ...source import Span
from ..repository.older_distribution import OlderDistribution
from .block_readers import BlockReaders
from .declaring_packages import ParameterContext
from .given_values import GivenValue
from .idle_nodes import Start, hardest
from .known_given import KnownNodes
from .known_group import PartKind


@dataclass(frozen=True, slots=True)
class MistypedValue:
    path: str
    value: GivenValue
    wanted: str
    package: str
    kind: PartKind
    file: ParameterFile | None = None
    is_certain: bool = True
    how: str = ""
    """The argument whose default it is, `perform()` for a text that this returns, "" for what is written there."""
    start: Start | None = None

    @property
    def is_newer(self) -> bool:
        """Whether Humble does not declare the parameter, and drops the value."""
        return any(each.fits(self.value.name) for each in newer_parameters(self.package))


@dataclass(frozen=True)
class MistypedValues:
    """What files and launch files give, what code declares, and what well-known packages declare (PRM006)."""

    given: ParameterContext
    known: KnownNodes
    readers: BlockReaders
    distribution: OlderDistribution

    def with_types(self) -> Iterator[tuple[str, Span]]:
        """Yield the values whose type is known: path and place."""
        for group in self.given.groups():
            yield from ((group.file.path, each.value.span) for each in group.parameters if group.wanted_type(each))
        for known in self.known.groups():
            yield from ((known.path, each.value) for each in known.values if known.wanted_type(each.name))


def mistyped_known(nodes: KnownNodes) -> Iterator[MistypedValue]:
    """Yield the values whose type differs from that of all declarations of the name; each place once."""
    return iter(hardest(((each.path, each.value.value), each) for each in all_mistyped(nodes)))


def all_mistyped(nodes: KnownNodes) -> Iterator[MistypedValue]:
    for group in nodes.groups():
        for each in group.values:
            wanted = group.wanted_type(each.name) if each.type else ""
            if wanted and each.type != wanted:
                owner = next(name for name in group.packages if group.is_declared_by(name, each.name))
                about = owner, group.kind, group.file, group.is_certain
                yield MistypedValue(group.path, each, wanted, *about, start=group.start)
