"""Targets that are built and needed at run time, but not installed."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import Literal, NamedTuple

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.targets import Target
from ...languages.cmake.values import BINARY, UNKNOWN, Word
from ...light_dataclasses import dataclass
from .cmake_project import CMake
from .install_rules import InstallRule
from .installed_headers import HEADERS
from .output_folders import OutputFolders
from .set_variables import SetVariables
from .target_folders import ASIDE, EXAMPLES, folders_of, is_aside, parts_of
from .target_links import TargetLinks

MADE_BY = ("add_executable", "add_library", "ament_auto_add_executable", "ament_auto_add_library", "cuda_add_library",
           "cuda_add_executable", "generate_parameter_library")  # fmt: skip
SETTERS = ("target_", "set_target_properties", "ament_target_dependencies", "rosidl_target_interfaces",
           "ament_export_", "install", "add_dependencies", "set_property", "ament_auto_add_")  # fmt: skip
"""Commands that name a target without using its file."""
NAMING = ("project", "find_package", "set", "list", "foreach", "message")
"""Commands whose names are those of packages, one of which a target may share, or that use nothing themselves."""

RPATHS = frozenset({"CMAKE_INSTALL_RPATH", "INSTALL_RPATH"})
MAX_PARTS = 5
"""Behind the first `:` of `$<TARGET_FILE:ns::talker>` there are three, parted by `:`."""


User = Literal["component", "exporter", "linked target", "exported target", "parameter library"]


class TargetUse(NamedTuple):
    """What does not work without a target; `name` is that of a component or of another target."""

    user: User
    name: str = ""


@dataclass(frozen=True)
class UninstalledTarget:
    target: Target
    needed_by: TargetUse | None
    """None for an executable."""
    stops: bool = False
    """Whether CMake itself stops."""


@dataclass(frozen=True)
class UninstalledTargets:
    cmake: CMake

    @cached_property
    def links(self) -> TargetLinks:
        return TargetLinks(self.cmake)

    def all(self) -> Iterator[UninstalledTarget]:
        """Yield the targets that are not installed; nothing where an install rule can't be evaluated."""
        rules = [rule for rule in self.cmake.installs if rule.kind in ("TARGETS", "CODE")]
        if any(self.is_unclear(rule) for rule in rules) or not self.cmake.is_complete or not self.cmake.ends_a_package:
            return
        stopping = {each.target.name: each for each in self.unexported()}
        yield from stopping.values()
        yield from self.parameters()
        for target in self.candidates():
            if target.name in stopping:
                continue
            if target.is_executable and not target.call.maybe and not self.is_used(target):
                yield UninstalledTarget(target, None)
            elif self.links.shared(target) and self.has_code(target) and (needed := self.needed_by(target)) is not None:
                yield UninstalledTarget(target, needed)

    def is_unclear(self, rule: InstallRule) -> bool:
        """Return whether it is unknown what a rule installs; a variable that nothing sets is empty."""
        unknown = [word for word in rule.items if not word.is_known]
        variables = SetVariables(self.cmake)
        return rule.kind == "CODE" or any(variables.empty_variable(word) is None for word in unknown)

    def candidates(self) -> Iterator[Target]:
        for target in self.cmake.targets:
            sure = UNKNOWN not in target.name and not target.word.maybe
            if target.call.name not in MADE_BY or not sure or target.call.testing or not target.is_built:
                continue
            is_installed = target.name in self.links.installed or self.outputs.install(target.name)
            if not is_installed and "EXCLUDE_FROM_ALL" not in target.options and not self.is_copied(target):
                yield target

    @cached_property
    def outputs(self) -> OutputFolders:
        return OutputFolders(self.cmake)

    def is_copied(self, target: Target) -> bool:
        """Return whether a rule installs the file of a target by its path: `$<TARGET_FILE:core>`."""
        return any(call.name == "install" for call in self.users.get(target.name, ()))

    def is_used(self, target: Target) -> bool:
        """Return whether an executable is used by the build or a test, or is an example of which none is installed."""
        if is_aside(target) and not (parts_of(target) & ASIDE <= EXAMPLES and folders_of(target) & self.installed_from):
            return True
        # A function of the package is followed by what it does; what one makes may be for it alone
        own = () if target.call.function else self.cmake.functions
        users = self.users.get(target.name, ())
        return any(call is not target.call and call.name not in own for call in users)

    @cached_property
    def installed_from(self) -> frozenset[str]:
        """The folders of the sources of the executables that are installed."""
        made = (each for each in self.cmake.targets if each.is_executable and each.name in self.links.installed)
        return frozenset(folder for target in made for folder in folders_of(target))

    @cached_property
    def users(self) -> dict[str, list[EvaluatedCommand]]:
        """Name → the calls that use what is built of a target of that name."""
        found: dict[str, list[EvaluatedCommand]] = {}
        for call in self.cmake.calls:
            for name in dict.fromkeys(used_by(call)):
                found.setdefault(name, []).append(call)
        return found

    def has_code(self, target: Target) -> bool:
        """Return whether there may be more in a library than headers: the linker leaves an empty one out."""
        only = bool(target.sources) and all(word.is_known and word.text.endswith(HEADERS) for word in target.sources)
        return not only or target.name in self.added_to

    @cached_property
    def added_to(self) -> frozenset[str]:
        """The targets that get sources of target_sources."""
        return frozenset(text for call in self.cmake.named("target_sources") for text in call.texts[:1])

    def needed_by(self, target: Target) -> TargetUse | None:
        """Return what does not work without a library."""
        if target.name in self.promised and target.name not in self.plugins:
            return TargetUse("exporter")
        return self.loaded_by(target)

    def loaded_by(self, target: Target) -> TargetUse | None:
        """Return what can't start without a library: a component of it, or an installed target."""
        if (plugin := self.plugins.get(target.name)) is not None:
            return TargetUse("component", plugin)
        for link in self.links.with_word(target.name):
            if link.target in self.links.installed and not link.package and not self.runs_from_build:
                return TargetUse("linked target", link.target)
        return None

    @cached_property
    def runs_from_build(self) -> bool:
        """Whether CMake tells what is installed to look for libraries in the build folder, too."""
        calls = self.cmake.named("set", "set_target_properties", "set_property")
        return any(RPATHS.intersection(call.texts) and any(BINARY in text for text in call.texts) for call in calls)

    @cached_property
    def plugins(self) -> dict[str, str]:
        """Target → the first component that is registered of it."""
        return {each.target.text: each.plugin.text for each in reversed(self.cmake.components)}

    @cached_property
    def promised(self) -> frozenset[str]:
        return frozenset(text for call in self.cmake.named("ament_export_libraries") for text in call.texts)

    def unexported(self) -> Iterator[UninstalledTarget]:
        """Yield what an exported target is linked with, and what no export holds: `install(EXPORT)` refuses that."""
        exports = {text for call in self.cmake.exports for text in call.texts}
        rules = [rule for rule in self.cmake.installs if rule.export is not None]
        exported = {word.text for rule in rules for word in rule.items}
        seen: set[str] = set()
        for rule in rules:
            if rule.export is None or rule.export.text not in exports or rule.call.maybe:
                continue
            for word in rule.items:
                for name in self.interface_of(word):
                    target = self.cmake.target(name)
                    if target is not None and name not in exported and name not in seen and is_refused(target):
                        seen.add(name)
                        yield UninstalledTarget(target, TargetUse("exported target", word.text), stops=True)

    def parameters(self) -> Iterator[UninstalledTarget]:
        """Yield parameter libraries that nothing is linked with, where all their like are installed."""
        libraries = [target for target in self.cmake.targets if target.call.name == "generate_parameter_library"]
        unused = [target for target in libraries if target.name not in self.links.installed and not target.call.maybe]
        if (
            len(unused) == 1
            and len(libraries) > 2
            and not any(link.word.text == unused[0].name for link in self.links.all)
        ):
            yield UninstalledTarget(unused[0], TargetUse("parameter library"))

    def interface_of(self, word: Word) -> Iterator[str]:
        """Yield the package's targets that are linked along with a target."""
        static = (target := self.cmake.target(word.text)) is not None and "STATIC" in target.options
        for link in self.links.of(word.text):
            if (link.is_public or static) and not link.package and not link.call.maybe and not link.word.maybe:
                yield link.word.text


def is_refused(target: Target) -> bool:
    return target.call.name in MADE_BY and not target.call.maybe and not target.options & {"IMPORTED", "ALIAS"}


def used_by(call: EvaluatedCommand) -> Iterator[str]:
    """Yield the names of targets of which a call uses what is built, if they are targets."""
    setter = call.name.startswith(SETTERS)
    if (setter and call.name != "install") or call.name in NAMING:
        return
    for text in call.texts:
        if not setter:
            yield text
        for piece in text.split(">")[:-1]:
            parts = piece.rpartition("<")[2].split(":")
            yield from (":".join(parts[-count:]) for count in range(1, min(len(parts), MAX_PARTS + 1)))
