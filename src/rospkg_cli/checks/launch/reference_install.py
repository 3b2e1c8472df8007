"""Rule input: the files that launch files name and that are not installed there (LCH004)."""

from __future__ import annotations

from collections.abc import Iterator

from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.install_table import InstalledFile
from ...package.setup.setup_py import SetupPy
from ...source import Span
from ..install_faults import InstallFaults
from .launch_context import LaunchContext
from .missing_reference import MissingReference
from .missing_references import missing_references


@dataclass(frozen=True)
class ReferenceInstall:
    scope: LaunchContext
    faults: InstallFaults

    @property
    def name(self) -> str:
        return self.scope.package.name

    @property
    def cmake(self) -> CMake | None:
        return self.scope.cmake

    @property
    def setup(self) -> SetupPy | None:
        return self.faults.setup

    def missing(self) -> Iterator[MissingReference]:
        """Yield the files that are named, exist and are not installed, where no install rule reports it."""
        for each in missing_references(self.scope):
            if each.state in ("not installed", "elsewhere") and not self.is_said(each):
                yield each

    def rule_of(self, missing: MissingReference) -> InstalledFile | None:
        """Return what installs a file elsewhere."""
        rows = self.scope.table.rows if self.scope.table is not None and missing.state == "elsewhere" else ()
        return next((row for row in rows if (row.source, row.destination) == (missing.path, missing.better_path)), None)

    def cause_of(self, row: InstalledFile) -> tuple[str, Span]:
        """Return the command of CMake that installs a file, or the place in setup.py."""
        calls = (rule.call for rule in self.cmake.installs) if self.cmake is not None else ()
        spans = (call.command.span for call in calls if call.path == row.path)
        return row.path, next((span for span in spans if span.holds(row.span)), row.span)

    def is_said(self, missing: MissingReference) -> bool:
        """Return whether an install rule reports it.

        SET208 and CMK111 do for a wrong destination, CMK001 and SET401 for the share
        directory of another name that CMake and setup.py give the package.
        """
        project = self.cmake.project_name if self.cmake is not None else self.name
        said = self.setup.setup_text("name") if self.setup is not None else None
        others = {project, said.text if said is not None else self.name} - {self.name}
        misplaced = tuple(f"share/{other}/" for other in others)
        place = (missing.better_path or "") if missing.state == "elsewhere" else ""
        if place.startswith(misplaced) or (place and self.faults.is_reported_at_destination(missing.package, place)):
            return True
        return self.faults.is_reported(missing.package, missing.path)


@dataclass(frozen=True)
class InstalledReferences:
    files: tuple[ReferenceInstall, ...]

    def missing(self) -> Iterator[tuple[tuple[ReferenceInstall, MissingReference], ...]]:
        """Yield the files that are named and not installed there, those together that one install rule misplaces."""
        found: dict[tuple[str, Span], list[tuple[ReferenceInstall, MissingReference]]] = {}
        for file in self.files:
            for missing in file.missing():
                row = file.rule_of(missing)
                cause = file.cause_of(row) if row is not None else (file.scope.file.path, missing.span)
                found.setdefault(cause, []).append((file, missing))
        yield from map(tuple, found.values())
