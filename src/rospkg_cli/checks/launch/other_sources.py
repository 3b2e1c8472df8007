"""Whether a well-known package may be another one of this name: from a listed repository, or a clone."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...files import PackageFiles
from ...lazy_regex import regex
from ...package.missing_repositories import is_called
from ...package.workspace import Workspace
from ...ros.core_packages import core_packages
from ..repository.container_files import OF_CONTAINER, OF_WORKFLOW, files_called
from ..repository.pages_and_scripts import pages_and_scripts

CLONES = regex(r"\bgit[ \t]+clone\b[^\n]*?[/:]([\w.-]+?)(?:\.git)?/?(?=[\s'\"`)]|$)", re.MULTILINE)
FETCHES = regex(r"\b(?:vcs[ \t]+import|wstool[ \t]+(?:init|merge|update|up)|rosinstall[ \t]+\S)")
"""What checks out all that a list names."""
DISTRIBUTION = r"\bros-[\w${{}}<>]+-{0}(?![\w-])"


def may_be_another(package: str, workspace: Workspace, files: PackageFiles) -> str:
    """Return why a package that is not here may be another one than the released one; "" where nothing says so.

    It is the known one where it is a core package, which is not rebuilt, or where a page, a script or a container
    installs it by apt.
    """
    if package in core_packages():
        return ""
    texts = every_text(files)
    if any(re.search(DISTRIBUTION.format(re.escape(package.replace("_", "-"))), text) for text in texts):
        return ""
    if not workspace.is_complete or any(map(FETCHES.search, texts)):
        return "unless a listed repository that is not here has another package of this name"
    clones = {name for text in texts for name in CLONES.findall(text)}
    return "unless it is another one, which a page has cloned" if is_called(clones, package) else ""


def every_text(files: PackageFiles) -> list[str]:
    return [*pages_and_scripts(files), *in_containers(files)]


def in_containers(files: PackageFiles) -> Iterator[str]:
    for owner, path in files_called(files, OF_CONTAINER, OF_WORKFLOW):
        yield owner.readable_text(path)
