"""Whether launch files, tests, pages and scripts start a program of a package by its path."""

from __future__ import annotations

import re
from functools import cached_property

from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.copied_files import CopiedFile
from ...package.file_role import role_of
from ...ros.share_layout import LAUNCH
from ..repository.path_starts import is_started_by_path_alone, texts_of

PAGES = (".md", ".rst", ".sh", ".service", ".bash")


@dataclass(frozen=True)
class StartedPaths:
    package: CMakePackage

    def is_run_by_path(self, copy: CopiedFile, name: str) -> bool:
        """Return whether a launch file runs a script by its path, or pages and scripts do so and no `ros2` does."""
        files, own = self.package.cmake.package_files, self.package.facts.name
        if self.runs_by_path(name) or is_started_by_path_alone(files, own, copy.source):
            return True
        return any(f"/{copy.destination}" in text for text in texts_of(files))

    def is_named_with(self, folder: str, name: str) -> bool:
        """Return whether a launch file, or a test in Python, names a program together with its folder."""
        wanted = re.compile(rf"\b{re.escape(folder)}/{re.escape(name)}\b")
        return folder not in ("", "lib", self.package.facts.name) and any(map(wanted.search, self.launch_texts))

    def runs_by_path(self, name: str) -> bool:
        """Return whether a launch file has the name of a script in quotes, or at the end of a path."""
        wanted = re.compile(rf"""["'/]{re.escape(name)}["'\s<]""")
        return any(wanted.search(text) for text in self.launch_texts)

    @cached_property
    def launch_texts(self) -> tuple[str, ...]:
        paths = self.package.cmake.package_files.paths
        return tuple(
            self.package.cmake.package_files.readable_text(path)
            for path in paths
            if LAUNCH.fullmatch(path.rpartition("/")[2]) or (path.endswith(".py") and role_of(path) == "test")
        )

    @cached_property
    def pages(self) -> str:
        """The pages, scripts and units of systemd, as one text."""
        files = self.package.cmake.package_files
        return "\n".join(files.readable_text(path) for path in files.paths if path.endswith(PAGES))
