"""Folders that the containers of a repository have: who works in one finds a path below them on every machine."""

from __future__ import annotations

from ...files import PackageFiles
from ...lazy_regex import regex
from .container_files import OF_CONTAINER, OF_SCRIPT, files_called
from .home_accounts import is_of_container, is_of_many

ACCOUNT = regex(r"(?:file://)?/(?:home|Users)/([^/]+)/")
OF_ROOT = regex(r"(?:file://)?/root/")
ROOTS = regex(r"(?m)^(?![ \t]*#)[^\n]*?(?<![\w./$}~-])/root(?=[/\s\"':,;\]]|$)")
USERS = regex(r"(?m)^[ \t]*USER[ \t]+(\S+)")
COMMENT = regex(r"(?m)^[ \t]*#.*$")
SOURCE = r"(?:\$\([^)\n]*\)|\$\{[^}\n]*\}|\$(?![({])|[^\s:\"'$])+"
MOUNT = regex(
    rf"(?m)(?:(?:-v|--volume)[ \t=]+[\"']?|^[ \t]*-[ \t]+[\"']?){SOURCE}[\"']?:(/[^\s:\"',]+)"
    r"|\b(?:target|dst|destination)[\"']?[ \t]*[=:][ \t]*[\"']?(/[^\s,\"']+)"
)
"""Where a command, a compose file or an editor mounts a folder in a container."""
SHORTEST = 2
"""The folders of a mounted path at least: all systems have `/root`, `/home` and `/tmp`."""


def is_of_containers(files: PackageFiles, path: str) -> bool:
    """Return whether a path lies below the home of an account that many have or that containers of the repository have,
    or below a folder that is mounted there.
    """
    if (account := ACCOUNT.match(path)) is not None and (is_of_many(account[1]) or is_of_container(files, account[1])):
        return True
    bare = path.removeprefix("file://")
    is_root = OF_ROOT.match(path) is not None and works_as_root(files)
    return is_root or any(bare.startswith(f"{each.rstrip('/')}/") for each in mounts(files))


def works_as_root(files: PackageFiles) -> bool:
    """Return whether what makes a container puts files into the home of root, and does not end as another account."""
    for each, path in files_called(files, OF_CONTAINER):
        text = each.readable_text(path)
        if ROOTS.search(text) and (USERS.findall(text) or ["root"])[-1] in ("root", "0"):
            return True
    return False


def mounts(files: PackageFiles) -> set[str]:
    """Return the folders of containers that something of the repository mounts others at; of `/root` what is in it."""
    found = set[str]()
    for each, path in files_called(files, OF_CONTAINER, OF_SCRIPT):
        if any(each.holds(path, word) for word in (b"-v", b"volume", b"mount")):
            bare = COMMENT.sub("", each.readable_text(path))
            found.update(first or second for first, second in MOUNT.findall(bare))
    return {each for each in found if len(each.strip("/").split("/")) >= SHORTEST}
