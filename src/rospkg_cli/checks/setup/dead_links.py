"""Links to nothing that a glob of setup.py matches: setuptools can't copy them, and the build stops."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from ...languages.python.evaluate.sandbox_filesystem import glob_matches
from ...languages.python.evaluate.scalar_values import GlobResult
from ...lazy_regex import regex
from .python_package import PythonPackage

FILTER = regex(r"\b(?:isfile|is_file|exists|islink)\b")


def dead_links(package: PythonPackage) -> Iterator[tuple[GlobResult, str]]:
    """Yield each glob with the links to nothing among what it matches, where setup.py does not filter files."""
    dead = [path for path, kind in package.files.tree.files().items() if kind == "other"]
    if not dead or FILTER.search(package.setup.source.text) or package.setup.may_write_files:
        return
    expected = package.files.absent.is_expected
    for glob in dict.fromkeys(package.setup.globs):
        folder, name = posixpath.split(glob.pattern)
        for path in dead if glob.is_certain else ():
            is_matched = posixpath.dirname(path) == folder and glob_matches(posixpath.basename(path), name)
            if is_matched and not expected(path):
                yield glob, path
