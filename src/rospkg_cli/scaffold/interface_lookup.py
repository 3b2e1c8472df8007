"""Find the interface that a node is to use: `RobotStatus`, `my_interfaces/RobotStatus`, `my_interfaces/SetGoal`."""

from __future__ import annotations

import keyword
from collections.abc import Mapping

from ..package.interfaces.interface_file import InterfaceFile
from ..ros.core_messages import CORE_MESSAGES
from ..ros.interface_fields import known_interfaces
from ..ros.interfaces import CPP_KEYWORDS, INTERFACE_NAME
from ..ros.manifest import PACKAGE_NAME
from ..suggest import did_you_mean
from . import ScaffoldError
from .message import CALLED, Message, a_form, called
from .message_fields import fields
from .workspace import Neighbour, WorkspacePackages

LONGEST = 70
"""The most letters of package and message together that fit the line with both."""

LONGEST_TOPIC = 40
"""The same for the lines with the topic."""

TAKEN = frozenset(
    "ActionClient ActionServer CancelResponse DurabilityPolicy ExternalShutdownException FloatingPointRange Future "
    "IntegerRange MultiThreadedExecutor Node ParameterDescriptor QoSProfile ReentrantCallbackGroup ReliabilityPolicy "
    "ServerGoalHandle".split()
)
"""Classes that a node imports as well."""


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
    """Return the interface of a package with the same name in other letters, such as its header; "" for none."""
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


def check_known(owner: str, name: str, form: str, known: Mapping[str, frozenset[str]]) -> None:
    """Raise ScaffoldError for an interface that a package lacks; `known` are all that it has, by their form."""
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
    """Return the package of the workspace that has an interface; `<package>_interfaces` goes first."""
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
