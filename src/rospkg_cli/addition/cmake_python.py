"""Python in a package that CMake builds: the modules, and the scripts that start them."""

from __future__ import annotations

from collections.abc import Iterator

from ..change.draft import Draft
from ..edits.cmake_commands import remove
from ..edits.cmake_install import LIBEXEC, install_script
from ..edits.cmake_python import FINDER, install_python_package
from ..edits.cmake_rule_place import block
from ..finding import Create, Delete
from ..light_dataclasses import dataclass
from ..package.package import Package
from .cmake_block import argument_removals, block_removals
from .cmake_find import cmake_of
from .part import Operations


@dataclass(frozen=True)
class InitFile:
    """The empty `__init__.py` of a folder of modules."""

    folder: str
    module: str

    def add(self, package: Package) -> Operations:
        """Return the file, nothing where it is there."""
        path = f"{self.folder}/__init__.py"
        return () if package.files.is_there(path) else (Create(path, ""),)

    def remove(self, package: Package) -> Iterator[Operations]:
        """Yield its deletion, nothing where it holds code, the folder has other files, or CMake still installs it."""
        calls = cmake_of(package).named("ament_python_install_package")
        if any(self.module in call.texts for call in calls):
            return
        path = f"{self.folder}/__init__.py"
        if package.files.below(self.folder) == (path,) and not package.files.readable_text(path):
            yield (Delete(path),)


@dataclass(frozen=True)
class InstalledPythonPackage:
    """`ament_python_install_package`, with what defines it."""

    module: str

    def add(self, package: Package) -> Operations:
        """Return the edits, nothing where the package is installed already."""
        cmake = cmake_of(package)
        calls = cmake.named("ament_python_install_package")
        if any(call.words and call.words[0].text == self.module for call in calls):
            return ()
        return install_python_package(cmake, self.module)

    def remove(self, package: Package) -> Iterator[Operations]:
        """Yield the removal where `add` would bring it back to the byte: any other call was there before the node.

        Nothing where the folder still has modules, or the build makes some.
        """
        cmake = cmake_of(package)
        if any("PYTHON_INSTALL_DIR" in file.source.text or "pybind11" in file.source.text for file in cmake.files):
            return
        modules = [path for path in package.files.below(self.module) if not path.endswith("__init__.py")]
        if modules:
            return
        shown = "${PROJECT_NAME}" if self.module == cmake.project_name else self.module
        finders = [each for each in cmake.root.top if [a.text for a in each.arguments] == [FINDER, "REQUIRED"]]
        finding = tuple(remove(cmake.root, each) for each in finders[-1:])
        for found in block_removals(cmake.root, f"ament_python_install_package({shown})"):
            yield from (way for way in ((*finding, *found), found) if self.comes_back(package, way))

    def comes_back(self, package: Package, way: Operations) -> bool:
        """Return whether the same file is there after a removal and an addition."""
        draft = Draft(package.files.tree)
        try:
            draft.apply("", way)
        except ValueError:  # two of the edits overlap: this way is none
            return False
        draft.apply("", self.add(draft.package("")))
        return not draft.changes


@dataclass(frozen=True)
class InstalledProgram:
    """A script among the programs that go to where `ros2 run` looks."""

    path: str

    def add(self, package: Package) -> Operations:
        """Return the edit, nothing where it is installed already."""
        cmake = cmake_of(package)
        if any(word.text == self.path for rule in cmake.installs for word in rule.items):
            return ()
        return (install_script(cmake, self.path),)

    def remove(self, package: Package) -> Iterator[Operations]:
        """Yield the removal of the rule where it installs nothing else, else of the path in it."""
        cmake = cmake_of(package)
        for rule in cmake.installs:
            mine = [word for word in rule.items if word.text == self.path]
            file = cmake.file(rule.call.path)
            if mine and file.is_top(rule.call.command):
                if len(rule.items) > 1:
                    yield from argument_removals(file, mine[0].span)
                else:
                    yield from block_removals(file, block(file, "PROGRAMS", self.path, LIBEXEC))
                    yield (remove(file, rule.call.command),)
