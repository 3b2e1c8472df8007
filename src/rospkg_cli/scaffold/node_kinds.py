"""The kinds of nodes: what each does, declares and shows, whatever language it is written in."""

from __future__ import annotations

import sys
from collections.abc import Iterable
from functools import cache

from ..light_dataclasses import dataclass, replace
from ..resources import resources
from . import ScaffoldError

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib


OF = "-of"
"""The end of the names of kinds that are about a message which is named with the node."""

LANGUAGES = {"cpp": "C++", "python": "Python"}
"""What nodes are written in: as it is typed, and as it is called."""


@dataclass(frozen=True)
class NodeParameter:
    name: str
    default: str | int | float
    about: str
    least: int | float | None = None
    most: int | float | None = None

    @property
    def type(self) -> str:
        """`string`, `integer` or `double`, as rcl calls it."""
        return {str: "string", int: "integer", float: "double"}[type(self.default)]


@dataclass(frozen=True)
class InterfaceUse:
    """A topic, service or action that other nodes see."""

    how: str
    """A verb: publishes, listens to, …"""
    name: str
    type: str


@dataclass(frozen=True)
class NodeKind:
    name: str
    does: str
    """The end of the sentence "a node that …"."""
    says: str
    """What its log says first, once the node is there."""
    logic: str
    """The module of the part that needs no ROS; "" where there is none."""
    interfaces: tuple[str, ...]
    """The packages of its messages."""
    uses: tuple[InterfaceUse, ...]
    parameters: tuple[NodeParameter, ...]
    languages: tuple[str, ...]
    """Those that it can be written in."""
    libraries: dict[str, str]
    """What C++ needs besides rclcpp: package to target."""
    modules: tuple[str, ...] = ()
    """The packages of the modules that Python needs besides rclpy."""


FORMS = {"service": "srv", "client": "srv", "action-server": "action", "action-client": "action"}
"""The form of the interface that a kind is about, where it is no message."""


def form_of(kind: NodeKind) -> str:
    """Return `msg`, `srv` or `action`."""
    return FORMS.get(kind.name.removesuffix(OF), "msg")


def named(kind: NodeKind, topic: str) -> NodeKind:
    """Return a kind whose topic, service or action has another name; raises ScaffoldError where it has none."""
    if not kind.uses:
        raise ScaffoldError(f"a {kind.name} node has no topic, service or action; leave `@{topic}` out")
    return replace(kind, uses=(replace(kind.uses[0], name=topic), *kind.uses[1:]))


def kind_of_message(kind: NodeKind) -> NodeKind:
    """Return the kind of a node that is all about one message; raises ScaffoldError for kinds that never are."""
    of = all_kinds().get(kind.name + OF)
    if of is None:
        chosen = [name.removesuffix(OF) for name in all_kinds() if name.endswith(OF)]
        raise ScaffoldError(
            f"the interface of a {kind.name} node can't be chosen; that of {', '.join(chosen[:-1])} or {chosen[-1]} can"
        )
    return of


def about(of: NodeKind, name: str, full_name: str, topic: str) -> NodeKind:
    """Return a kind of `kind_of_message` with the message filled in."""
    uses = tuple(InterfaceUse(use.how, topic, full_name) for use in of.uses)
    package = full_name.partition("/")[0]
    return replace(of, does=of.does.format(message=name), interfaces=(package,), uses=uses)


@cache
def all_kinds() -> dict[str, NodeKind]:
    """Return every kind by its name."""
    data = tomllib.loads((resources("templates") / "_shared" / "kinds.toml").read_text("utf-8"))
    return {
        name: NodeKind(
            name=name,
            does=row["does"],
            says=row["says"],
            logic=row["logic"],
            interfaces=tuple(row["interfaces"]),
            uses=tuple(InterfaceUse(**use) for use in row["uses"]),
            parameters=tuple(NodeParameter(**parameter) for parameter in row["parameters"]),
            languages=tuple(row.get("languages", LANGUAGES)),
            libraries=row.get("libraries", {}),
            modules=tuple(row.get("modules", ())),
        )
        for name, row in data.items()
    }


def offered_kinds(languages: Iterable[str] = LANGUAGES) -> tuple[str, ...]:
    """Return the kinds that a user may name and that can be written in one of some languages."""
    there = set(languages)
    return tuple(
        name for name, kind in all_kinds().items() if not name.endswith(OF) and there.intersection(kind.languages)
    )


def listed_kinds() -> str:
    """Return the kinds as help texts and documents list them: `publisher, component (C++), empty`."""
    listed = []
    for name in offered_kinds():
        languages = all_kinds()[name].languages
        only = "" if set(languages) == set(LANGUAGES) else f" ({' and '.join(map(shown, languages))})"
        listed.append(name + only)
    return ", ".join(listed)


def shown(language: str) -> str:
    return LANGUAGES[language]
