"""The nodes that a source may be of, as they would be asked for: what it says of interfaces, topics and qualities."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import product

from ..lazy_regex import regex
from ..light_dataclasses import dataclass, replace
from ..package.package import Package
from ..scaffold import ScaffoldError
from ..scaffold.node_kinds import OF, all_kinds
from ..scaffold.qos import QOS
from ..scaffold.requested_node import RequestedNode
from ..scaffold.several import PLUS
from ..scaffold.workspace import WorkspacePackages
from .node import NodePlace, node_place, requested_node

SOURCES = {"python": ".py", "cpp": ".cpp"}
PYTHON_TYPE = regex(r"from (?P<owner>\w+)\.(?:msg|srv|action) import (?P<names>[\w, ]+)")
CPP_TYPE = regex(r"using (?P<alias>\w+) = (?P<owner>\w+)::(?:msg|srv|action)::(?P<name>\w+);")
PYTHON_USE = regex(
    r"(?P<how>create_(?:publisher|subscription|service|client)|Action(?:Server|Client))\(\s*(?:self,\s*)?"
    r"(?P<type>\w+),\s*'(?P<topic>[^']+)',?(?P<more>[^)]*)"
)
CPP_USE = regex(
    r"(?P<how>create_(?:publisher|subscription|service|client|server))<(?P<type>[\w:]+)>\(\s*(?:this,\s*)?"
    r'"(?P<topic>[^"]+)",?(?P<more>[^\n]*)'
)
KINDS = {"publisher": "publisher", "subscription": "subscriber", "service": "service", "client": "client"}


@dataclass(frozen=True)
class SourceUse:
    """A topic, service or action in the source of a node."""

    how: str
    """`create_publisher`, `ActionServer`, …"""
    interface: str
    """`std_msgs/String`; "" where the source does not say whose it is."""
    topic: str
    qos: str

    def words(self, kind: str, interface: str) -> str:
        """Return what is typed for a node of some kind that has this use alone, behind the name."""
        return ":".join(filter(None, (kind, interface, f"@{self.topic}", self.qos)))


def possible_nodes(package: Package, name: str, there: WorkspacePackages) -> Iterator[RequestedNode]:
    """Yield the nodes that may have been added under a name: the plainest first, then those that sources tell of."""
    place = node_place(package)
    name = name.partition(":")[0]
    for language in place.template.languages:
        kinds = [kind for kind, each in all_kinds().items() if not kind.endswith(OF) and language in each.languages]
        found = [*requested(place, name, kinds, language, there)]
        for path in package.files.matching(f"*{name}{SOURCES[language]}"):
            uses = list(uses_of(package.files.readable_text(path), language))
            found += requested(place, name, texts_of(uses, kinds), language, there)
        if package.files.matching(f"*{name}_parameters.yaml"):
            yield from (replace(node, is_generated=True) for node in found if node.kind.parameters)
        yield from found


def requested(
    place: NodePlace, name: str, texts: Iterator[str] | list[str], language: str, there: WorkspacePackages
) -> Iterator[RequestedNode]:
    for text in texts:
        try:
            yield requested_node(place, f"{name}:{text}:{language}", there)
        except ScaffoldError:  # no node is asked for so
            continue


def texts_of(uses: list[SourceUse], kinds: list[str]) -> Iterator[str]:
    """Yield what may have been typed behind the name: one kind about one use, or several uses together."""
    for use, kind in product(uses, kinds):
        yield from (use.words(kind, interface) for interface in dict.fromkeys((use.interface, "")))
    if len(uses) > 1:
        parts = [each.words(KINDS.get(each.how.removeprefix("create_"), ""), each.interface) for each in uses]
        yield PLUS.join(parts)


def uses_of(text: str, language: str) -> Iterator[SourceUse]:
    """Yield the topics, services and actions of a source, in its order."""
    types = dict(types_of(text, language))
    for match in (PYTHON_USE if language == "python" else CPP_USE).finditer(text):
        more = match["more"]
        qos = next((name for name in QOS if name.replace("_", "") in re.sub(r"\W|_", "", more).lower()), "")
        yield SourceUse(match["how"], types.get(match["type"], ""), match["topic"], qos)


def types_of(text: str, language: str) -> Iterator[tuple[str, str]]:
    """Yield the names of interfaces in a source, with the interfaces that they stand for."""
    if language == "cpp":
        for match in CPP_TYPE.finditer(text):
            yield match["alias"], f"{match['owner']}/{match['name']}"
        return
    for match in PYTHON_TYPE.finditer(text):
        for name in match["names"].split(","):
            yield name.strip(), f"{match['owner']}/{name.strip()}"
