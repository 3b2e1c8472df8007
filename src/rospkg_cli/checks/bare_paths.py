"""Values of YAML and launch files that name a file without its suffix, or a folder, and none is there."""

from __future__ import annotations

import posixpath

from ..files import PackageFiles
from ..package.file_role import role_of
from ..package.package_facts import PackageFacts
from .home_path_texts import MARKUP, YAML


def names_nothing(path: str, below: str, files: PackageFiles, own: PackageFacts, into: PackageFacts | None) -> bool:
    """Return whether what a file names has no suffix, and no file or folder of the package is called exactly so.

    What reads it puts a suffix behind it, as slam_toolbox does for its maps, or writes there: a path in the share
    directory helps neither.
    """
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
