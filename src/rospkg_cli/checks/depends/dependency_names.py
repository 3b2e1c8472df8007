"""The names of declared dependencies: which are active, which are known, and which only ROS 1 had."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from ...languages.rep149_condition import evaluate_condition
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.dependency import Dependency
from ...ros.aliases import last_ros1_distro, successors
from ...ros.distros import Targets
from .declared_dependencies import DeclaredDependencies
from .intended_names import key_of_cmake_name
from .wrong_dependency_name import WrongDependencyName
from .wrong_names import wrong_name
from .wrong_python_names import is_installable, is_of_python_2

if TYPE_CHECKING:
    from .unneeded_names import UnneededNames

BUILD_TYPES_ALONE = frozenset({"ament_python"})

NO_NEEDS = frozenset({"doc_depend", "conflict", "replace"})
"""Tags for which nothing is installed; those of doc_depend may be names for rosdoc2."""


@dataclass(frozen=True)
class DependencyNames:
    declared: DeclaredDependencies
    targets: Targets
    cmake: CMake | None = None

    @cached_property
    def unneeded(self) -> UnneededNames:
        from .unneeded_names import UnneededNames  # a clean package needs none

        return UnneededNames(self.declared)

    def active(self) -> Iterator[Dependency]:
        """Yield the dependencies whose condition holds for a target: the first of each name."""
        seen: set[str] = set()
        for each in self.declared.manifest.dependencies if self.declared.is_checked else ():
            if (
                each.name
                and each.tag not in NO_NEEDS
                and each.name not in seen
                and each.name not in BUILD_TYPES_ALONE
                and each.active(self.targets)
            ):
                seen.add(each.name)
                yield each

    @property
    def has_interfaces(self) -> bool:
        """Whether the package has interfaces, or may have some."""
        facts = self.declared.facts
        return bool(facts.interfaces) or not facts.knows("interfaces")

    def repeated(self, first: Dependency) -> list[Dependency]:
        """Return the dependencies of the same name that come later."""
        return [each for each in self.by_name[first.name] if each is not first]

    @cached_property
    def by_name(self) -> dict[str, list[Dependency]]:
        """All dependencies, by name."""
        found: dict[str, list[Dependency]] = {}
        for each in self.declared.manifest.dependencies:
            found.setdefault(each.name, []).append(each)
        return found

    def is_known(self, name: str) -> bool:
        """Return whether a package or a key has the name; keys of Python 2 that no supported Ubuntu has don't count."""
        index = self.declared.workspace.index
        if name.startswith("python-"):
            return is_installable(name, index) and not is_of_python_2(name, index)
        return index.is_package(name) or index.is_key(name)

    def is_of_ros1(self, name: str) -> bool:
        """Return whether only ROS 1 has a package of a name."""
        return successors(name) is not None or (not self.is_known(name) and bool(last_ros1_distro(name)))

    def is_certain(self, same: Iterable[Dependency]) -> bool:
        """Return whether the condition of one of some dependencies holds for a target in every environment."""
        environments = self.targets.environments()
        return any(evaluate_condition(each.condition, one) for each in same for one in environments)

    def wrong(self, dependency: Dependency) -> WrongDependencyName | None:
        """Return what is wrong with a name in any case; a name that ROS 1 had is no misspelt one."""
        if self.is_known(dependency.name) or successors(dependency.name) is not None:
            return None
        if key := self.key_of_found(dependency.name):
            return WrongDependencyName("is no rosdep key", key)
        return wrong_name(self.declared, dependency, misspelt=not self.is_of_ros1(dependency.name))

    def key_of_found(self, name: str) -> str | None:
        """Return the key of what CMake finds by the same name in another case: `libopencv-dev` for `opencv`."""
        calls = self.cmake.named("find_package") if self.cmake else ()
        found = {text for call in calls for text in call.texts[:1] if text != name and text.lower() == name.lower()}
        return next((key for each in sorted(found) if (key := key_of_cmake_name(each))), None)

    def released_for_ros1(self) -> Iterator[tuple[Dependency, str]]:
        """Yield the dependencies that only ROS 1 ever had and that have no successor, with its last distribution."""
        workspace = self.declared.workspace
        is_knowable = workspace.is_complete or workspace.missing_repositories
        for each in self.active() if is_knowable else ():
            is_around = workspace.is_available(each.name) or workspace.may_lack(each.name)
            is_old = successors(each.name) is None and self.is_of_ros1(each.name)
            if is_old and not is_around and self.wrong(each) is None:
                yield each, last_ros1_distro(each.name)
