"""Rule input: which interfaces packages have, and which fields: those of the workspace, and a table of others."""

from __future__ import annotations

from collections.abc import Mapping, Set
from functools import cached_property

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.package_facts import PackageFacts
from ...package.package_indexes import shared_folders
from ...package.workspace import Workspace
from ...ros import interface_fields
from ...ros.interfaces import GENERATED_SUFFIXES, KINDS
from ...suggest import near_names, nearest

BUILD_TYPES = ("ament_cmake", "ament_python")
NAMES = {"msg": "message", "srv": "service", "action": "action"}
KIND_WORDS = {"messages": "msg", "message": "msg", "services": "srv", "service": "srv"}
"""Words for a kind that are not similar to its name."""
ENDINGS = ("_msgs", "_srvs", "_interfaces")
PLURALS = {"msgs": "msg", "srvs": "srv"}
"""Modules that no package of interfaces has, whatever it is: rosidl's have the names of the kinds."""

OF_ROS1 = regex(r"(?:Request|Response)$")
"""How ROS 1 called the halves of a service: `EmptyRequest`."""


@dataclass(frozen=True)
class KnownInterfaces:
    package: PackageFacts
    workspace: Workspace

    def facts(self, package: str) -> PackageFacts | None:
        """Return the package of the workspace whose interfaces are all known; None where they are not."""
        facts = self.package if package == self.package.name else self.workspace.named(package)
        is_read = facts is not None and facts.build_type in BUILD_TYPES and facts.knows("interfaces")
        return facts if is_read and self.is_clear(package) else None

    def is_clear(self, package: str) -> bool:
        """Return whether a name refers to one package: no two packages of this name are equally near in the folders."""
        if package == self.package.name:
            return True
        same = next((each for each in self.workspace.repeated if each[0].name == package), ())
        near = [shared_folders(each.folder, self.package.folder) for each in same]
        return not near or near.count(max(near)) == 1

    def is_here(self, package: str) -> bool:
        return package == self.package.name or self.workspace.named(package) is not None

    def of(self, package: str) -> Mapping[str, Set[str]] | None:
        """Return the interfaces of a package by kind; None where nothing is known of it."""
        if package not in self._kinds:
            self._kinds[package] = self.kinds_of(package)
        return self._kinds[package]

    @cached_property
    def _kinds(self) -> dict[str, Mapping[str, Set[str]] | None]:
        return {}

    def kinds_of(self, package: str) -> Mapping[str, Set[str]] | None:
        if (facts := self.facts(package)) is not None:
            found: dict[str, set[str]] = {}
            for kind, _, name in (each.partition("/") for each in facts.interfaces):
                found.setdefault(kind, set()).add(name)
            return found
        return None if self.is_elsewhere(package) else interface_fields.known_interfaces().get(package)

    def is_elsewhere(self, package: str) -> bool:
        """Return whether a package is here, or is to be fetched: of another version than the released one."""
        return self.is_here(package) or self.workspace.is_listed(package)

    def lacks(self, package: str, kind: str, name: str) -> bool:
        """Return whether a package has no interface of a name: outside the workspace only if it is clearly misspelt."""
        known = self.of(package)
        base = base_name(name)
        if known is None or base in known.get(kind, ()):
            return False
        return self.is_here(package) or self.intended(package, kind, name) is not None

    def is_unlisted(self, package: str, kind: str, name: str) -> bool:
        """Return whether a package has the file of an interface, and generates nothing of it."""
        facts = self.facts(package) if self.is_here(package) else None
        return facts is not None and f"{kind}/{base_name(name)}" in facts.unlisted_interfaces

    def intended(self, package: str, kind: str, name: str) -> str | None:
        """Return the interface that is intended, as `package.kind.Name`, where exactly one is near."""
        known = self.of(package) or {}
        base = base_name(name)
        other = next((each for each in KINDS if base in known.get(each, ())), "")
        if other:
            return f"{package}.{other}.{base}"
        whole = OF_ROS1.sub("", base)
        if kind == "srv" and whole != base and whole in known.get(kind, ()):
            return f"{package}.{kind}.{whole}"
        near = self.nearest(package, base, known.get(kind, ()))
        if near:
            return f"{package}.{kind}.{near}"
        owners = [facts.name for facts in self.workspace.having("interfaces", f"{kind}/{base}")]
        if self.is_here(package) and len(owners) == 1:
            return f"{owners[0]}.{kind}.{base}"
        return None

    def nearest(self, package: str, name: str, names: Set[str] | tuple[()]) -> str | None:
        if self.is_here(package):
            return nearest(name, names)
        alike = [each for each in names if each.lower() == name.lower()] or near_names(name, names, 1)
        return alike[0] if len(alike) == 1 else None

    def intended_kind(self, package: str, word: str) -> str | None:
        """Return the kind that a module of a package of interfaces is intended to be: `std_msgs.msgs`."""
        known = self.of(package)
        if known is None and not self.is_here(package) and package.endswith(ENDINGS):
            return PLURALS.get(word)
        if not known or word in KINDS:
            return None
        near = KIND_WORDS.get(word) or next(iter(near_names(word, KINDS, 1)), None)
        return near if near in known else None

    def fields(self, message: str) -> Mapping[str, str] | None:
        """Return the fields of a message (`package/msg/Name`) with the messages they hold; None where unknown."""
        package, _, name = message.partition("/")
        if self.is_here(package):
            facts = self.facts(package)
            return None if facts is None else self.own_fields(facts).get(name)
        return None if self.is_elsewhere(package) else interface_fields.known_fields(message)

    @cached_property
    def _own_fields(self) -> dict[str, Mapping[str, Mapping[str, str]]]:
        return {}

    def own_fields(self, facts: PackageFacts) -> Mapping[str, Mapping[str, str]]:
        """Return the fields of the messages of a package of the workspace: message, field."""
        if facts.folder not in self._own_fields:
            self._own_fields[facts.folder] = {each.name: dict(each.fields) for each in facts.messages}
        return self._own_fields[facts.folder]


def base_name(name: str) -> str:
    """Return the name of the interface that a generated class is of: `SetMode_Request`."""
    for suffix in (*GENERATED_SUFFIXES, "_Event", "_SendGoal", "_GetResult", "_FeedbackMessage"):
        name = name.removesuffix(suffix)
    return name
