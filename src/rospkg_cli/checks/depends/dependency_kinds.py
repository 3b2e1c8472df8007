"""Dependencies that are declared, but not for the time when they are used (DEP201)."""

from __future__ import annotations

from collections.abc import Iterator

from ...light_dataclasses import dataclass
from ...package.manifest import Dependency
from ...ros.implied_dependencies import IN_LAUNCH_FILES, IN_SOURCES, implied_by
from ...ros.manifest import BUILDS, RUNS
from ...source import Span
from .declared_dependencies import DeclaredDependencies
from .undeclared_imports import ImportDependencies
from .undeclared_includes import IncludeDependencies
from .undeclared_launch_packages import LaunchDependencies


@dataclass(frozen=True, slots=True)
class WrongKind:
    """A dependency that is declared, but not for what it is used for."""

    dependency: Dependency
    """The first of its name."""
    wanted: str
    """The tag that is missing."""
    path: str
    span: Span
    usage: str
    """What is done with it there, as the rest of a sentence: `is imported here as …`."""


@dataclass(frozen=True)
class DependencyKinds:
    declared: DeclaredDependencies
    imports: ImportDependencies
    launch: LaunchDependencies
    includes: IncludeDependencies | None

    def wrong_kinds(self) -> Iterator[WrongKind]:
        """Yield the dependencies that are used when the package runs, or is built, and are not there then."""
        if not self.declared.is_checked:
            return
        seen: set[tuple[str, str]] = set()
        for names, wanted, path, span, usage in (*self.run_uses(), *self.build_uses()):
            tags = RUNS if wanted == "exec_depend" else BUILDS
            every = [d for d in self.declared.manifest.dependencies if d.name in names]
            if every and not any(d.tag in tags for d in every) and (every[0].name, wanted) not in seen:
                seen.add((every[0].name, wanted))
                yield WrongKind(every[0], wanted, path, span, usage)

    def run_uses(self) -> Iterator[tuple[tuple[str, ...], str, str, Span, str]]:
        """Yield what is used at run time, but for what comes with other dependencies for it."""
        there = implied_by([d.name for d in self.declared.manifest.dependencies if d.tag in RUNS], IN_LAUNCH_FILES)
        for place, names in self.imports.uses("run"):
            yield names, "exec_depend", place.path, place.span, f"is imported here as `{place.module}`"
        for use in self.launch.uses(tests=False):
            if use.name not in there:
                yield (use.name,), "exec_depend", use.path, use.span, "is needed by this launch file"

    def build_uses(self) -> Iterator[tuple[tuple[str, ...], str, str, Span, str]]:
        there = implied_by([d.name for d in self.declared.manifest.dependencies if d.tag in BUILDS], IN_SOURCES)
        for each in self.includes.packages() if self.includes else ():
            if each.role == "run" and not there.intersection(each.names):
                first = each.uses[0]
                yield each.names, "depend", first.path, first.span, f"is what `{first.header}` comes from"
