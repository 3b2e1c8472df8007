"""Programs that need not be installed: a comment has their rule, or pages start them where they are built."""

from __future__ import annotations

import re

from ...files import PackageFiles
from ...languages.cmake.targets import Target
from ..cmake.commented_installs import CommentedInstalls
from ..cmake.node_programs import NodePrograms
from ..repository.path_starts import texts_of

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
        programs.package.cmake.package_files, programs.package.facts.name, target.name
    )
    return target.name not in programs.started and is_elsewhere


def is_started_where_built(files: PackageFiles, package: str, program: str) -> bool:
    """Return whether a page or a script of the repository says `./talker`, `bin/talker` or `build/my_pkg/talker`.

    None has `ros2 run` look it up.
    """
    folders = rf"(?:[\w.-]{{1,{REACH}}}/){{0,3}}"
    start = rf"(?<![\w./~-])(?:\./{folders}|{folders}bin/|[\w./~${{}}-]{{0,{REACH}}}\bbuild/{folders})"
    pattern = re.compile(rf"(?!\S*\binstall/){start}{re.escape(program)}(?![\w./-])")
    run = re.compile(rf"\bros2[ \t]+run[ \t]+{re.escape(package)}[ \t]+{re.escape(program)}(?![\w-])")
    texts = [text for text in texts_of(files) if program in text]
    return any(map(pattern.search, texts)) and not any(map(run.search, texts))
