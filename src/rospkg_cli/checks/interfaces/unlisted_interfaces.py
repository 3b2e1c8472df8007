"""Rule input: interface files that no rosidl_generate_interfaces lists, and why they may be left out on purpose."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cached_property
from itertools import takewhile

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.file_role import is_set_aside
from ...package.interfaces.interface_file import InterfaceFile
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ...ros.core_messages import CORE_MESSAGES
from ...ros.interfaces import KINDS, valid_interface_name
from ...ros.names import NameKind
from ...suggest import near_names
from .asked_interfaces import AskedInterfaces
from .rosidl_targets import RosidlTargets

GAPS = regex(
    r"\b(?:only|without|except|exclud\w+|skip\w*|omit\w*|(?:left|leave) out|disabled?|broken|not (?:yet|used))\b",
    re.IGNORECASE,
)
"""Words of a comment that says that something is left out."""


@dataclass(frozen=True)
class UnlistedInterfaces:
    generated: RosidlTargets
    asked: AskedInterfaces
    """Whether code, a page or another interface uses an interface."""

    @property
    def cmake(self) -> CMake:
        return self.generated.cmake

    @property
    def package(self) -> PackageFacts:
        return self.asked.package

    @property
    def workspace(self) -> Workspace:
        return self.asked.workspace

    def unlisted(self) -> Iterator[InterfaceFile]:
        """Yield the files in `msg/`, `srv/` and `action/` that no call lists, and that git does not ignore."""
        ignores = self.cmake.package_files.absent.is_ignored
        for interface in self.generated.interfaces if self.generated.is_complete else ():
            is_listed = interface.path in self.cmake.generated_interfaces
            if is_listed or interface.path in self.generated.renamed.values():
                continue
            is_alone = interface.folder.rpartition("/")[2] in KINDS and not self.is_for_ros1(interface)
            if is_alone and not ignores(interface.path):
                yield interface

    def is_commented_out(self, interface: InterfaceFile) -> bool:
        """Return whether a comment of the CMake files names an interface file: then it is left out on purpose."""
        named = re.compile(rf"^[ \t]*#.*\b{re.escape(interface.path)}", re.MULTILINE)
        return any(named.search(file.source.text) for file in self.cmake.files)

    def is_left_out(self, interface: InterfaceFile) -> bool:
        """Return whether a file is an old copy by its name, or a comment says that not all files are listed."""
        return is_set_aside(interface.path) or self.is_incomplete_on_purpose

    def refusal(self, interface: InterfaceFile) -> str | None:
        """Return why the build would stop at a file: its name, its text, or a type that nothing defines; else None."""
        if not valid_interface_name(interface.name):
            return f"its name `{interface.name}`"
        if interface.problems:
            return "its text"
        own = {each.name for each in self.generated.interfaces if each.kind == "msg"}
        for kind in interface.types:
            is_own = kind.package in ("", self.package.name)
            if is_own and kind.base not in own:
                return f"no `msg/{kind.base}.msg` is here"
            near = [] if is_own or self.is_declared(kind.package) else near_names(kind.package, CORE_MESSAGES, 1)
            if len(near) == 1 and self.workspace.kind_of(kind.package) not in (NameKind.PACKAGE, NameKind.KEY):
                return f"did you mean `{near[0]}` by `{kind.package}`?"
        return None

    def is_declared(self, package: str) -> bool:
        return any(each.name == package for each in self.package.dependencies)

    @cached_property
    def is_incomplete_on_purpose(self) -> bool:
        """Whether a comment right above the call, or in it, says that not all files are listed."""
        sources = {file.path: file.source for file in self.cmake.files}
        for target in self.cmake.interface_targets:
            source, span = sources.get(target.call.path), target.call.command.span
            if source is not None:
                above = source.text[: span.start].splitlines()
                own = takewhile(lambda line: line.lstrip().startswith("#"), reversed(above))
                inside = (line.partition("#")[2] for line in source.slice(span).splitlines())
                if any(GAPS.search(line) for line in (*own, *inside)):
                    return True
        return False

    def is_for_ros1(self, interface: InterfaceFile) -> bool:
        """Return whether catkin, or another branch, lists a file, or another of its name is generated in its place."""
        name = interface.path.rpartition("/")[2]
        alike = (path for path in self.cmake.generated_interfaces if path != interface.path)
        if any(path.endswith(f"/{name}") for path in alike):
            return True
        catkin = self.cmake.named("add_message_files", "add_service_files", "add_action_files")
        words = (text for call in (*catkin, *self.cmake.unreachable) for text in call.texts)
        return any(text.rpartition("/")[2] == name for text in words)
