"""The interface that a node is to be about: `RobotStatus`, `my_interfaces/RobotStatus`, `my_interfaces/SetGoal`."""

from __future__ import annotations

import keyword
import re
from collections.abc import Iterator, Mapping

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

TAKEN = frozenset(
    "ActionClient ActionServer CancelResponse DurabilityPolicy ExternalShutdownException FloatingPointRange Future "
    "IntegerRange MultiThreadedExecutor Node ParameterDescriptor QoSProfile ReentrantCallbackGroup ReliabilityPolicy "
    "ServerGoalHandle".split()
)
"""What a node imports besides it."""

CALLED = {"msg": "message", "srv": "service", "action": "action"}

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
    parts: tuple[tuple[MessageField, ...], ...] = ()
    """The fields of a message, of request and response, or of goal, result and feedback: as far as they are known, and
    as far as a node knows what to write there."""
    form: str = "msg"
    """`msg`, `srv` or `action`."""

    def part(self, number: int) -> tuple[MessageField, ...]:
        return self.parts[number] if number < len(self.parts) else ()

    @property
    def topic(self) -> str:
        """What its topic, service or action is called where nothing else was asked for."""
        return self.header

    @property
    def header(self) -> str:
        """The name in lower case, as rosidl makes it for the header."""
        words = re.sub(r"(.)([A-Z][a-z]+)", r"\1_\2", self.name)
        return re.sub(r"([a-z0-9])([A-Z])", r"\1_\2", words).lower()

    @property
    def full_name(self) -> str:
        return f"{self.package}/{self.form}/{self.name}"


def is_message(word: str) -> bool:
    """Return whether a part of a node's description names an interface, and no kind and no language."""
    word = word.partition("@")[0]
    return "/" in word or word[:1].isupper()


def message_of(word: str, package: str, there: WorkspacePackages, form: str = "msg") -> Message:
    """Return the interface of a form; raises ScaffoldError where there is none, or where it is ambiguous."""
    owner, _, name = word.rpartition("/")
    owner, slash, typed = owner.partition("/")
    is_form = not slash or typed in CALLED
    if not INTERFACE_NAME.fullmatch(name) or (owner and not PACKAGE_NAME.fullmatch(owner)) or not is_form:
        example = {"msg": "std_msgs/String", "srv": "std_srvs/SetBool", "action": "nav2_msgs/Spin"}[form]
        right = rightly_written(owner, name, form, there)
        hint = f"; did you mean `{owner}/{right}`?" if right else f", as {example}"
        raise ScaffoldError(f"`{word}` can't be {a_form(form)}: PACKAGE/Name{hint}")
    if slash and typed != form:
        raise ScaffoldError(f"`{word}` is no {CALLED[form]} but {a_form(typed)}; choose another kind")
    owner = owner or owner_of(name, package, there, form)
    check_usable(Message(owner, name, form=form))
    neighbour = there.named(owner)
    if neighbour is None:
        check_known(owner, name, form, known_interfaces().get(owner, {}))
        return Message(owner, name, form=form)
    known = interfaces_of(neighbour)
    check_known(owner, name, form, {each: frozenset(files) for each, files in known.items()})
    parts = tuple(tuple(fields(part.fields)) for part in known[form][name].sections)
    return Message(owner, name, parts, form)


def rightly_written(owner: str, name: str, form: str, there: WorkspacePackages) -> str:
    """Return the interface of a package that a name is in other letters, as that of its header; "" where none is."""
    neighbour = there.named(owner)
    known = interfaces_of(neighbour)[form] if neighbour else known_interfaces().get(owner, {}).get(form, ())
    return next((each for each in sorted(known) if each.lower() == name.replace("_", "").lower()), "")


def check_usable(message: Message) -> None:
    """Raise ScaffoldError for names that no code could use, or that would not fit its lines."""
    owner, name = message.package, message.name
    for word in (owner, name):
        if keyword.iskeyword(word) or word in CPP_KEYWORDS:
            language = "Python" if keyword.iskeyword(word) else "C++"
            raise ScaffoldError(
                f"`{owner}/{name}`: `{word}` is a keyword of {language}, and no code could use the {called(message)}"
            )
    if name in TAKEN or len(owner) + len(name) > LONGEST or len(message.topic) > LONGEST_TOPIC:
        reason = "is called like a class of ROS that nodes import" if name in TAKEN else "has too long a name"
        raise ScaffoldError(f"`{owner}/{name}` {reason}; give the {called(message)} another name")


def a_form(form: str) -> str:
    return f"an {CALLED[form]}" if form == "action" else f"a {CALLED[form]}"


def called(message: Message) -> str:
    return CALLED[message.form]


def check_known(owner: str, name: str, form: str, known: Mapping[str, frozenset[str]]) -> None:
    """Raise ScaffoldError for an interface that a package lacks, of which all are known by their form."""
    if not known or name in known.get(form, ()):
        return
    others = [other for other, names in known.items() if name in names]
    if others:
        raise ScaffoldError(f"`{owner}/{name}` is no {CALLED[form]} but {a_form(others[0])}; choose another kind")
    hint = did_you_mean(name, sorted(known.get(form, ())))
    raise ScaffoldError(f"`{owner}` has no {CALLED[form]} `{name}`{hint}")


def interfaces_of(neighbour: Neighbour) -> dict[str, dict[str, InterfaceFile]]:
    """Return the interfaces of a package around by form and name; every form is there."""
    found: dict[str, dict[str, InterfaceFile]] = {form: {} for form in CALLED}
    for each in neighbour.package.parts(InterfaceFile).good:
        found[each.kind][each.name] = each
    return found


def owner_of(name: str, package: str, there: WorkspacePackages, form: str) -> str:
    """Return the package around that has an interface; the one that is named after the same robot goes first."""
    owners = [each for each in sorted(there.trees) if name in interfaces_of(Neighbour(there.package(each)))[form]]
    if f"{package}_interfaces" in owners:
        return f"{package}_interfaces"
    if len(owners) == 1:
        return owners[0]
    known = owners or well_known_owners(name, form)
    if known:
        choice = " or ".join(f"`{each}/{name}`" for each in known)
        raise ScaffoldError(f"whose {CALLED[form]} is `{name}`? Write {choice}")
    command = f"rospkg new {package}_interfaces --type interfaces --{form} {name}"
    reason = f"no package here has {a_form(form)} `{name}`"
    raise ScaffoldError(f"{reason}; write PACKAGE/{name}, or begin with: {command}")


def well_known_owners(name: str, form: str) -> list[str]:
    if form == "msg":
        return [each for each, names in CORE_MESSAGES.items() if name in names]
    return [each for each, forms in known_interfaces().items() if name in forms.get(form, ())]


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
