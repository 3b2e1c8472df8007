"""Targets that are built and needed at run time, but not installed."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.targets import Target
from ...languages.cmake.values import UNKNOWN
from ...light_dataclasses import dataclass
from .cmake_project import CMake
from .install_rule import InstallRule
from .library_uses import LibraryUses
from .output_folders import OutputFolders
from .set_variables import SetVariables
from .target_folders import ASIDE, EXAMPLES, folders_of, is_aside, parts_of
from .target_links import TargetLinks
from .target_users import users_by_name
from .unexported_links import MADE_BY, UnexportedLinks
from .uninstalled_target import TargetUse, UninstalledTarget


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
        stopping = {each.target.name: each for each in UnexportedLinks(self.cmake, self.links).all()}
        yield from stopping.values()
        yield from self.parameters()
        for target in self.candidates():
            if target.name in stopping:
                continue
            if target.is_executable and not target.call.maybe and not self.is_used(target):
                yield UninstalledTarget(target, None)
            elif (needed := self.libraries.needed_by(target)) is not None:
                yield UninstalledTarget(target, needed)

    def is_unclear(self, rule: InstallRule) -> bool:
        """Return whether it is unknown what a rule installs; a variable that nothing sets is empty."""
        unknown = [word for word in rule.items if not word.is_known]
        variables = SetVariables(self.cmake)
        return rule.kind == "CODE" or any(variables.empty_variable(word) is None for word in unknown)

    def candidates(self) -> Iterator[Target]:
        """Yield the targets that certainly are built, not for tests, and that no rule or folder installs."""
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
        return users_by_name(self.cmake.calls)

    @cached_property
    def libraries(self) -> LibraryUses:
        return LibraryUses(self.cmake, self.links)

    def parameters(self) -> Iterator[UninstalledTarget]:
        """Yield the one parameter library that is not installed nor linked, where two others or more are installed."""
        libraries = [target for target in self.cmake.targets if target.call.name == "generate_parameter_library"]
        unused = [target for target in libraries if target.name not in self.links.installed and not target.call.maybe]
        if (
            len(unused) == 1
            and len(libraries) > 2
            and not any(link.word.text == unused[0].name for link in self.links.all)
        ):
            yield UninstalledTarget(unused[0], TargetUse("parameter library"))
