"""Dependencies that are declared, but not for the time when they are used (DEP201)."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from typing import Annotated

from ...light_dataclasses import dataclass
from ...package.dependency import Dependency
from ...package.interfaces.interface_file import InterfaceFile
from ...ros.manifest import BUILDS, EXPORTED, RUNS
from ...unreadable import READABLE
from ..interfaces.package_interfaces import InterfaceGeneration
from ..repository.kinds_installed_apart import KindsInstalledApart
from .brought_dependencies import Bringer
from .declared_dependencies import DeclaredDependencies
from .kind_uses import KindUse, KindUses
from .there_to_launch import STARTER, there_to_launch
from .transitive_dependencies import with_members
from .undeclared_imports import ImportDependencies
from .undeclared_includes import IncludeDependencies
from .undeclared_launch_packages import LaunchDependencies


@dataclass(frozen=True, slots=True)
class WrongKind:
    """A dependency that is declared, but not for what it is used for."""

    dependency: Dependency
    """The first declaration of its name."""
    use: KindUse
    bringer: Bringer | None
    """The dependency that is declared for it and brings this one today, or may bring it; None where none does."""


@dataclass(frozen=True)
class DependencyKinds:
    declared: DeclaredDependencies
    imports: ImportDependencies
    launch: LaunchDependencies
    includes: IncludeDependencies | None
    interfaces: Annotated[tuple[InterfaceFile, ...], READABLE]
    generation: InterfaceGeneration
    apart: KindsInstalledApart

    @property
    def uses(self) -> KindUses:
        return KindUses(self.declared, self.imports, self.launch, self.includes, self.interfaces, self.generation)

    def wrong_kinds(self) -> Iterator[WrongKind]:
        """Yield the dependencies that are used when the package runs, or is built, and are not there then."""
        if not self.declared.is_checked:
            return
        seen: set[tuple[str, bool]] = set()
        for use in self.uses.all():
            runs = use.wanted == "exec_depend"
            tags = RUNS if runs else BUILDS | EXPORTED if use.is_passed_on else BUILDS
            every = [d for d in self.declared.manifest.dependencies if d.name in use.names] or self.over(use)
            if every and not any(d.tag in tags for d in every) and (every[0].name, runs) not in seen:
                seen.add((every[0].name, runs))
                yield WrongKind(every[0], use, self.bringer(use, tags))

    def over(self, use: KindUse) -> list[Dependency]:
        """Return the declared metapackages that contain what the build uses."""
        if use.need not in ("find", "include"):
            return []
        every, workspace = self.declared.manifest.dependencies, self.declared.workspace
        return [each for each in every if not with_members([each.name], workspace).isdisjoint(use.names)]

    def bringer(self, use: KindUse, tags: Collection[str]) -> Bringer | None:
        """Return what brings a dependency at the time of its use, or may bring it; `ros2launch` to a launch file."""
        if use.need == "launch" and not there_to_launch(self.declared).isdisjoint(use.names):
            return Bringer(STARTER)
        return self.declared.brings.bringer_among(use.names, self.declared.brings.brought_with(tags))
