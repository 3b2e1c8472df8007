"""Which package of the workspace a path in a home folder leads into."""

from __future__ import annotations

import posixpath

from ...files import PackageFiles
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace


def target_package(
    named: str, files: PackageFiles, facts: PackageFacts, workspace: Workspace
) -> tuple[str | None, str]:
    """Return the package that a path leads into, and the rest of the path; None and the path where none is known.

    `files` and `facts` are those of the package whose file names the path.
    """
    folders = named.rstrip("/").split("/")[3:]
    into = [
        (name, "/".join(folders[start:]).removeprefix(f"share/{name}/"))
        for start in range(len(folders) - 1, 0, -1)
        if workspace.named(name := folders[start - 1]) is not None
    ]
    if into:  # the Python module of a package has the same name
        return next((each for each in into if has(*each, files, facts, workspace)), into[0])
    for start in range(len(folders) - 1):
        rest = "/".join(folders[start:])
        if files.is_there(posixpath.normpath(rest)):
            return facts.name, rest
    return None, named


def has(package: str, below: str, files: PackageFiles, own: PackageFacts, workspace: Workspace) -> bool:
    """Return whether a package has a file or folder: the package itself in its sources, another one installed."""
    facts = workspace.named(package)
    if facts is None or package == own.name:
        return files.is_there(posixpath.normpath(below))
    return is_installed(below, facts)


def is_installed(below: str, facts: PackageFacts) -> bool:
    """Return whether a path in the share directory of a package is that of a file, or of a folder that holds some."""
    return any(f"{each}/".startswith(f"{below}/") for each in facts.share_files)
