"""Texts of a repository that put a folder of a package on PYTHONPATH, where Python finds what lies in it."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator

from ...files import PackageFiles
from ...lazy_regex import regex
from ...package.file_role import role_of
from .container_files import OF_CONTAINER, OF_SCRIPT, OF_WORKFLOW, files_called

ON_PATH = "; a text here puts that folder on PYTHONPATH, and with it there it is found"
SETS = regex(r"(?m)^.*PYTHONPATH.*$")
OF_ENVIRONMENT = regex(r"(?:^|/)[^/]*(?:\.env|\.envrc|\.dsv(?:\.in)?|\.sh\.in|bashrc)$")


def is_on_python_path(files: PackageFiles, path: str) -> bool:
    """Return whether a page, a script, a container or a launch file has Python look for modules in a file's folder.

    Of a launch file of the package any such line does: what its substitutions end in is known when it runs.
    """
    return has_on_python_path(files, posixpath.dirname(path))


def has_on_python_path(files: PackageFiles, folder: str) -> bool:
    """Return whether one has Python look in a folder of the package; "" is the package's own folder."""
    name = posixpath.basename(folder) or posixpath.basename(files.folder)
    ends = re.compile(rf"/{re.escape(name)}/?(?![\w./-])")
    launched = (each for each in files.paths if role_of(each) == "launch")
    if any(SETS.search(files.readable_text(each)) for each in launched):
        return True
    return bool(name) and any(ends.search(line) for line in lines(files))


def lines(files: PackageFiles) -> Iterator[str]:
    for whole, path in files_called(files, OF_CONTAINER, OF_SCRIPT, OF_WORKFLOW, OF_ENVIRONMENT):
        yield from (found.group() for found in SETS.finditer(whole.readable_text(path)))
