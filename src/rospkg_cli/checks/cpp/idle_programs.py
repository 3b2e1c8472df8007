"""Programs that nobody misses where they are not installed."""

from __future__ import annotations

import re

from ...files import PackageFiles
from ...languages.cmake.targets import Target
from ..cmake.commented_installs import CommentedInstalls
from ..cmake.node_programs import NodePrograms
from ..setup.linked_build import build_texts

REACH = 200
"""The most characters of the path before a program's name."""


def is_idle_program(programs: NodePrograms, target: Target) -> bool:
    """Return whether nothing starts a program as an installed one: a comment installs it, or it is no node.

    So is one that pages or scripts start where it is built.
    """
    if not target.is_executable:
        return False
    if not programs.is_run(target):
        return True
    is_elsewhere = CommentedInstalls(programs.package.cmake).has(target) or is_started_where_built(
        programs.package.cmake.package_files, target.name
    )
    return target.name not in programs.started and is_elsewhere


def is_started_where_built(files: PackageFiles, program: str) -> bool:
    """Return whether a page or a script of the repository says `./talker` or `build/my_pkg/talker`."""
    start = rf"(?<![\w./~-])(?:\./|[\w./~${{}}-]{{0,{REACH}}}\bbuild/(?:[\w.-]{{1,{REACH}}}/)?)"
    pattern = re.compile(rf"{start}{re.escape(program)}(?![\w./-])")
    return any(program in text and pattern.search(text) for text in build_texts(files))
