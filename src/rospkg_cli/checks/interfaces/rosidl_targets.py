"""What rosidl_generate_interfaces is called with, against the interface files of the package and what these use."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cached_property
from itertools import takewhile

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.cmake.interface_targets import InterfaceTarget
from ...package.cmake.made_paths import MadePaths
from ...package.file_role import is_set_aside
from ...package.interfaces.interface_file import FieldType, InterfaceFile
from ...package.interfaces.listed_interfaces import ListedInterface
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ...ros.core_messages import CORE_DEPENDENCIES, CORE_MESSAGES
from ...ros.distros import Targets
from ...ros.interfaces import KINDS, valid_interface_name
from ...ros.manifest import BUILDS, RUNS
from ...ros.names import NameKind
from ...ros.read_table import rows
from ...suggest import near_names, nearest

GAPS = regex(
    r"\b(?:only|without|except|exclud\w+|skip\w*|omit\w*|(?:left|leave) out|disabled?|broken|not (?:yet|used))\b",
    re.IGNORECASE,
)
"""Words of a comment that says that something is left out."""
PASSED_ON = (BUILDS | RUNS) - {"buildtool_depend"}
"""Tags of what may bring interfaces."""
OTHER_VARIABLE = regex(r"\$\{(?!PROJECT_NAME\}|CMAKE_PROJECT_NAME\})")


@dataclass(frozen=True, slots=True)
class UnlistedDependency:
    """A package that a call's files use and that the call does not know of."""

    target: InterfaceTarget
    package: str
    interface: InterfaceFile
    kind: FieldType
    """Its first use."""
    is_certain: bool
    """The file is listed under no condition."""


@dataclass(frozen=True)
class RosidlTargets:
    cmake: CMake
    interfaces: tuple[InterfaceFile, ...]
    package: PackageFacts
    workspace: Workspace
    targets: Targets

    @cached_property
    def listed(self) -> tuple[ListedInterface, ...]:
        return tuple(
            ListedInterface(word, target, target.path_of(word))
            for target in self.cmake.interface_targets
            for word in target.files
        )

    @property
    def is_complete(self) -> bool:
        """Whether every file that is generated is known."""
        return self.cmake.knows_interfaces and bool(self.listed or self.empty)

    @property
    def empty(self) -> EvaluatedCommand | None:
        """The call, where it is the only one and names no file, and none by a variable."""
        calls = [each.call for each in self.cmake.interface_targets]
        if self.listed or len(calls) != 1 or calls[0].maybe:
            return None
        text = self.cmake.file(calls[0].path).source.slice(calls[0].command.span)
        return calls[0] if not OTHER_VARIABLE.search(text) else None

    def unlisted(self) -> Iterator[InterfaceFile]:
        """Yield the files in `msg/`, `srv/` and `action/` that no call lists, and that git does not ignore."""
        ignores = self.cmake.package_files.absent.is_ignored
        for interface in self.interfaces if self.is_complete else ():
            is_listed = interface.path in self.cmake.generated_interfaces
            if is_listed or interface.path in self.meant.values():
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
        return is_set_aside(interface.path) or self.tells_of_gaps

    def refusal(self, interface: InterfaceFile) -> str | None:
        """Return why the build would stop at a file: its name, its text, or a type that nothing defines; else None."""
        if not valid_interface_name(interface.name):
            return f"its name `{interface.name}`"
        if interface.problems:
            return "its text"
        own = {each.name for each in self.interfaces if each.kind == "msg"}
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
    def tells_of_gaps(self) -> bool:
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

    def missing(self) -> Iterator[ListedInterface]:
        """Yield what is listed, and neither there nor made by a command."""
        made, files = MadePaths(self.cmake), self.cmake.package_files
        for each in self.listed:
            path = each.path if each.word.is_known and not each.word.maybe and not each.target.call.maybe else ""
            if path and not (files.has_file(path) or files.absent.is_expected(path) or made.is_made(path)):
                yield each

    @cached_property
    def meant(self) -> dict[str, str]:
        """The one file that each missing one stands for, where one is near."""
        known = [each.path for each in self.interfaces]
        lower = {path.lower(): path for path in known}
        paths = (path for each in self.missing() if (path := each.path))
        near = ((path, lower.get(path.lower()) or nearest(path, known)) for path in paths)
        return {path: name for path, name in near if name is not None}

    def repeated(self) -> Iterator[tuple[ListedInterface, ListedInterface]]:
        """Yield what one call lists again, with the first of its kind."""
        for target in self.cmake.interface_targets:
            seen: dict[str, ListedInterface] = {}
            for each in self.listed:
                if each.target is target and each.path and not each.word.maybe:
                    first = seen.setdefault(each.path, each)
                    if first is not each:
                        yield each, first

    def unlisted_needs(self) -> Iterator[UnlistedDependency]:
        """Yield each package whose types a call's files use and that its DEPENDENCIES neither list nor pass on."""
        by_path = {interface.path: interface for interface in self.interfaces}
        for target in self.cmake.interface_targets:
            is_clear = all(word.is_known and not word.maybe for word in target.dependencies)
            passed_on, is_all = self.passed_on(target) if is_clear else (set[str](), False)
            if not is_all:
                continue
            seen = {*passed_on, "", self.package.name, self.cmake.project_name}
            for each in self.listed:
                interface = by_path.get(each.path or "") if each.target is target else None
                for kind in interface.types if interface else ():
                    if interface and kind.package not in seen and not self.is_misspelt(kind.package):
                        seen.add(kind.package)
                        sure = self.cmake.generated_interfaces.get(interface.path, False)
                        yield UnlistedDependency(target, kind.package, interface, kind, sure)

    def is_misspelt(self, package: str) -> bool:
        """Return whether a package is unknown and near to one that is declared: DEP108 says so."""
        if self.workspace.kind_of(package) in (NameKind.PACKAGE, NameKind.KEY):
            return False
        return len(near_names(package, (each.name for each in self.package.dependencies))) == 1

    def passed_on(self, target: InterfaceTarget) -> tuple[set[str], bool]:
        """Return the packages whose interfaces a call links, and whether these are all.

        Actions pass `action_msgs` on; since Iron, services pass `service_msgs` on too.
        """
        found: set[str] = set()
        brought = rows("runtime_dependencies.txt")
        certain, waiting = True, [word.text for word in target.dependencies]
        services_do = not self.targets.named(lambda distro: distro.name == "humble")
        if any(word.text.endswith((".srv", ".action") if services_do else ".action") for word in target.files):
            waiting += ["action_msgs", "service_msgs"]
        while waiting:
            name = waiting.pop()
            if name not in found:
                found.add(name)
                facts = self.workspace.named(name)
                if facts is not None:
                    waiting += [need.name for need in facts.dependencies if need.tag in PASSED_ON]
                elif name in CORE_DEPENDENCIES:
                    waiting += CORE_DEPENDENCIES[name]
                elif name in brought:
                    waiting += [need.removeprefix("?") for need in brought[name]]
                elif self.workspace.kind_of(name) is not NameKind.KEY:
                    certain = False
        return found, certain
