"""Headers that only ROS 1 has, and what ROS 2 has instead; which headers a package of interfaces may have at all."""

from __future__ import annotations

import posixpath
from functools import cached_property

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ...ros.core_messages import CORE_MESSAGES
from ...ros.headers import BESIDE_INTERFACES
from ...ros.interfaces import KINDS, OF_INTERFACES, header_name
from ...ros.names import NameKind
from ...ros.read_table import rows
from ..interfaces.known_interfaces import KnownInterfaces

OLD_INTERFACE = regex(r"([a-z]\w*)/([A-Z]\w*)\.h")
"""The header of a message in ROS 1, after the name of its package."""


@dataclass(frozen=True, slots=True)
class Ros1Header:
    """A header of ROS 1 that is not there."""

    meant: str
    """The header of ROS 2 instead; "" where there is none, or it is unknown."""
    is_certain: bool = True
    """Whether ROS 1 surely has it: else it is called like one, and its package is known."""


@dataclass(frozen=True)
class Ros1Headers:
    package: PackageFacts
    files: PackageFiles
    workspace: Workspace

    def find(self, header: str) -> Ros1Header | None:
        """Return what is known of a header of ROS 1; None for any other, and where a file of that path is there."""
        if header not in self._found:
            self._found[header] = None if self.is_there(header) else self.judged(header)
        return self._found[header]

    @cached_property
    def _found(self) -> dict[str, Ros1Header | None]:
        return {}

    def judged(self, header: str) -> Ros1Header | None:
        if (found := rows("ros1_headers.txt").get(header)) is not None:
            return Ros1Header(found[0].strip("-"))
        if (old := OLD_INTERFACE.fullmatch(header)) is None:
            return None
        package, name = old.groups()
        kinds = [kind for kind, names in (self.interfaces.of(package) or {}).items() if name in names]
        if kinds:
            return Ros1Header(f"{package}/{kinds[0]}/{header_name(name)}.hpp")
        is_known = self.workspace.kind_of(package) is NameKind.PACKAGE and not self.interfaces.is_here(package)
        return Ros1Header("", is_certain=False) if is_known and OF_INTERFACES.fullmatch(package) else None

    def may_be_in_ros2(self, header: str) -> bool:
        """Return whether a package of ROS 2 may have a header: rosidl makes `pkg/msg/set_mode.hpp` alone.

        What has another form is not found however well its package is declared and linked.
        """
        package, _, rest = header.partition("/")
        if self.find(header) is not None:
            return False
        if not OF_INTERFACES.fullmatch(package) or self.is_there(header):
            return True
        kind, slash, name = rest.partition("/")
        return (kind not in KINDS or name == name.lower()) if slash else not self.has_only_interfaces(package)

    def with_kind(self, header: str) -> str:
        """Return the header of an interface that is included without its kind, `std_msgs/string.hpp`; else ""."""
        package, _, name = header.partition("/")
        stem, dot, ending = name.partition(".")
        if "/" in name or not dot or not self.has_only_interfaces(package) or self.is_there(header):
            return ""
        known = self.interfaces.of(package) or {}
        kinds = [kind for kind, names in known.items() if stem in map(header_name, names)]
        return f"{package}/{kinds[0]}/{stem}.{ending}" if kinds else ""

    def has_only_interfaces(self, package: str) -> bool:
        """Return whether a package that is not here has no headers but those of its interfaces."""
        is_core = package in CORE_MESSAGES and package not in BESIDE_INTERFACES
        return is_core and not self.interfaces.is_here(package)

    def is_there(self, header: str) -> bool:
        """Return whether a file of the package ends with the path, or a package of the workspace has the header."""
        ends, wanted = self.by_name.get(posixpath.basename(header), ()), f"/{posixpath.normpath(header)}"
        if any(f"/{path}".endswith(wanted) for path in ends):
            return True
        return bool(self.workspace.having("header_files", header))

    @cached_property
    def by_name(self) -> dict[str, list[str]]:
        found: dict[str, list[str]] = {}
        for path in self.files.paths:
            found.setdefault(posixpath.basename(path), []).append(path)
        return found

    @cached_property
    def interfaces(self) -> KnownInterfaces:
        return KnownInterfaces(self.package, self.workspace)
