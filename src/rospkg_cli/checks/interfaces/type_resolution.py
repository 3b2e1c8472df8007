"""Rule input: an interface file with the packages whose types it may use."""

from __future__ import annotations

import re
from collections.abc import Iterator, Set

from ...light_dataclasses import dataclass
from ...package.interfaces.interface_file import FieldType, InterfaceFile
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ...ros.core_messages import CORE_MESSAGES
from ...ros.interfaces import FOREIGN_TYPES
from ...suggest import near_names, nearest
from .package_interfaces import InterfaceGeneration


@dataclass(frozen=True)
class InterfaceInWorkspace:
    interface: InterfaceFile
    package: PackageFacts
    workspace: Workspace
    generation: InterfaceGeneration

    @property
    def is_read(self) -> bool:
        """Whether code may be generated of the file."""
        return self.generation.may_read(self.interface.path)

    @property
    def is_surely_read(self) -> bool:
        return self.generation.surely_reads(self.interface.path)

    def is_own(self, kind: FieldType) -> bool:
        return kind.package in ("", self.package.name)

    def messages(self, kind: FieldType) -> Set[str] | None:
        """Return the messages of the package of a type; None where they are unknown."""
        facts = self.package if self.is_own(kind) else self.workspace.named(kind.package)
        if facts is None or not facts.knows("interfaces"):
            return None
        return {name.removeprefix("msg/") for name in facts.interfaces if name.startswith("msg/")}

    def bare_headers(self) -> Iterator[FieldType]:
        """Yield the types `Header` that refer, as in ROS 1, to std_msgs."""
        for kind in self.interface.types:
            known = self.messages(kind)
            if kind.base == "Header" and not kind.package and known is not None and "Header" not in known:
                yield kind

    def unknown_types(self) -> Iterator[FieldType]:
        """Yield the types that their package lacks; of a core package that is absent, only clear misspellings."""
        bare = set(self.bare_headers())
        for kind in self.interface.types:
            known = self.messages(kind)
            if known is None:
                absent = core_suggestion(kind.package, kind.base) is not None or self.namesake(kind) is not None
            else:
                absent = kind.base not in known and "_" not in kind.base  # one with `_` is generated of a service
            if absent and kind not in bare:
                yield kind

    def suggestion(self, kind: FieldType) -> str | None:
        """Return the similar type where there is exactly one."""
        known = self.messages(kind)
        if known is None:
            return core_suggestion(kind.package, kind.base) or self.namesake(kind)
        prefix = f"{kind.package}/" if kind.package else ""
        if not prefix and kind.base in FOREIGN_TYPES:
            return FOREIGN_TYPES[kind.base]
        if found := nearest(kind.base, known):
            return prefix + found
        other = core_package_of(kind.base, kind.package)
        return f"{other}/{kind.base}" if other else None

    def namesake(self, kind: FieldType) -> str | None:
        """Return the only message of the workspace that has the name of one that a core package lacks."""
        if kind.base in CORE_MESSAGES.get(kind.package, (kind.base,)):
            return None
        packages = [each.name for each in self.workspace.having("interfaces", f"msg/{kind.base}")]
        return f"{packages[0]}/{kind.base}" if len(packages) == 1 else None

    def service_or_action(self, kind: FieldType) -> str | None:
        """Return the service or action of this package that has the name of a type."""
        found = [f"{each}/{kind.base}" for each in ("srv", "action")] if self.is_own(kind) else []
        return next((name for name in found if name in self.package.interfaces), None)


def core_package_of(name: str, besides: str = "") -> str | None:
    """Return the one core package that has a message of a name."""
    found = [package for package, names in CORE_MESSAGES.items() if name in names and package != besides]
    return found[0] if len(found) == 1 else None


def core_suggestion(package: str, name: str) -> str | None:
    """Return `package/Name` where a core package lacks a message and only one is similar; else None."""
    known = CORE_MESSAGES.get(package, frozenset())
    if not known or name in known:
        return None
    alike = [each for each in known if each.lower() == name.lower()]
    if not alike and not re.search("[0-9]", name):
        alike = near_names(name, known, 1)
    if len(alike) == 1:
        return f"{package}/{alike[0]}"
    other = core_package_of(name, package)
    return f"{other}/{name}" if other else None
