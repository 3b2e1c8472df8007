"""Read the CMake of a package given as texts."""

from __future__ import annotations

from rospkg_cli.example import manifest
from rospkg_cli.files import PackageFiles
from rospkg_cli.languages.cmake.evaluated_command import EvaluatedCommand
from rospkg_cli.package.cmake.cmake_install_table import cmake_table
from rospkg_cli.package.cmake.cmake_project import CMake
from rospkg_cli.package.package import Package
from rospkg_cli.tree import MemoryTree


def read(text: str, **files: str) -> CMake:
    """Return the model of a CMakeLists.txt; other files by their paths, with `__` for `/` and `_DOT_` for `.`."""
    others = {path.replace("__", "/").replace("_DOT_", "."): content for path, content in files.items()}
    return read_files({"CMakeLists.txt": text, **others})


def read_files(files: dict[str, str]) -> CMake:
    package = Package(PackageFiles(MemoryTree.of({"package.xml": manifest(build_type="ament_cmake"), **files})))
    (found,) = package.parts(CMake).good
    return found


def shown(calls: list[EvaluatedCommand]) -> list[str]:
    """Return the arguments of calls; `?` marks what is there only perhaps, `T` what is there only for tests."""
    return [
        " ".join(
            [
                *(("T",) if call.testing else ()),
                *(("?",) if call.maybe else ()),
                *(word.text.replace("\0", "∅").replace("\1", "~") + ("?" if word.maybe else "") for word in call.words),
            ]
        )
        for call in calls
    ]


def table(files: dict[str, str], name: str = "my_pkg") -> dict[str, str]:
    """Return the install table: destination to source."""
    return {row.destination: row.source for row in cmake_table(read_files(files), name).rows}


def unknown(files: dict[str, str]) -> set[str]:
    return {each.what for each in cmake_table(read_files(files), "my_pkg").unknown}
