"""Scripts in lib/<package>: whether they are executable, and scripts of the same folders that no rule installs."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from functools import cached_property
from typing import Literal

from ...languages.cmake.evaluated_command import path_in_package
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.copied_files import CopiedFile, copied_files
from ...package.cmake.install_rules import InstallRule
from ...package.launch.live_text import live_text
from ...package.workspace import Workspace
from ...ros.share_layout import LAUNCH
from ..repository.pages_and_scripts import pages_and_scripts
from .left_out_nodes import USES_ROS, is_last, is_left_out, is_node
from .module_imports import dotted_imports, is_only_imported

SHELL = (".sh", ".bash")
"""Scripts that are mostly helpers of developers."""
ASIDE = frozenset({"test", "tests"})
Wrong = Literal["files", "no shebang", "no bit", "directory", "directory, no bit", "neither"]
"""Why a script can't be executed; `neither`: the folder's permissions are not kept, and there is no bit to keep."""

IMPORTED = regex(r"^[ \t]*(?:from|import)[ \t]+\.?(\w+)", re.MULTILINE)
STARTS = regex(r"^(?:if[ \t(]+__name__|[A-Za-z_][\w.]*[ \t]*\(|(?:while|for|with|try|raise)\b)", re.MULTILINE)
"""A statement at the top level that does something."""
ENTRY = "def generate_launch_description("
FOR_ROS1 = regex(r"^[ \t]*(?:import|from)[ \t]+rospy\b", re.MULTILINE)
DEFINES = regex(r"^(?:class|def|async def)\b", re.MULTILINE)
IMPORTS = regex(r"^(?:from[ \t]+[\w.]+[ \t]+import[ \t(]|import[ \t]+[\w.]+[ \t]*$)", re.MULTILINE)
"""A line that is of Python and of no shell."""


@dataclass(frozen=True)
class BrokenScript:
    copy: CopiedFile
    wrong: Wrong


def is_copied(rule: InstallRule) -> bool:
    """Return whether a file is copied with `--symlink-install`, too: ament has no link for what these words ask for."""
    return rule.rename is not None or bool(rule.permissions)


@dataclass(frozen=True)
class InstalledScripts:
    package: CMakePackage
    workspace: Workspace

    @cached_property
    def copies(self) -> tuple[CopiedFile, ...]:
        """The files of the package that are copied to lib/<package> itself."""
        home = f"lib/{self.package.facts.name}"
        return tuple(copy for copy in self.everywhere if posixpath.dirname(copy.destination) == home)

    @cached_property
    def everywhere(self) -> tuple[CopiedFile, ...]:
        """All files of the package that are certainly copied."""
        rules = (rule for rule in self.package.cmake.installs if not rule.call.maybe and not rule.call.testing)
        copies = (copy for rule in rules for copy in copied_files(rule, self.package.cmake.package_files))
        return tuple(copy for copy in copies if not copy.item.maybe)

    @property
    def nodes_below(self) -> Iterator[CopiedFile]:
        """Yield the nodes in Python that are copied, with their folder, below lib/<package>: `ros2 run` looks there."""
        home = f"lib/{self.package.facts.name}/"
        right = {copy.source for copy in self.copies}
        for copy in self.everywhere:
            is_below = copy.destination.startswith(home) and "/" in copy.destination.removeprefix(home)
            is_python = is_node(copy.source, self.package.cmake.package_files)
            is_copied_bare = copy.rule.kind == "DIRECTORY" and not copy.keeps_permissions
            if is_below and is_copied_bare and copy.source not in right and is_python:
                yield copy

    @property
    def uses_programs(self) -> bool:
        """Whether some scripts are installed as they should be."""
        return any(copy.rule.kind == "PROGRAMS" for copy in self.copies)

    def broken(self) -> Iterator[BrokenScript]:
        """Yield the scripts that can't be executed where they are installed, each once."""
        seen = {copy.source for copy in self.copies if copy.is_executable}
        for copy in (*self.copies, *self.nodes_below):
            wrong = self.wrong(copy)
            if wrong is None or is_only_imported(copy.source, self.package.cmake.package_files):
                continue
            if copy.source not in seen or wrong.startswith("no "):
                seen.add(copy.source)
                yield BrokenScript(copy, wrong)

    def gets_bit(self, copy: CopiedFile) -> bool:
        """Return whether CMake runs chmod on an installed script; the first build may lack the bit."""
        calls = [call for call in self.package.cmake.named("execute_process") if "chmod" in call.texts]
        return any(text.endswith(f"/{posixpath.basename(copy.source)}") for call in calls for text in call.texts)

    def wrong(self, copy: CopiedFile) -> Wrong | None:
        shebang, bit = self.has_shebang(copy.source), self.has_bit(copy.source)
        if posixpath.basename(copy.source) == "__init__.py" or self.is_no_program(copy.source):
            return None
        if self.holds_definitions(copy.source):
            return None
        if copy.rule.kind == "PROGRAMS":
            if not shebang:
                return "no shebang" if self.is_python(copy.source) and self.does_something(copy.source) else None
            return None if bit or is_copied(copy.rule) else "no bit"
        if not shebang or not self.is_runnable(copy.source):
            return None
        if copy.rule.kind == "FILES":
            return None if copy.is_executable or self.gets_bit(copy) else "files"
        if copy.is_executable or self.gets_bit(copy):
            return None
        if copy.keeps_permissions:
            return None if bit else "directory, no bit"
        return "directory" if bit else "neither"

    def is_module(self, script: BrokenScript) -> bool:
        """Return whether a script without the bit is imported in its folder, and no page or launch file starts it."""
        path, files = script.copy.source, self.package.cmake.package_files
        name, folder = posixpath.basename(path).removesuffix(".py"), posixpath.dirname(path)
        if self.has_bit(path) or not path.endswith(".py") or self.is_wanted(path):
            return False
        beside = (each for each in files.paths if posixpath.dirname(each) == folder and each.endswith(".py"))
        imported = dotted_imports(files.readable_text(each) for each in beside if each != path)
        return any(each.lstrip(".").rpartition(".")[2] == name for each in imported)

    def is_wanted(self, path: str) -> bool:
        """Return whether a launch file of the workspace starts a script, or a README does so with `ros2 run`."""
        name, files = posixpath.basename(path), self.package.cmake.package_files
        if self.workspace.having("started_nodes", self.package.facts.name, name):
            return True
        started = re.compile(rf"\bros2 run {re.escape(self.package.facts.name)} {re.escape(name)}(?![.-]?\w)")
        texts = (*self.texts, *(files.readable_text(each) for each in files.paths if is_readme(each)))
        named = re.compile(rf"(?<![\w.-]){re.escape(name)}(?!\w)")
        return any(map(named.search, self.live_launches)) or any(map(started.search, texts))

    def is_run(self, path: str) -> bool:
        """Return whether a page or a script, here or above, runs a script with `ros2 run`."""
        name = re.escape(posixpath.basename(path))
        started = re.compile(rf"\bros2[ \t]+run[ \t]+{re.escape(self.package.facts.name)}[ \t]+{name}(?![.-]?\w)")
        return any(map(started.search, pages_and_scripts(self.package.cmake.package_files)))

    def is_tool(self, script: BrokenScript) -> bool:
        """Return whether a script without `#!` has no word of ROS, and nothing starts it: people give it to Python."""
        path = script.copy.source
        if script.wrong != "no shebang" or self.is_wanted(path):
            return False
        return USES_ROS.search(self.package.cmake.package_files.readable_text(path)) is None

    def holds_definitions(self, path: str) -> bool:
        """Return whether a file is a Python module to import: definitions, and nothing that does something."""
        text = self.package.cmake.package_files.readable_text(path)
        return path.endswith(".py") and DEFINES.search(text) is not None and not self.does_something(path)

    def is_python(self, path: str) -> bool:
        """Return whether a file is Python by its name, or by its imports where its name has no suffix."""
        if "." in posixpath.basename(path):
            return path.endswith(".py")
        return IMPORTS.search(self.package.cmake.package_files.readable_text(path)) is not None

    def does_something(self, path: str) -> bool:
        """Return whether a Python file is more than definitions, which are there to be imported."""
        return STARTS.search(self.package.cmake.package_files.readable_text(path)) is not None

    def is_no_program(self, path: str) -> bool:
        """Return whether an installed script imports a file, launch loads it, or a launch file hands it to Python."""
        name = posixpath.basename(path)
        if name.removesuffix(".py") in self.imported or ENTRY in self.package.cmake.package_files.readable_text(path):
            return True
        handed = re.compile(rf"(?<!executable='){re.escape(name)}'")  # that one is started as a program
        return any(handed.search(text) for text in self.texts_with_python) or self.is_run_by_cmake(name)

    def is_run_by_cmake(self, name: str) -> bool:
        """Return whether a CMake file other than a CMakeLists.txt names a script: a macro for others hands it on."""
        files = self.package.cmake.package_files
        macros = (path for path in files.paths if path.endswith((".cmake", ".cmake.in")))
        return any(f"/{name}" in files.readable_text(path) for path in macros)

    @cached_property
    def imported(self) -> frozenset[str]:
        """The modules that installed scripts import from their own folder, and all others that they import."""
        return frozenset(name for text in self.texts for name in IMPORTED.findall(text))

    @cached_property
    def texts_with_python(self) -> tuple[str, ...]:
        """The launch files that run Python, with single quotes."""
        return tuple(text.replace('"', "'") for text in self.launch_texts if "python3" in text)

    @cached_property
    def live_launches(self) -> tuple[str, ...]:
        """The launch files without their comments."""
        files = self.package.cmake.package_files
        paths = (path for path in files.paths if LAUNCH.fullmatch(posixpath.basename(path)))
        return tuple(live_text(files, path) for path in paths)

    @cached_property
    def launch_texts(self) -> tuple[str, ...]:
        paths = self.package.cmake.package_files.paths
        return tuple(
            self.package.cmake.package_files.readable_text(path)
            for path in paths
            if LAUNCH.fullmatch(posixpath.basename(path))
        )

    def is_runnable(self, path: str) -> bool:
        """Return whether a file is a program, by its name."""
        return posixpath.splitext(path)[1] in (".py", ".sh", ".bash", "")

    def has_shebang(self, path: str) -> bool:
        try:
            return self.package.cmake.package_files.tree.entry(path).data.startswith(b"#!")
        except OSError:
            return True

    def has_bit(self, path: str) -> bool:
        try:
            return self.package.cmake.package_files.is_executable(path)
        except OSError:
            return True

    def uninstalled(self) -> Iterator[tuple[str, CopiedFile]]:
        """Yield the scripts that no rule installs, each with an installed script of its folder."""
        cmake = self.package.cmake
        if any(rule.kind == "CODE" or rule.destination is None for rule in cmake.installs if rule.kind != "TARGETS"):
            return
        programs = {copy.source: copy for copy in self.copies if copy.rule.kind == "PROGRAMS"}
        named = {path for call in cmake.calls for text in call.texts if (path := path_in_package(text, call.folder))}
        for folder in sorted({posixpath.dirname(path) for path in programs}):
            installed = next(copy for path, copy in programs.items() if posixpath.dirname(path) == folder)
            for path in cmake.package_files.paths:
                fits = posixpath.dirname(path) == folder and path not in named and self.is_script(path)
                if not fits or (path.endswith(SHELL) and not self.is_wanted(path)):
                    continue
                if not self.is_installed(path) and not ASIDE.intersection(path.split("/")):
                    yield path, installed

    def is_installed(self, path: str) -> bool:
        files = self.package.cmake.package_files
        return any(path == copy.source for rule in self.package.cmake.installs for copy in copied_files(rule, files))

    def is_script(self, path: str) -> bool:
        """Return whether a file is a program that a user may want to run."""
        is_private = posixpath.basename(path).startswith((".", "_", "test_"))
        is_private = is_private or FOR_ROS1.search(self.package.cmake.package_files.readable_text(path)) is not None
        if is_private or not self.is_runnable(path) or not self.has_shebang(path):
            return False
        if self.has_bit(path) or any(posixpath.basename(path) in text for text in self.texts):
            return True
        files = self.package.cmake.package_files
        return is_left_out(path, files, self.is_installed) or is_last(path, files, self.is_installed)

    @cached_property
    def texts(self) -> tuple[str, ...]:
        """The installed scripts' texts."""
        return tuple(self.package.cmake.package_files.readable_text(copy.source) for copy in self.copies)


def is_readme(path: str) -> bool:
    return posixpath.basename(path).lower().startswith("readme")
