"""The files of a repository that make containers, or that put several together, and others by their names."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...files import PackageFiles
from ...lazy_regex import regex
from ...tree import READABLE

OF_CONTAINER = regex(
    r"(?i)(?:^|/)(?:[^/]*(?:dockerfile|containerfile)[^/]*|[^/]*compose[^/]*\.ya?ml|devcontainer\.json)$"
)
OF_WORKFLOW = regex(r"(?:^|/)(?:\.github/workflows/[^/]+\.ya?ml|\.gitlab-ci\.yml)$")
BARE = regex(r"(?:^|/)[^./]+$")
SHELL = regex(r"#![^\n]*\b(?:ba|da|k|z)?sh\b")
"""The name of a file without a suffix, and its first line where it is a script of a shell: `scripts/install`."""
OF_SCRIPT = regex(r"(?i)\.(?:sh|bash|md|rst|ya?ml)$|(?:^|/)(?:makefile|justfile)$")


def files_called(files: PackageFiles, *names: re.Pattern[str]) -> Iterator[tuple[PackageFiles, str]]:
    """Yield the files of the repository, in the package or elsewhere in the run, whose path fits one of the names."""
    whole = PackageFiles(files.whole) if files.whole is not None else files
    for path, kind in whole.tree.files().items():
        if kind in READABLE and any(name.search(path) for name in names):
            yield whole, path


def is_shell_script(files: PackageFiles, path: str) -> bool:
    """Return whether a file without a suffix is a script of a shell, as its first line says."""
    return BARE.search(path) is not None and files.holds(path, b"#!") and bool(SHELL.match(files.readable_text(path)))
