"""Programs for `ros2 run`: not those of tests, nor those that only a library uses."""

from __future__ import annotations

import re

from ...files import PackageFiles
from ...languages.cmake.targets import Target
from ...package.cmake.cmake_project import CMake
from ...package.cmake.needed_files import COMPILED
from ...package.cmake.target_folders import ASIDE, EXAMPLES, parts_of
from ...package.cmake.target_links import TargetLinks
from ...package.cmake.uninstalled_targets import UninstalledTargets
from ..repository.pages_and_scripts import pages_and_scripts

TESTS = ASIDE - EXAMPLES
"""Folders whose programs are not for `ros2 run`, though some packages install them."""


def has_run_programs(cmake: CMake, files: PackageFiles, package: str) -> bool:
    """Return whether a program may be started by its name: it is installed, or nothing is, and no test alone."""
    programs = [each for each in cmake.targets if each.is_executable and not each.call.testing]
    left = [each for each in programs if is_for_tests(each) or is_kept(cmake, each)]
    return len(left) < len(programs) or any(is_run(files, package, each) for each in left)


def is_for_tests(program: Target) -> bool:
    """Return whether a command for tests builds a program, or it is in a folder of tests."""
    return program.call.name in COMPILED or bool(parts_of(program) & TESTS)


def is_kept(cmake: CMake, program: Target) -> bool:
    """Return whether a program is not installed, where libraries are: they alone are for others."""
    rules = [rule for rule in cmake.installs if rule.kind in ("TARGETS", "CODE")]
    libraries = {each.name for each in cmake.targets if each.is_library}
    targets = UninstalledTargets(cmake)
    is_known = not any(map(targets.is_unclear, rules)) and not libraries.isdisjoint(TargetLinks(cmake).installed)
    return is_known and program.name in {each.name for each in targets.candidates()}


def is_run(files: PackageFiles, package: str, program: Target) -> bool:
    """Return whether a page or a script, here or above, runs a program with `ros2 run`."""
    started = re.compile(rf"\bros2[ \t]+run[ \t]+{re.escape(package)}[ \t]+{re.escape(program.name)}(?![.-]?\w)")
    return any(map(started.search, pages_and_scripts(files)))
