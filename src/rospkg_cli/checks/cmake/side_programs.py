"""Programs for tests and demonstrations, next to others of their package, that need not be installed."""

from __future__ import annotations

import re

from ...languages.cmake.targets import Target
from ...lazy_regex import regex
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.target_folders import folders_of
from ...package.workspace import Workspace
from ..repository.pages_and_scripts import pages_and_scripts
from .node_programs import NodePrograms

SIDE = frozenset(
    "test tests tester testing demo demos example examples sample samples bench benchmark debug tool tools".split()
)
WORDS = regex(r"[A-Z]?[a-z]+")


def is_side_program(programs: NodePrograms, target: Target, workspace: Workspace) -> bool:
    """Return whether a program is for tests or demonstrations, or a tool, and no launch file or page starts it.

    Another program of the package has to be installed: where none is, they were all forgotten.
    """
    package, name = programs.package, target.name
    is_side = target.is_executable and name not in programs.started and (has_side_name(name) or is_in_tools(target))
    if not is_side or not has_installed(package, name):
        return False
    is_launched = bool(workspace.having("started_nodes", package.facts.name, target.name))
    run = re.compile(rf"\bros2[ \t]+run[ \t]+{re.escape(package.facts.name)}[ \t]+{re.escape(target.name)}(?![\w-])")
    return not is_launched and not any(map(run.search, pages_and_scripts(package.cmake.package_files)))


def is_in_tools(target: Target) -> bool:
    """Return whether all sources of a program lie in folders of tools."""
    folders = folders_of(target)
    return bool(folders) and all(not SIDE.isdisjoint(folder.split("/")) for folder in folders)


def has_side_name(name: str) -> bool:
    return any(word.lower() in SIDE for word in WORDS.findall(name))


def has_installed(package: CMakePackage, name: str) -> bool:
    """Return whether a rule installs another program."""
    words = (word for rule in package.cmake.installs if rule.kind == "TARGETS" for word in rule.items)
    targets = (package.cmake.target(word.text) for word in words if word.text != name)
    return any(target is not None and target.is_executable for target in targets)
