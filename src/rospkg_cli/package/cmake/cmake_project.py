"""CMakeLists.txt and the files it includes, evaluated: the input of rules and PackageFacts."""

from __future__ import annotations

from functools import cached_property

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.file import ROOT
from ...languages.cmake.targets import Target, targets_by_name, targets_of
from ...languages.cmake.values import Word
from ...light_dataclasses import dataclass
from .ament_installs import install_rules
from .components import Component, components_of
from .evaluated_files import EvaluatedFiles
from .find_package import FoundPackage, found_packages
from .install_rule import InstallRule
from .interface_targets import InterfaceTarget, generated_files, interface_targets_of
from .project_name import are_only_tests, ends_a_package, last_project
from .target_properties import SETTERS, output_names, properties


@dataclass(frozen=True)
class CMake(EvaluatedFiles):
    """The commands of a package, and what they make: targets, install rules, components, interfaces, exports."""

    @cached_property
    def projects(self) -> tuple[EvaluatedCommand, ...]:
        """The calls of project() in CMakeLists.txt itself."""
        return tuple(call for call in self.named("project") if call.path == ROOT and call.words)

    @cached_property
    def project(self) -> Word | None:
        """The name that ament_package() uses."""
        return last_project(self.calls)

    @property
    def project_name(self) -> str:
        if self.project is None:
            return ""
        return self.project.text if self.project.is_known else self.own_name

    @property
    def ends_a_package(self) -> bool:
        return ends_a_package(self.calls)

    @cached_property
    def exports(self) -> tuple[EvaluatedCommand, ...]:
        """The calls of ament_export_targets that count: those in a sub-folder set a variable that is lost there."""
        calls = self.named("ament_export_targets", "ament_export_interfaces")
        return tuple(call for call in calls if not call.folder)

    @cached_property
    def only_tests(self) -> bool:
        """Whether all that is built, installed or exported is for tests."""
        return are_only_tests(self.calls)

    @cached_property
    def targets(self) -> tuple[Target, ...]:
        return tuple(targets_of(self.calls))

    @cached_property
    def _targets_by_name(self) -> dict[str, Target]:
        return targets_by_name(self.targets)

    def target(self, name: str) -> Target | None:
        return self._targets_by_name.get(name)

    @cached_property
    def installs(self) -> tuple[InstallRule, ...]:
        return tuple(install_rules(self.calls, self.project_name))

    @cached_property
    def components(self) -> tuple[Component, ...]:
        return tuple(components_of(self.calls))

    @cached_property
    def interface_targets(self) -> tuple[InterfaceTarget, ...]:
        return tuple(interface_targets_of(self.calls))

    @cached_property
    def generated_interfaces(self) -> dict[str, bool]:
        """The interface files of the package that are generated, by path: whether that is certain."""
        return generated_files(self.interface_targets)

    @cached_property
    def knows_interfaces(self) -> bool:
        """Whether no other interface file of the package is generated."""
        unclear = not self.is_complete or self.reads_unknown_files
        return not unclear and all(word.is_known for target in self.interface_targets for word in target.files)

    @cached_property
    def packages(self) -> tuple[FoundPackage, ...]:
        """The calls of find_package."""
        return tuple(found_packages(self.calls))

    @cached_property
    def output_names(self) -> dict[str, str]:
        """Targets whose file has another name: target to name."""
        return output_names(self.named(*SETTERS), self._targets_by_name)

    @cached_property
    def export_names(self) -> dict[str, str]:
        """Targets that are exported under another name: target to name."""
        return dict(properties(self.named(*SETTERS), "EXPORT_NAME"))
