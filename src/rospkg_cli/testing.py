"""For tests: of a package (`from rospkg_cli.testing import test_package` in one of its test files), and of rules."""

from __future__ import annotations

import io
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from .cli.lint.lint_options import LintOptions, ReportOptions
from .cli.lint.run import lint_to
from .engine.discovery.cmake_projects import cmake_projects_in
from .engine.discovery.discover import packages_in, repositories_in
from .engine.run.results import Results
from .engine.run.scope import Scope
from .engine.run.session import Session
from .engine.selection import EVERYTHING
from .ros.distros import Targets
from .tree import MemoryTree, TreeEntry

if TYPE_CHECKING:
    import pytest


def lint_files(
    files: Mapping[str, str | bytes | TreeEntry], codes: Iterable[str] | None = None, targets: tuple[str, ...] = ()
) -> Results:
    """Lint a tree given as path → text with the named rules, or with all of them, pedantic and release included.

    A text that begins with `#!` is an executable file.  A package in the root is called `my_pkg`.
    """
    tree = MemoryTree.of(files)
    folders = packages_in(tree)
    chosen = EVERYTHING.codes() if codes is None else frozenset(codes)
    repositories, projects = repositories_in(tree), cmake_projects_in(tree, folders)
    scope = Scope(tuple(folders), frozenset(folders), "my_pkg", repositories=repositories, cmake_projects=projects)
    session = Session(tree, scope, chosen, Targets(targets))
    return session.run() if folders else session.no_packages(["."])


def test_package(request: pytest.FixtureRequest) -> None:
    """Lint the package that the importing test file lies in; the test fails where `rospkg lint` fails."""
    report = lint_package(Path(request.path))
    assert not report, f"\n\n{report}"


def lint_package(inside: Path) -> str:
    """Return the report of `rospkg lint` on the package around a path; "" where the exit status is 0."""
    stream = io.StringIO()
    status = lint_to(LintOptions(paths=(inside,), report=ReportOptions(color="never")), stream)
    return stream.getvalue() if status else ""
