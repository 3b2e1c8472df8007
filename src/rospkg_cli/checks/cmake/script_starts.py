"""What uses a script of a CMake package: launch files and pages that start it, code and CMake files that load it."""

from __future__ import annotations

import posixpath
import re
from functools import cached_property

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.launch.live_text import live_text
from ...package.workspace import Workspace
from ...ros.share_layout import LAUNCH
from ..repository.pages_and_scripts import pages_and_scripts

IMPORTED = regex(r"^[ \t]*(?:from|import)[ \t]+\.?(\w+)", re.MULTILINE)
ENTRY = "def generate_launch_description("


@dataclass(frozen=True)
class ScriptStarts:
    name: str
    """Of the package."""
    files: PackageFiles
    workspace: Workspace
    texts: tuple[str, ...]
    """Of the installed scripts."""

    def is_wanted(self, path: str) -> bool:
        """Return whether a launch file of the workspace starts a script, or a README does so with `ros2 run`."""
        name = posixpath.basename(path)
        if self.workspace.having("started_nodes", self.name, name):
            return True
        started = re.compile(rf"\bros2 run {re.escape(self.name)} {re.escape(name)}(?![.-]?\w)")
        texts = (*self.texts, *(self.files.readable_text(each) for each in self.files.paths if is_readme(each)))
        named = re.compile(rf"(?<![\w.-]){re.escape(name)}(?!\w)")
        return any(map(named.search, self.live_launches)) or any(map(started.search, texts))

    def is_run(self, path: str) -> bool:
        """Return whether a page or a script, here or above, runs a script with `ros2 run`."""
        name = re.escape(posixpath.basename(path))
        started = re.compile(rf"\bros2[ \t]+run[ \t]+{re.escape(self.name)}[ \t]+{name}(?![.-]?\w)")
        return any(map(started.search, pages_and_scripts(self.files)))

    def is_loaded(self, path: str) -> bool:
        """Return whether a file need not be executable: it is imported, launched, or passed to Python."""
        name = posixpath.basename(path)
        if name.removesuffix(".py") in self.imported or ENTRY in self.files.readable_text(path):
            return True
        passed = re.compile(rf"(?<!executable='){re.escape(name)}'")  # that one is started as a program
        return any(passed.search(text) for text in self.launches_with_python) or self.is_run_by_cmake(name)

    def is_run_by_cmake(self, name: str) -> bool:
        """Return whether a CMake file other than a CMakeLists.txt names a script: a macro may pass it to Python."""
        macros = (path for path in self.files.paths if path.endswith((".cmake", ".cmake.in")))
        return any(f"/{name}" in self.files.readable_text(path) for path in macros)

    @cached_property
    def imported(self) -> frozenset[str]:
        """The modules that installed scripts import from their own folder, and all others that they import."""
        return frozenset(name for text in self.texts for name in IMPORTED.findall(text))

    @cached_property
    def launches_with_python(self) -> tuple[str, ...]:
        """The launch files that run Python, with single quotes."""
        texts = map(self.files.readable_text, self.launches)
        return tuple(text.replace('"', "'") for text in texts if "python3" in text)

    @cached_property
    def live_launches(self) -> tuple[str, ...]:
        """The launch files without their comments."""
        return tuple(live_text(self.files, path) for path in self.launches)

    @property
    def launches(self) -> tuple[str, ...]:
        """The paths of the launch files of the package."""
        return tuple(path for path in self.files.paths if LAUNCH.fullmatch(posixpath.basename(path)))


def is_readme(path: str) -> bool:
    return posixpath.basename(path).lower().startswith("readme")
