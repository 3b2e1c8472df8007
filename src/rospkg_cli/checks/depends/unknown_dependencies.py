"""Dependencies whose names nobody knows, and what is meant by them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

from ...languages.rep149_condition import always_holds
from ...package.manifest import Dependency
from ...ros.aliases import NOTHING_NEEDED, key_for_apt, key_for_pip, keys_for_cmake, successors
from ...ros.distros import DISTROS, Distro, Targets
from ...ros.imports import STANDARD
from ...ros.read_table import rows
from ...suggest import near
from .declared_dependencies import DeclaredDependencies
from .unavailable_on_target import UnavailableDependency

BUILD_TYPES_ALONE = frozenset({"ament_python"})
NO_NEEDS = frozenset({"doc_depend", "conflict", "replace"})
"""Tags that ask for nothing to be installed: rosdoc2 reads names of its own in doc_depend."""

PYTHON_TAGS = frozenset({"exec_depend", "test_depend", "run_depend"})

MIN_LETTERS = 5
"""A shorter name is too near to too many others."""

MIN_FAMILY = 3
"""So many packages around begin with a word before it is the family's name."""


@dataclass(frozen=True, slots=True)
class UnknownDependency:
    """A dependency that is no name of anything, or of nothing that a target has."""

    dependency: Dependency
    meant: str | None
    why: str
    """What the name is instead, as a sentence goes on."""
    fails: str = "Cannot locate rosdep definition for [{}]"
    """What rosdep says of the name."""
    instead: str = ""
    """What to do; "" where the name that is meant says it all."""
    elsewhere: bool = False
    """Whether another distribution has a package of that name."""


@dataclass(frozen=True)
class DependencyNames:
    declared: DeclaredDependencies
    targets: Targets

    def active(self) -> Iterator[Dependency]:
        """Yield the dependencies that hold for a target, of a package of ROS 2; a name only where it comes first."""
        seen: set[str] = set()
        for each in self.declared.manifest.dependencies if self.declared.is_checked else ():
            if (
                each.name
                and each.tag not in NO_NEEDS
                and each.name not in seen | BUILD_TYPES_ALONE
                and each.active(self.targets)
            ):
                seen.add(each.name)
                yield each

    def again(self, first: Dependency) -> list[Dependency]:
        """Return the dependencies of the same name that come later."""
        return [d for d in self.declared.manifest.dependencies if d.name == first.name and d is not first]

    def of_ros1(self) -> Iterator[tuple[Dependency, tuple[str, ...]]]:
        """Yield the dependencies that only ROS 1 has, and what took their place."""
        for each in self.active():
            taken = successors(each.name)
            if taken is not None and self.declared.workspace.named(each.name) is None:
                yield each, taken

    def pip_keys(self) -> Iterator[Dependency]:
        """Yield the dependencies that PyPI serves on a target."""
        for each in self.active():
            workspace = self.declared.workspace
            if workspace.named(each.name) is None and workspace.index.is_pip(each.name, self.targets):
                yield each

    def strange(self) -> Iterator[UnknownDependency]:
        """Yield the dependencies that no package and no key is called like, as far as that is certain."""
        for each in self.active():
            if self.declared.workspace.is_here(each.name) or successors(each.name) is not None:
                continue
            index = self.declared.workspace.index
            found = None if index.is_package(each.name) or index.is_key(each.name) else self.meant(each)
            lacking = UnavailableDependency(each, self.declared.workspace, self.targets, self.lacking(each))
            if found is None and lacking.distros:
                told = (lacking.meant, lacking.why, lacking.fails, lacking.instead)
                found = UnknownDependency(each, *told, elsewhere=bool(lacking.elsewhere))
            if found is not None:
                yield found

    def lacking(self, dependency: Dependency) -> tuple[Distro, ...]:
        """Return the targets on which a name is needed for certain and can't be had; none where it can be on one that
        may be the target, as long as nobody said which is."""
        without = [each for each in self.targets if self.declared.workspace.resolves(dependency.name, each) is False]
        needing = list(self.needing(dependency)) if without else []
        found = [each for each in needing if each in without]
        if not self.targets.names:
            return tuple(found) if found == needing else ()
        if self.declared.workspace.index.is_package(dependency.name):
            found = [each for each in found if each.end_of_life]  # packages come and go in Rolling, as they are rebuilt
        return tuple(found)

    def needing(self, dependency: Dependency) -> Iterator[Distro]:
        """Yield the targets for which a dependency of that name holds for certain."""
        same = [each for each in (dependency, *self.again(dependency)) if each.tag not in NO_NEEDS]
        for distro in self.targets:
            environments = Targets((distro.name,)).environments()
            if any(always_holds(each.condition, environments) for each in same):
                yield distro

    def meant(self, dependency: Dependency) -> UnknownDependency | None:
        """Return what is meant by a name that is wrong for certain, whatever an index would say."""
        name = dependency.name
        listed = [each for each in keys_for_cmake(name) if each != NOTHING_NEEDED and "*" not in each]
        if listed and not name.islower():
            return UnknownDependency(dependency, listed[0], "is what CMake calls it")
        if name.removeprefix("python3-").replace("-", "_") in STANDARD:
            return UnknownDependency(dependency, None, "comes with Python itself", instead="take the line out")
        key = key_for_pip(name, self.declared.workspace.index) if self.is_for_python(dependency) else None
        if key is not None:
            return UnknownDependency(dependency, key, "is its name on PyPI")
        key = key_for_apt(name, self.declared.workspace.index)
        if key is not None:
            return UnknownDependency(dependency, key, "is its name in Ubuntu")
        if later := rows("earlier.txt").get(name):
            return UnknownDependency(
                dependency, later[0], f"is called {' and '.join(f'`{each}`' for each in later)} since Humble"
            )
        if (member := self.renamed(name)) is not None:
            return UnknownDependency(dependency, member, "is no package of this workspace or any other that is known")
        if (core := self.misspelt(name)) is not None:
            guess = f"did you mean `{core}`?"
            return UnknownDependency(dependency, core, "is no package and no key that is known", instead=guess)
        return None

    def is_for_python(self, dependency: Dependency) -> bool:
        """Return whether a name may well be one of PyPI: a C++ package may have a private dependency of that name."""
        python = self.declared.facts.build_type == "ament_python"
        return python or "-" in dependency.name or dependency.tag in PYTHON_TAGS

    def renamed(self, name: str) -> str | None:
        """Return the one package around that is called like a name but for the word that its family begins with."""
        fitting = [each for each in self.declared.workspace.names if each.endswith(f"_{name}")]
        if len(fitting) != 1:
            return None
        prefix = fitting[0].removesuffix(name)
        family = [each for each in self.declared.workspace.names if each.startswith(prefix)]
        return fitting[0] if "_" not in prefix[:-1] and len(family) >= MIN_FAMILY else None

    def misspelt(self, name: str) -> str | None:
        """Return the one package that every distribution has and that is one letter away."""
        found = near(name, self.core_names, 1) if len(name) >= MIN_LETTERS else []
        return found[0] if len(found) == 1 else None

    @cached_property
    def core_names(self) -> frozenset[str]:
        packages = self.declared.workspace.index.packages
        return frozenset(name for name, distros in packages.items() if len(distros) == len(DISTROS))
