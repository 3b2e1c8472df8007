"""Whether anything starts or loads the node, component or plugin of a source, and whether another file has it."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...package.launch.text import uncommented
from ...package.workspace import Workspace

PAGES = (".md", ".rst", ".sh", ".txt")
"""Files that say, or do, what is to be started."""
LOADING = (".xml", ".yaml", ".yml", ".py", ".urdf", ".xacro")
"""Files that name classes to be loaded."""
OFFERS = "<class"
"""What stands in a description of plugins, which offers classes and loads none."""


@dataclass(frozen=True)
class WantedNodes:
    package: CMakePackage
    workspace: Workspace

    def is_node_wanted(self, name: str) -> bool:
        """Return whether a launch file starts a program, or a page does so with `ros2 run`."""
        package = self.package.facts.name
        started = re.compile(rf"\bros2[ \t]+run[ \t]+{re.escape(package)}[ \t]+{re.escape(name)}(?![\w.-])")
        is_started = bool(self.workspace.having("started_nodes", package, name))
        return is_started or any(started.search(text) for _, text in self.named_texts(PAGES))

    def is_class_wanted(self, name: str) -> bool:
        """Return whether a launch file loads a class, or a text names it."""
        package = self.package.facts.name
        is_loaded = any((package, name) in facts.loaded_components for facts in self.workspace.packages)
        named = re.compile(rf"(?<![\w:]){re.escape(name)}(?![\w:])")
        texts = ((path, text) for path, text in self.named_texts(LOADING) if name in text and OFFERS not in text)
        return is_loaded or any(
            self.is_installed(path) and named.search(uncommented(path, text)) for path, text in texts
        )

    def existing_program(self, name: str) -> str:
        """Return the program of a node's name that is made of other files, for `ros2 run`; "" where there is none."""
        target = self.package.cmake.target(name)
        if target is not None and target.is_executable and target.is_built:
            return f"the target `{name}`"
        return f"the program `{name}`" if name in self.package.facts.executables else ""

    def is_installed(self, path: str) -> bool:
        """Return whether CMake names a description, to install or export it: else nothing finds the class by it."""
        file = path.rpartition("/")[2]
        return not path.endswith(".xml") or any(file in each.source.text for each in self.package.cmake.files)

    def named_texts(self, suffixes: tuple[str, ...]) -> Iterator[tuple[str, str]]:
        """Yield the files with one of some endings, each with its text."""
        files = self.package.cmake.package_files
        return ((path, files.readable_text(path)) for path in files.paths if path.endswith(suffixes))
