"""The message that a node is to publish or listen to: `RobotStatus`, `my_interfaces/RobotStatus`."""

from __future__ import annotations

import keyword
import re
from collections.abc import Iterator

from ..light_dataclasses import dataclass
from ..package.interfaces.interface_file import InterfaceFile, Member
from ..ros.core_messages import CORE_MESSAGES
from ..ros.interface_fields import known_interfaces
from ..ros.interfaces import CPP_KEYWORDS, INTERFACE_NAME
from ..ros.manifest import PACKAGE_NAME
from ..suggest import did_you_mean
from . import ScaffoldError
from .workspace import Neighbour, WorkspacePackages

LONGEST = 70
"""Names of package and message together: longer ones don't fit the line that names both."""

LONGEST_TOPIC = 40
"""The same for the lines that name the topic."""

TAKEN = frozenset({"ExternalShutdownException", "FloatingPointRange", "Node", "ParameterDescriptor"})
"""What a node imports besides it."""

PYTHON = {"bool": "False", "float": "0.0", "int": "0", "uint": "0", "string": "''"}
CPP = {"bool": "false", "float": "0.0", "int": "0", "uint": "0", "string": '""'}


@dataclass(frozen=True)
class MessageField:
    """A field that a node sets: where, what it is, and the first value in each language."""

    path: str
    type: str
    python: str
    cpp: str


@dataclass(frozen=True)
class Message:
    package: str
    name: str
    fields: tuple[MessageField, ...] = ()
    """As far as they are known, and as far as a node knows what to write there."""

    @property
    def topic(self) -> str:
        """The name in lower case, as rosidl makes it for the header too."""
        words = re.sub(r"(.)([A-Z][a-z]+)", r"\1_\2", self.name)
        return re.sub(r"([a-z0-9])([A-Z])", r"\1_\2", words).lower()

    @property
    def full_name(self) -> str:
        return f"{self.package}/msg/{self.name}"


def is_message(word: str) -> bool:
    """Return whether a part of a node's description names a message, and no kind and no language."""
    return "/" in word or word[:1].isupper()


def message_of(word: str, package: str, there: WorkspacePackages) -> Message:
    """Return the message; raises ScaffoldError where there is none, or where it is ambiguous."""
    owner, _, name = word.replace("/msg/", "/").rpartition("/")
    if not INTERFACE_NAME.fullmatch(name) or (owner and not PACKAGE_NAME.fullmatch(owner)):
        raise ScaffoldError(f"`{word}` can't be a message: PACKAGE/Name, as std_msgs/String")
    owner = owner or owner_of(name, package, there)
    for word in (owner, name):
        if keyword.iskeyword(word) or word in CPP_KEYWORDS:
            language = "Python" if keyword.iskeyword(word) else "C++"
            raise ScaffoldError(
                f"`{owner}/{name}`: `{word}` is a keyword of {language}, and no code could use the message"
            )
    if name in TAKEN or len(owner) + len(name) > LONGEST or len(Message(owner, name).topic) > LONGEST_TOPIC:
        reason = "is called like a class of ROS that nodes import" if name in TAKEN else "has too long a name"
        raise ScaffoldError(f"`{owner}/{name}` {reason}; give the message another name")
    neighbour = there.named(owner)
    if neighbour is None:
        check_well_known(owner, name)
        return Message(owner, name)
    known = messages_of(neighbour)
    if name not in known:
        raise ScaffoldError(f"`{owner}` has no message `{name}`{did_you_mean(name, sorted(known))}")
    return Message(owner, name, tuple(field for part in known[name].sections[:1] for field in fields(part.fields)))


def check_well_known(owner: str, name: str) -> None:
    """Raise ScaffoldError for a message that a package of our table, which holds those of all distributions, lacks."""
    known = known_interfaces().get(owner, {}).get("msg")
    if known is not None and name not in known:
        raise ScaffoldError(f"`{owner}` has no message `{name}`{did_you_mean(name, sorted(known))}")


def messages_of(neighbour: Neighbour) -> dict[str, InterfaceFile]:
    return {each.name: each for each in neighbour.package.parts(InterfaceFile).good if each.kind == "msg"}


def owner_of(name: str, package: str, there: WorkspacePackages) -> str:
    """Return the package around that has a message; the one that is named after the same robot goes first."""
    owners = [each for each in sorted(there.trees) if name in messages_of(Neighbour(there.package(each)))]
    if f"{package}_interfaces" in owners:
        return f"{package}_interfaces"
    if len(owners) == 1:
        return owners[0]
    known = owners or [each for each, names in CORE_MESSAGES.items() if name in names]
    if known:
        raise ScaffoldError(f"whose message is `{name}`? Write {' or '.join(f'`{each}/{name}`' for each in known)}")
    command = f"rospkg new {package}_interfaces --type interfaces --msg {name}"
    raise ScaffoldError(f"no package here has a message `{name}`; write PACKAGE/{name}, or begin with: {command}")


def fields(members: tuple[Member, ...]) -> Iterator[MessageField]:
    """Yield the fields that have a plain value, and those that hold the time."""
    for member in members:
        type = member.type
        if type.is_array or member.value is not None:
            continue
        shown = f"{type.package}/{type.base}" if type.package else type.base
        if shown in ("builtin_interfaces/Time", "std_msgs/Header"):
            path = f"{member.name}.stamp" if type.base == "Header" else member.name
            yield MessageField(path, "builtin_interfaces/Time", "self.get_clock().now().to_msg()", "now()")
        kind = type.base.rstrip("0123456789")
        if type.is_primitive and kind in PYTHON:
            yield MessageField(member.name, type.text, PYTHON[kind], CPP[kind])
