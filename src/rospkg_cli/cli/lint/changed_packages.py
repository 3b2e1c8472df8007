"""The packages in which something has changed, as git sees it."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Iterable, Sequence
from pathlib import Path

from ...disk_trace import exists
from ...user_error import UserError

QUIET = ("--no-optional-locks", "-c", "core.fsmonitor=false", "-c", "core.quotePath=false")
"""Options of git that keep it from writing to the repository, and from running what its config names as a monitor."""


class GitError(UserError):
    """What git can't tell; the message says why."""


def changed_packages(packages: Iterable[Path], since: str = "") -> set[Path]:
    """Return the packages that hold a file which differs from the last commit, or which git does not know yet.

    With `since`, from where the branch left that commit, tag or branch. Raises GitError.
    """
    of_repository: dict[Path, list[Path]] = {}
    for package in packages:
        of_repository.setdefault(repository_of(package), []).append(package)
    found = set()
    for repository, inside in of_repository.items():
        changed = changed_files(repository, since)
        found |= {package for package in inside if any(path.is_relative_to(package) for path in changed)}
    return found


def repository_of(package: Path) -> Path:
    """Return the nearest folder around a package that is a repository or a submodule; raises GitError."""
    for folder in (package, *package.parents):
        if exists(folder / ".git"):
            return folder
    raise GitError(
        f"`{package}` lies in no git repository, so what has changed is unknown; leave --changed, --since out"
    )


def changed_files(repository: Path, since: str) -> list[Path]:
    """Return the files of a repository that differ, those that are gone or new too; raises GitError."""
    start = git(repository, "merge-base", "--", since, "HEAD").strip() if since else "HEAD"
    has_commit = bool(since) or is_known(repository, "HEAD")
    names = ["-z", "--name-only", "--no-renames", "--no-ext-diff", "--no-textconv", "--ignore-submodules=none"]
    known = git(repository, "diff", *names, start, "--") if has_commit else git(repository, "ls-files", "-z")
    new = git(repository, "ls-files", "-z", "--others", "--exclude-standard")
    return [repository / name for name in (known + new).split("\0") if name]


def is_known(repository: Path, name: str) -> bool:
    return run(repository, ["rev-parse", "--verify", "--quiet", name]).returncode == 0


def git(repository: Path, *arguments: str) -> str:
    """Return what git prints; raises GitError."""
    done = run(repository, arguments)
    if done.returncode:
        said = os.fsdecode(done.stderr).strip().partition("\n")[0] or f"exit status {done.returncode}"
        raise GitError(f"git can't say what has changed in `{repository}`: {said}")
    return os.fsdecode(done.stdout)


def run(repository: Path, arguments: Sequence[str]) -> subprocess.CompletedProcess[bytes]:
    try:
        return subprocess.run(["git", *QUIET, *arguments], cwd=repository, capture_output=True, check=False)
    except OSError as error:
        raise GitError(f"git can't be started: {error.strerror or error}; --changed and --since need it") from error
