"""Whether an interface is used: by code that imports or includes it, by another interface, or on a page."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cached_property

from ...files import PackageFiles
from ...light_dataclasses import dataclass
from ...package.interfaces.interface_file import InterfaceFile
from ...package.launch.live_text import live_text
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ...ros.interfaces import header_name
from ..repository.pages_and_scripts import pages_and_scripts

CODE = (".py", ".yaml", ".yml", ".xml", ".launch", ".rviz")
COMPILED = (".cpp", ".cc", ".cxx", ".c", ".hpp", ".h")


@dataclass(frozen=True)
class AskedInterfaces:
    files: PackageFiles
    package: PackageFacts
    workspace: Workspace
    interfaces: tuple[InterfaceFile, ...]

    def has(self, interface: InterfaceFile) -> bool:
        """Return whether code, an interface, or a page of the workspace has the type by its name."""
        return self.is_a_field(interface) or self.is_taken(interface) or self.is_written(interface)

    def is_a_field(self, interface: InterfaceFile) -> bool:
        """Return whether a field of another interface is of this type."""
        own = ("", self.package.name)
        others = (each for each in self.interfaces if each.path != interface.path)
        types = (kind for each in others for kind in each.types)
        if interface.kind == "msg" and any(kind.base == interface.name and kind.package in own for kind in types):
            return True
        name = f"{self.package.name}/msg/{interface.name}"
        others_fields = (pair for facts in self.workspace.packages for each in facts.messages for pair in each.fields)
        return any(kind == name for _, kind in others_fields)

    def is_taken(self, interface: InterfaceFile) -> bool:
        """Return whether code of any package imports the class or includes the header."""
        module, header = f"{self.package.name}.{interface.kind}", self.header(interface)
        return any(
            (module, interface.name) in facts.taken_names or header in facts.included_headers
            for facts in self.workspace.packages
        )

    def header(self, interface: InterfaceFile) -> str:
        return f"{self.package.name}/{interface.kind}/{header_name(interface.name)}.hpp"

    def is_written(self, interface: InterfaceFile) -> bool:
        """Return whether a text of the package has the type as ROS writes it, or its Python or C++ takes it."""
        package, kind, name = map(re.escape, (self.package.name, interface.kind, interface.name))
        header = re.escape(self.header(interface))
        ways = rf"\b{package}/(?:{kind}/)?{name}\b|\b{package}::{kind}::{name}\b|{header}"
        imports = rf"\b{package}\.{kind}\b[^#]{{0,400}}?\b{name}\b"
        return any(map(re.compile(f"{ways}|{imports}").search, self.texts))

    @cached_property
    def texts(self) -> tuple[str, ...]:
        return (*pages_and_scripts(self.files), *self.code())

    def code(self) -> Iterator[str]:
        for path in self.files.paths:
            if path.endswith(COMPILED):
                yield self.files.readable_text(path)
            elif path.endswith(CODE) and path != "package.xml":
                yield live_text(self.files, path)
