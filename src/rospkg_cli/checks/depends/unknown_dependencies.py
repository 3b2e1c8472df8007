"""Dependencies whose names are unknown, and the names to suggest instead (DEP001)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...light_dataclasses import dataclass
from ...package.dependency import Dependency
from .declared_dependencies import DeclaredDependencies
from .dependency_names import NO_NEEDS, DependencyNames
from .unavailable_on_target import UnavailableName, lacking_distros
from .wrong_dependency_name import WrongDependencyName

FOUND = frozenset({"depend", "build_depend", "buildtool_depend"})
"""The tags that ament_auto_find_build_dependencies() reads."""


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
    """Whether the line should be removed, as the intended dependency needs none."""
    may_be_key: bool = False
    """Whether a list of rosdep's that is not known here may have the name: it is no misspelt package."""


@dataclass(frozen=True)
class UnknownDependencies:
    names: DependencyNames

    @property
    def declared(self) -> DeclaredDependencies:
        return self.names.declared

    def all(self) -> Iterator[UnknownDependency]:
        """Yield the dependencies that are neither a package nor a rosdep key, as far as that is certain.

        Names that only ROS 1 has are left to DEP203.
        """
        for each in self.names.active():
            if not self.declared.workspace.is_available(each.name):
                found = self.names.wrong(each)
                if found is not None:
                    yield self.misnamed(each, found)
                elif not self.names.is_of_ros1(each.name):
                    yield from self.unavailable(each)

    def misnamed(self, dependency: Dependency, found: WrongDependencyName) -> UnknownDependency:
        """Return a dependency by a wrong name, with what to do about it."""
        suggestion, reason, todo = found.suggestion, found.reason, found.advice
        same = [dependency, *self.names.repeated(dependency)]
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
            is_uncertain=not self.names.is_certain(same),
            is_needless=bool(needless),
            may_be_key=self.is_key(found.suggestion),
        )

    def needless(self, same: Iterable[Dependency], name: str | None) -> str:
        """Return what to do where the intended name is the package itself, or is declared already; "" for others."""
        if name is None:
            return ""
        if name == self.declared.facts.name:
            return "did you mean this package itself? Remove the line"
        tags = {each.tag for each in self.names.by_name.get(name, ()) if each.active(self.names.targets)}
        is_declared = "depend" in tags or tags.issuperset(each.tag for each in same)
        return f"`{name}` is declared already: remove the line" if is_declared else ""

    def unavailable(self, dependency: Dependency) -> Iterator[UnknownDependency]:
        """Yield a dependency whose name is right, and which a target distribution lacks."""
        same = [each for each in (dependency, *self.names.repeated(dependency)) if each.tag not in NO_NEEDS]
        distros = lacking_distros(same, self.declared.workspace, self.names.targets)
        found = UnavailableName(dependency.name, self.declared.workspace, distros)
        if distros and found.is_certain:
            yield UnknownDependency(
                dependency,
                found.suggestion,
                found.reason,
                found.rosdep_error,
                found.advice,
                is_uncertain=bool(found.other_distros) or found.may_be_elsewhere or not self.names.is_certain(same),
                may_be_key=not found.for_project and (found.suggestion is None or self.is_key(found.suggestion)),
            )

    def is_found_by_name(self, same: Iterable[Dependency]) -> bool:
        """Return whether ament_cmake_auto runs find_package() for a dependency by its name, and nothing else does.

        It does so for dependencies of the build alone: the name of any other is for rosdep only.
        """
        if self.names.cmake is None or not self.names.cmake.named("ament_auto_find_build_dependencies"):
            return False
        names = {each.name for each in same if each.tag in FOUND}
        return bool(names) and not any(names & {*call.texts[:1]} for call in self.names.cmake.named("find_package"))

    def is_key(self, name: str | None) -> bool:
        """Return whether a suggested name is a key of rosdep, and no package."""
        workspace = self.declared.workspace
        return name is not None and not (workspace.is_available(name) or workspace.index.is_package(name))
