"""The interfaces that packages have, by the names of their headers, and headers of other files among them."""

from __future__ import annotations

from collections.abc import Mapping, Set
from functools import cached_property

from ...files import PackageFiles
from ...light_dataclasses import dataclass
from ...ros.interfaces import header_name
from ...ros.link_targets import MESSAGES
from ..interfaces.known_interfaces import KnownInterfaces, base_name
from .installed_headers import is_installed_header


@dataclass(frozen=True)
class InterfaceNames:
    known: KnownInterfaces
    files: PackageFiles

    @cached_property
    def _lowered(self) -> dict[tuple[str, str], Mapping[str, str]]:
        return {}

    def lowered(self, package: str, kind: str) -> Mapping[str, str]:
        """Return the interfaces of a kind that a package has, by the names of their headers."""
        if (package, kind) not in self._lowered:
            self._lowered[package, kind] = {header_name(known): known for known in self.names(package, kind)}
        return self._lowered[package, kind]

    def as_generated(self, package: str, name: str, lowered: Mapping[str, str], path: str) -> list[str]:
        """Return the header of a class by whose own name it is included: rosidl writes no capital letter."""
        header = header_name(name)
        if header == name:
            return []
        is_of_messages = MESSAGES.fullmatch(package) is not None and not self.known.is_here(package)
        is_generated = header in lowered if lowered else is_of_messages and path.endswith(".hpp")
        return [header] if is_generated else []

    def may_lack(self, package: str, kind: str, name: str) -> bool:
        """Return whether the interfaces of a kind are known, and none has this name."""
        names = self.names(package, kind)
        return bool(names) and base_name(name.rstrip("_")) not in names

    def names(self, package: str, kind: str) -> Set[str]:
        """Return the interfaces of a kind that a package has; none where they are unknown."""
        return (self.known.of(package) or {}).get(kind, frozenset())

    def is_there(self, header: str) -> bool:
        """Return whether the package has a header of that path, wherever, or another one among its generated ones."""
        is_own = any(f"/{path}".endswith(f"/{header}") for path in self.files.paths)
        return is_own or is_installed_header(header, self.known.workspace)

    def has_own_headers(self, package: str, kind: str) -> bool:
        """Return whether a package has headers of its own among the generated ones, and so types in their namespace."""
        facts = self.known.workspace.named(package)
        return facts is not None and any(each.startswith(f"{package}/{kind}/") for each in facts.header_files)
