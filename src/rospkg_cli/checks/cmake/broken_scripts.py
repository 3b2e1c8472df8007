"""Scripts that are installed to lib/<package> and can't be executed there (CMK105)."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from typing import Literal

from ...light_dataclasses import dataclass
from ...package.cmake.copied_files import CopiedFile
from ...package.cmake.install_rule import InstallRule
from .installed_scripts import InstalledScripts
from .left_out_nodes import USES_ROS, is_node
from .module_imports import dotted_imports, is_only_imported

Wrong = Literal["files", "no shebang", "no bit", "directory", "directory, no bit", "neither"]
"""Why a script can't be executed; `neither`: the folder's permissions are not kept, and there is no bit to keep."""


@dataclass(frozen=True)
class BrokenScript:
    copy: CopiedFile
    wrong: Wrong


@dataclass(frozen=True)
class BrokenScripts:
    scripts: InstalledScripts

    def all(self) -> Iterator[BrokenScript]:
        """Yield the scripts that can't be executed where they are installed, each once."""
        files = self.scripts.package.cmake.package_files
        seen = {copy.source for copy in self.scripts.copies if copy.is_executable}
        for copy in (*self.scripts.copies, *self.nodes_below):
            wrong = self.wrong(copy)
            if wrong is None or is_only_imported(copy.source, files):
                continue
            if copy.source not in seen or wrong.startswith("no "):
                seen.add(copy.source)
                yield BrokenScript(copy, wrong)

    @property
    def nodes_below(self) -> Iterator[CopiedFile]:
        """Yield the nodes in Python that are copied, with their folder, below lib/<package>: `ros2 run` looks there."""
        home = f"lib/{self.scripts.package.facts.name}/"
        right = {copy.source for copy in self.scripts.copies}
        for copy in self.scripts.everywhere:
            is_below = copy.destination.startswith(home) and "/" in copy.destination.removeprefix(home)
            is_python = is_node(copy.source, self.scripts.package.cmake.package_files)
            is_copied_bare = copy.rule.kind == "DIRECTORY" and not copy.keeps_permissions
            if is_below and is_copied_bare and copy.source not in right and is_python:
                yield copy

    def wrong(self, copy: CopiedFile) -> Wrong | None:
        """Return why a file can't be executed; None where it can, or need not be."""
        files = self.scripts.script_files
        shebang, bit = files.has_shebang(copy.source), files.has_bit(copy.source)
        if posixpath.basename(copy.source) == "__init__.py" or self.scripts.starts.is_loaded(copy.source):
            return None
        if files.holds_definitions(copy.source):
            return None
        if copy.rule.kind == "PROGRAMS":
            if not shebang:
                return "no shebang" if files.is_python(copy.source) and files.does_something(copy.source) else None
            return None if bit or is_copied(copy.rule) else "no bit"
        if not shebang or not files.is_runnable(copy.source):
            return None
        if copy.rule.kind == "FILES":
            return None if copy.is_executable or self.gets_bit(copy) else "files"
        if copy.is_executable or self.gets_bit(copy):
            return None
        if copy.keeps_permissions:
            return None if bit else "directory, no bit"
        return "directory" if bit else "neither"

    def gets_bit(self, copy: CopiedFile) -> bool:
        """Return whether CMake runs chmod on an installed script; the first build may lack the bit."""
        calls = [call for call in self.scripts.package.cmake.named("execute_process") if "chmod" in call.texts]
        return any(text.endswith(f"/{posixpath.basename(copy.source)}") for call in calls for text in call.texts)


def is_copied(rule: InstallRule) -> bool:
    """Return whether a file is copied with `--symlink-install`, too: ament makes no link where these words stand."""
    return rule.rename is not None or bool(rule.permissions)


def is_module(scripts: InstalledScripts, script: BrokenScript) -> bool:
    """Return whether a script without the bit is imported in its folder, and no page or launch file starts it."""
    path, files = script.copy.source, scripts.package.cmake.package_files
    name, folder = posixpath.basename(path).removesuffix(".py"), posixpath.dirname(path)
    if scripts.script_files.has_bit(path) or not path.endswith(".py") or scripts.starts.is_wanted(path):
        return False
    neighbours = (each for each in files.paths if posixpath.dirname(each) == folder and each.endswith(".py"))
    imported = dotted_imports(files.readable_text(each) for each in neighbours if each != path)
    return any(each.lstrip(".").rpartition(".")[2] == name for each in imported)


def is_tool(scripts: InstalledScripts, script: BrokenScript) -> bool:
    """Return whether a script without `#!` has no word of ROS, and nothing starts it: it is run with `python3 FILE`."""
    path = script.copy.source
    if script.wrong != "no shebang" or scripts.starts.is_wanted(path):
        return False
    return USES_ROS.search(scripts.package.cmake.package_files.readable_text(path)) is None
