"""Files of tests that `colcon test` never runs: CMake registers them nowhere, or pytest looks for other names."""

from __future__ import annotations

import posixpath

from ...files import PackageFiles
from ...languages.cmake.evaluated_command import path_in_package
from ...lazy_regex import regex
from ...package.cmake.cmake_project import CMake

LAUNCH_TEST, PYTEST = "def generate_test_description", "launch_pytest"
SOUGHT = regex(r"test_.*\.py|.*_test\.py")
"""What pytest looks for (`python_files`)."""
COPYING = frozenset({"install", "ament_auto_package"})
"""Commands that name files and folders and run none of them."""


def is_never_run(path: str, files: PackageFiles, cmake: CMake | None, build_type: str) -> bool:
    """Return whether a file would be a test of its own, and nothing runs it."""
    name, text = posixpath.basename(path), files.readable_text(path)
    is_launched = LAUNCH_TEST in text or PYTEST in text
    if build_type == "ament_python":
        asked = (files.readable_text(each) for each in ("setup.cfg", "pytest.ini", "pyproject.toml", "tox.ini"))
        return is_launched and not SOUGHT.fullmatch(name) and not any("python_files" in each for each in asked)
    return bool(is_launched or SOUGHT.fullmatch(name)) and is_unregistered(path, cmake)


def is_unregistered(path: str, cmake: CMake | None) -> bool:
    """Return whether no command of CMake names a file of tests or its folder, but for those that install it."""
    name = posixpath.basename(path)
    if cmake is None or not cmake.is_complete or cmake.reads_unknown_files:
        return False
    calls = [each for each in cmake.calls if each.name not in COPYING]
    testing = [each for each in calls if "test" in each.name]
    if any(name in text for each in calls for text in each.texts) or any(
        not w.is_known for e in testing for w in e.words
    ):
        return False
    folders = {path_in_package(word.text, each.folder) for each in testing for word in each.words}
    return not any(folder is not None and path.startswith(f"{folder}/".lstrip("/")) for folder in folders)
