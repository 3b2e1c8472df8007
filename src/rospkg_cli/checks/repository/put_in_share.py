"""Folders that a script, a container or a page puts into the share directory of a package without its build."""

from __future__ import annotations

import re

from ...files import PackageFiles
from .container_files import OF_CONTAINER, OF_SCRIPT, OF_WORKFLOW, files_called

COPIES = (
    r"(?m)^(?!\s*#)(?:.*\b(?:cp|rsync|ln|mv|COPY|ADD|--?v(?:olume)?)\b[^\n]*(?<![\w-]){0}(?![\w-])[^\n]*"
    r"|\s*-\s*[\"']?[^\s:\"']*(?<![\w-]){0}/?:[^\s:\"']*)/share/{1}(?![\w-])"
)
"""A command that copies, or a volume: the folder, and behind it the share directory of the package."""


def is_put_in_share(files: PackageFiles, package: str, folder: str) -> bool:
    """Return whether a text copies, links or mounts a folder of a package into its share directory."""
    copies = re.compile(COPIES.format(re.escape(folder), re.escape(package)))
    called = files_called(files, OF_CONTAINER, OF_SCRIPT, OF_WORKFLOW)
    return any(copies.search(whole.readable_text(path)) for whole, path in called)
