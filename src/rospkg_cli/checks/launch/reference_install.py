"""Joined input: what launch files name, against the rules that install it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

from ...package.cmake.cmake_project import CMake
from ...package.setup.setup_py import SetupPy
from ..cmake.share_folders import RuntimeFolders
from ..setup.share_files import ShareFiles, folder_of
from .missing_references import LaunchContext, MissingReference


@dataclass(frozen=True)
class ReferenceInstall:
    scope: LaunchContext
    shared: ShareFiles | None
    folders: RuntimeFolders | None

    @property
    def name(self) -> str:
        return self.scope.package.name

    @property
    def cmake(self) -> CMake | None:
        return self.scope.cmake

    @property
    def setup(self) -> SetupPy | None:
        return self.shared.package.setup if self.shared is not None and self.cmake is None else None

    def missing(self) -> Iterator[MissingReference]:
        """Yield the files that are named, exist and are not installed, where no install rule reports it."""
        for each in self.scope.missing():
            if each.state in ("not installed", "elsewhere") and not self.is_said(each):
                yield each

    def is_said(self, missing: MissingReference) -> bool:
        """Return whether an install rule reports it.

        CMK111 does for an absolute destination, CMK001 for the share directory of a project of another name.
        """
        project = self.cmake.project_name if self.cmake is not None else self.name
        misplaced = ("/", f"share/{project}/") if project != self.name else ("/",)
        if missing.state == "elsewhere" and (missing.better_path or "").startswith(misplaced):
            return True
        top = missing.path.partition("/")[0]
        if missing.package == self.name:
            return top in self.said_folders or missing.path in self.said_files
        facts = self.scope.workspace.named(missing.package)
        given = facts is not None and facts.folder in self.scope.workspace.selected
        return given and facts is not None and not any(path.startswith(f"{top}/") for path in facts.share_files)

    @cached_property
    def said_folders(self) -> frozenset[str]:
        """The folders of which nothing is installed, and those whose glob matches nothing."""
        found = set(self.folders.uninstalled()) if self.folders is not None and self.cmake is not None else set()
        if self.setup is not None and self.shared is not None:
            found |= {
                *self.shared.uninstalled_runtime_folders,
                *(folder_of(glob.pattern) for glob in self.shared.empty_globs),
            }
        return frozenset(found)

    @cached_property
    def said_files(self) -> frozenset[str]:
        """The files in the folders of those that a glob finds."""
        return (
            frozenset(each.path for each in self.shared.uninstalled_neighbours)
            if self.setup and self.shared
            else frozenset()
        )
