"""Dependencies whose names are unknown, and the names to suggest instead (DEP001)."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...light_dataclasses import dataclass
from ...package.manifest import Dependency
from ...ros.aliases import NOTHING_NEEDED, key_for_apt, key_for_pip, keys_for_cmake, successors
from ...ros.distros import DISTROS, Targets
from ...ros.imports import STANDARD
from ...suggest import near_names
from .declared_dependencies import DeclaredDependencies
from .unavailable_on_target import UnavailableName, lacking_distros

BUILD_TYPES_ALONE = frozenset({"ament_python"})
NO_NEEDS = frozenset({"doc_depend", "conflict", "replace"})
"""Tags that install nothing: rosdoc2 reads names of its own in doc_depend."""

PYTHON_TAGS = frozenset({"exec_depend", "test_depend", "run_depend"})

MIN_LETTERS = 5
"""Of a misspelt name: a shorter one is similar to too many others."""

MIN_FAMILY = 3
"""So many packages of the workspace begin with a word before it counts as the prefix of a family."""


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
    is_released_elsewhere: bool = False
    """Whether another distribution has a package of that name."""


@dataclass(frozen=True)
class DependencyNames:
    declared: DeclaredDependencies
    targets: Targets

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
        workspace = self.declared.workspace
        for each in self.active():
            if workspace.is_available(each.name) or successors(each.name) is not None:
                continue
            is_known = workspace.index.is_package(each.name) or workspace.index.is_key(each.name)
            found = None if is_known else self.wrong_name(each)
            yield from (found,) if found else self.unavailable(each)

    def unavailable(self, dependency: Dependency) -> Iterator[UnknownDependency]:
        same = [each for each in (dependency, *self.repeated(dependency)) if each.tag not in NO_NEEDS]
        distros = lacking_distros(same, self.declared.workspace, self.targets)
        if distros:
            found = UnavailableName(dependency.name, self.declared.workspace.index, distros)
            yield UnknownDependency(
                dependency,
                found.suggestion,
                found.reason,
                found.rosdep_error,
                found.advice,
                is_released_elsewhere=bool(found.other_distros),
            )

    def wrong_name(self, dependency: Dependency) -> UnknownDependency | None:
        """Return what is wrong with a name that is wrong in any case, with or without a fetched index; else None."""
        name = dependency.name
        listed = [each for each in keys_for_cmake(name) if each != NOTHING_NEEDED and "*" not in each]
        if listed and not name.islower():
            return UnknownDependency(dependency, listed[0], "is what CMake calls it")
        if name.removeprefix("python3-").replace("-", "_") in STANDARD:
            return UnknownDependency(dependency, None, "comes with Python itself", advice="remove the line")
        key = key_for_pip(name, self.declared.workspace.index) if self.is_for_python(dependency) else None
        if key is not None:
            return UnknownDependency(dependency, key, "is its name on PyPI")
        key = key_for_apt(name, self.declared.workspace.index)
        if key is not None:
            return UnknownDependency(dependency, key, "is its name in Ubuntu")
        if (member := self.with_family_prefix(name)) is not None:
            return UnknownDependency(dependency, member, "is no known ROS package, here or elsewhere")
        if (core := self.misspelt(name)) is not None:
            guess = f"did you mean `{core}`?"
            return UnknownDependency(dependency, core, "is no known ROS package or rosdep key", advice=guess)
        return None

    def is_for_python(self, dependency: Dependency) -> bool:
        """Return whether a name may be one of PyPI: in a C++ package it may be a private dependency."""
        python = self.declared.facts.build_type == "ament_python"
        return python or "-" in dependency.name or dependency.tag in PYTHON_TAGS

    def with_family_prefix(self, name: str) -> str | None:
        """Return the only package of the workspace that has the name after a family prefix: `acme_arm` for `arm`."""
        matching = [each for each in self.declared.workspace.names if each.endswith(f"_{name}")]
        if len(matching) != 1:
            return None
        prefix = matching[0].removesuffix(name)
        family = [each for each in self.declared.workspace.names if each.startswith(prefix)]
        return matching[0] if "_" not in prefix[:-1] and len(family) >= MIN_FAMILY else None

    def misspelt(self, name: str) -> str | None:
        """Return the only package of all distributions that is one letter away."""
        found = near_names(name, self.core_names, 1) if len(name) >= MIN_LETTERS else []
        return found[0] if len(found) == 1 else None

    @cached_property
    def core_names(self) -> frozenset[str]:
        packages = self.declared.workspace.index.packages
        return frozenset(name for name, distros in packages.items() if len(distros) == len(DISTROS))
