"""Values of YAML and launch files that name no file or folder of the repository: one without its suffix, an output."""

from __future__ import annotations

import posixpath

from ...files import PackageFiles
from ...package.file_role import role_of
from ...package.package_facts import PackageFacts
from .home_path_texts import MARKUP, YAML


def names_nothing(path: str, below: str, files: PackageFiles, own: PackageFacts, into: PackageFacts | None) -> bool:
    """Return whether what a file names has no suffix, and no file or folder of the package is called exactly so.

    What reads it puts a suffix behind it, as slam_toolbox does for its maps, or writes there: a path in the share
    directory helps neither. A value of YAML is one as well where the repository has no file of that name in a folder
    of that name: a node writes it, or people set one of their own.
    """
    if path.endswith(YAML) and role_of(path) != "launch" and into is not None and not is_in_repository(below, files):
        return True
    is_value = path.endswith((*YAML, *MARKUP)) or role_of(path) == "launch"
    if not is_value or into is None or "." in posixpath.basename(below.rstrip("/")):
        return False
    rest = posixpath.normpath(below) if below else ""
    if not rest or any(f"{each}/".startswith(f"{rest}/") for each in into.share_files):
        return False
    if into.name == own.name:
        return not files.is_there(rest)
    whole = files.whole
    return whole is not None and not whole.sub(posixpath.join(into.folder, rest)).files()


def is_in_repository(below: str, files: PackageFiles) -> bool:
    """Return whether a file or folder of the run ends as a path does, with its last folder and its name."""
    tail = "/".join(posixpath.normpath(below).split("/")[-2:])
    whole = files.whole if files.whole is not None else files.tree
    return any(f"/{tail}/" in f"/{each}/" for each in whole.files())
