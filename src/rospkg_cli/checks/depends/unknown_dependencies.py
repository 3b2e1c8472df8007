"""Dependencies whose names are unknown, and the names to suggest instead (DEP001)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cached_property

from ...languages.rep149_condition import evaluate_condition
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.dependency import Dependency
from ...ros.aliases import last_ros1_distro, successors
from ...ros.distros import Targets
from .declared_dependencies import DeclaredDependencies
from .intended_names import key_of_cmake_name
from .unavailable_on_target import UnavailableName, lacking_distros
from .wrong_names import WrongDependencyName, is_installable, is_of_python_2, wrong_name

BUILD_TYPES_ALONE = frozenset({"ament_python"})
SKIPPED = "; a page or a script here has rosdep skip it"
CLONED = "; a repository of that name is cloned here, and may have it"
FOUND = frozenset({"depend", "build_depend", "buildtool_depend"})
"""The tags that ament_auto_find_build_dependencies() reads."""
NO_NEEDS = frozenset({"doc_depend", "conflict", "replace"})
"""Tags that install nothing: rosdoc2 reads names of its own in doc_depend."""


@dataclass(frozen=True, slots=True)
class UnknownDependency:
    """A dependency whose name is neither a package nor a rosdep key, or is one that a target lacks."""

    dependency: Dependency
    suggestion: str | None
    """The name to write instead."""
    reason: str
    """What is wrong with the name, as the rest of a sentence: `is its name on PyPI`."""
    rosdep_error: str = "Cannot locate rosdep definition for [{}]"
    """What rosdep prints; `{}` is the name."""
    advice: str = ""
    """What to do; "" where it is to write the suggestion."""
    parts: tuple[str, ...] = ()
    """The names, where one tag holds several."""
    is_uncertain: bool = False
    """Whether another distribution, or a repository that is not here, may have a package of that name."""
    is_needless: bool = False
    """Whether the line is to go, as what is meant needs none."""
    may_be_key: bool = False
    """Whether a list of rosdep's that is not known may have the name: it is no slip of a package."""


@dataclass(frozen=True)
class DependencyNames:
    declared: DeclaredDependencies
    targets: Targets
    cmake: CMake | None = None

    def is_found_by_name(self, same: Iterable[Dependency]) -> bool:
        """Return whether ament_cmake_auto looks for a dependency by its name, and nothing else does.

        It does so for what the build needs alone: a key that is for running is a name for rosdep.
        """
        if self.cmake is None or not self.cmake.named("ament_auto_find_build_dependencies"):
            return False
        names = {each.name for each in same if each.tag in FOUND}
        return bool(names) and not any(names & {*call.texts[:1]} for call in self.cmake.named("find_package"))

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
        facts = self.declared.facts
        return bool(facts.interfaces) or not facts.knows("interfaces")

    def repeated(self, first: Dependency) -> list[Dependency]:
        """Return the dependencies of the same name that come later."""
        return [each for each in self.by_name[first.name] if each is not first]

    def is_skipped(self, name: str) -> bool:
        """Return whether whoever follows a page or a script here has rosdep leave a name out."""
        return name in self.skipped

    def kept_aside(self, found: UnknownDependency) -> str:
        """Return why nobody here misses a name, as the end of a sentence; "" where nothing says so."""
        name = found.dependency.name
        if self.is_skipped(name):
            return SKIPPED
        from .fetched_repositories import FetchedRepositories  # a clean package needs none
        from .own_rosdep_lists import OwnRosdepLists

        declared = self.declared
        if FetchedRepositories(declared.release.files, declared.workspace, declared.otherwise.hidden).has_cloned(name):
            return CLONED
        return OwnRosdepLists(declared).may_have(name) if found.may_be_key else ""

    def is_key(self, name: str | None) -> bool:
        """Return whether a name that is meant is one of rosdep's, and of no package."""
        workspace = self.declared.workspace
        return name is not None and not (workspace.is_available(name) or workspace.index.is_package(name))

    @cached_property
    def skipped(self) -> frozenset[str]:
        from .skipped_keys import skipped_keys  # a clean package needs none

        return skipped_keys(self.declared.release.files)

    @cached_property
    def by_name(self) -> dict[str, list[Dependency]]:
        found: dict[str, list[Dependency]] = {}
        for each in self.declared.manifest.dependencies:
            found.setdefault(each.name, []).append(each)
        return found

    def unknown(self) -> Iterator[UnknownDependency]:
        """Yield the dependencies that are neither a package nor a rosdep key, as far as that is certain.

        Names that only ROS 1 has are left to DEP203.
        """
        for each in self.active():
            if not self.declared.workspace.is_available(each.name):
                found = self.wrong(each)
                if found is not None:
                    yield self.misnamed(each, found)
                elif not self.is_of_ros1(each.name):
                    yield from self.unavailable(each)

    def misnamed(self, dependency: Dependency, found: WrongDependencyName) -> UnknownDependency:
        """Return a dependency by a wrong name, with what to do about it."""
        suggestion, reason, todo = found.suggestion, found.reason, found.advice
        same = [dependency, *self.repeated(dependency)]
        if needless := self.needless(same, suggestion):
            suggestion, todo = None, needless
        elif suggestion and self.is_found_by_name(same):
            todo = f"write `{suggestion}`, and find and link `{dependency.name}` in CMakeLists.txt yourself"
            suggestion, reason = None, f"{reason}, and ament_auto finds it by that"
        return UnknownDependency(
            dependency,
            suggestion,
            reason,
            found.rosdep_error,
            todo,
            found.parts,
            is_uncertain=not self.is_certain(same),
            is_needless=bool(needless),
            may_be_key=self.is_key(found.suggestion),
        )

    def needless(self, same: Iterable[Dependency], name: str | None) -> str:
        """Return what to do where a name stands for the package itself, or for what it declares already; else ""."""
        if name is None:
            return ""
        if name == self.declared.facts.name:
            return "did you mean this package itself? Remove the line"
        tags = {each.tag for each in self.by_name.get(name, ()) if each.active(self.targets)}
        is_declared = "depend" in tags or tags.issuperset(each.tag for each in same)
        return f"`{name}` is declared already: remove the line" if is_declared else ""

    def wrong(self, dependency: Dependency) -> WrongDependencyName | None:
        """Return what is wrong with a name in any case; of one that ROS 1 had, no more than its name elsewhere."""
        if self.is_known(dependency.name) or successors(dependency.name) is not None:
            return None
        if key := self.key_of_found(dependency.name):
            return WrongDependencyName("is no rosdep key", key)
        return wrong_name(self.declared, dependency, misspelt=not self.is_of_ros1(dependency.name))

    def key_of_found(self, name: str) -> str | None:
        """Return the key of what CMake finds by the same name in other letters: `libopencv-dev` of OpenCV."""
        calls = self.cmake.named("find_package") if self.cmake else ()
        found = {text for call in calls for text in call.texts[:1] if text != name and text.lower() == name.lower()}
        return next((key for each in sorted(found) if (key := key_of_cmake_name(each))), None)

    def is_known(self, name: str) -> bool:
        """Return whether a package or a key has the name; a key of Python 2 that no Ubuntu has any more has none."""
        index = self.declared.workspace.index
        if name.startswith("python-"):
            return is_installable(name, index) and not is_of_python_2(name, index)
        return index.is_package(name) or index.is_key(name)

    def is_of_ros1(self, name: str) -> bool:
        """Return whether only ROS 1 has a package of a name."""
        return successors(name) is not None or (not self.is_known(name) and bool(last_ros1_distro(name)))

    def is_certain(self, same: Iterable[Dependency]) -> bool:
        """Return whether the condition of one of some dependencies holds for a target whatever anybody sets."""
        environments = self.targets.environments()
        return any(evaluate_condition(each.condition, one) for each in same for one in environments)

    def released_for_ros1(self) -> Iterator[tuple[Dependency, str]]:
        """Yield the dependencies that only ROS 1 ever had and that have no successor, with its last distribution."""
        workspace = self.declared.workspace
        is_told = workspace.is_complete or workspace.missing_repositories
        for each in self.active() if is_told else ():
            is_around = workspace.is_available(each.name) or workspace.may_lack(each.name)
            is_old = successors(each.name) is None and self.is_of_ros1(each.name)
            if is_old and not is_around and self.wrong(each) is None:
                yield each, last_ros1_distro(each.name)

    def unavailable(self, dependency: Dependency) -> Iterator[UnknownDependency]:
        same = [each for each in (dependency, *self.repeated(dependency)) if each.tag not in NO_NEEDS]
        distros = lacking_distros(same, self.declared.workspace, self.targets)
        found = UnavailableName(dependency.name, self.declared.workspace, distros)
        if distros and found.is_told:
            yield UnknownDependency(
                dependency,
                found.suggestion,
                found.reason,
                found.rosdep_error,
                found.advice,
                is_uncertain=bool(found.other_distros) or found.may_be_elsewhere or not self.is_certain(same),
                may_be_key=not found.for_project and (found.suggestion is None or self.is_key(found.suggestion)),
            )
