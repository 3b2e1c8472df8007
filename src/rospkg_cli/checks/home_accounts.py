"""Accounts that many have, or that everybody gets with the container of a repository: their homes are nobody's own."""

from __future__ import annotations

import posixpath

from ..files import PackageFiles
from ..lazy_regex import regex
from .setup.linked_build import build_files

OF_MANY = frozenset(
    "admin app dev developer docker jetson nvidia pi robot root ros ros2 runner ubuntu user username vscode you".split()
)
"""Accounts that robots, containers and examples have: the path may be the same for everyone."""
SHARED = regex(r"your|docker|container|(?:^|_)(?:ws|workspace)$")
SHORTEST = 4
OF_CONTAINER = regex(r"(?i)dockerfile|compose.*\.ya?ml$|(?:^|/)devcontainer\.json$")


def is_of_many(user: str) -> bool:
    """Return whether many have an account of that name; a workspace right below /home is that of a container."""
    lower = user.lower()
    return lower in OF_MANY or SHARED.search(lower) is not None or lower.startswith(("user", "my_", "<"))


def is_of_container(files: PackageFiles, user: str) -> bool:
    """Return whether a Dockerfile or what composes containers, in the package or above it, names an account."""
    if not user.isascii() or len(user) < SHORTEST:
        return False
    own = ((files, path) for path in files.paths)
    places = (each for each in (*own, *build_files(files)) if OF_CONTAINER.search(posixpath.basename(each[1])))
    return any(each.holds(path, user.encode()) for each, path in places)
