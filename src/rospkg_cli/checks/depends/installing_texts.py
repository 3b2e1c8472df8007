"""The texts of a repository that may install Python libraries: requirements, containers, jobs, scripts, pages."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Callable, Iterator

from ...files import PackageFiles
from ...lazy_regex import regex
from ...tree import READABLE
from ..repository.container_files import BARE, OF_CONTAINER, SHELL, files_called
from .shell_variables import with_values

REQUIREMENTS = regex(
    r"(?:.*/)?(?:(?:[^/]*requirements[^/]*|(?:[^/]*[-_.])?(?:reqs?|requirement)(?:[-_.][^/]*)?)\.(?:txt|in|pip)"
    r"|requirements/[^/]+\.(?:txt|in))"
)

PROJECTS = regex(r"(?:.*/)?(?:[^/]*(?:environment|conda)[^/]*\.ya?ml|Pipfile|pixi\.toml|pyproject\.toml)")
"""What conda, pipenv, pixi, poetry and uv install."""

TYPED = regex(r"(?:.*/)?(?:README[^/]*|[^/]*\.(?:md|rst|sh|bash)|[Mm]akefile|justfile)")
"""Files with commands that are run, or that people type."""

JOBS = regex(
    r"(?:.*/)?(?:(?:\.github/workflows/[^/]+|\.gitlab-ci|[^/]*azure-pipelines[^/]*|\.circleci/config|\.travis"
    r"|[Tt]askfile)\.ya?ml|Jenkinsfile|Vagrantfile|Earthfile)"
)

SUBFOLDERS = (
    "",
    ".circleci",
    ".github/workflows",
    "conda",
    "doc",
    "docker",
    "docs",
    "env",
    "envs",
    "requirements",
    "scripts",
)
"""Subfolders of the folders above a package whose files may say what to install."""

LISTED = regex(r"^[ \t]*([A-Za-z][\w.-]*)", re.MULTILINE)

NEEDED = regex(
    r"(?m)^[ \t]*(?:-[ \t]*)?[\"']?([A-Za-z][\w.-]*)|\[[ \t]*[\"']([A-Za-z][\w.-]*)|,[ \t]*[\"']([A-Za-z][\w.-]*)"
)
"""An entry of a list or a table, on a line of its own or between brackets."""

INSTALLS = regex(r"\b(?:pip3?\s+install|(?:uv|poetry|pdm|pixi)\s+add|pipenv\s+install)\b((?:[^\n&|;\\]|\\\n)*)")

WORD = regex(r"(?<![\w./:-])[A-Za-z][\w.-]*")


def installing_texts(files: PackageFiles) -> Iterator[tuple[str, str]]:
    """Yield the requirements, pages and scripts of the package and of the folders above it, with their paths.

    All files by which containers are built are among them.
    """
    yield from texts_called(files, is_read)
    for owner, path in files_called(files, OF_CONTAINER):
        yield path, owner.readable_text(path)
    bare = texts_called(files, lambda path: BARE.search(path) is not None)
    yield from ((path, text) for path, text in bare if SHELL.match(text))


def texts_called(files: PackageFiles, is_wanted: Callable[[str], bool]) -> Iterator[tuple[str, str]]:
    """Yield the files of the package and of the folders above it whose path is wanted, with their texts."""
    yield from ((path, files.readable_text(path)) for path in files.paths if is_wanted(path))
    parts = files.folder.split("/") if files.folder and files.whole is not None else []
    whole = PackageFiles(files.whole) if files.whole is not None else files
    above = {"/".join(parts[:depth]) for depth in range(len(parts))}
    folders = {posixpath.join(each, name).rstrip("/") for each in above for name in SUBFOLDERS}
    for path, kind in whole.tree.files().items():
        if kind in READABLE and posixpath.dirname(path) in folders and is_wanted(path):
            yield path, whole.readable_text(path)


def is_read(path: str) -> bool:
    return any(names.fullmatch(path) for names in (REQUIREMENTS, PROJECTS, TYPED))


def is_job(path: str) -> bool:
    return JOBS.fullmatch(path) is not None


def names_in(path: str, text: str) -> Iterator[str]:
    """Yield the names in a file of requirements, or after `pip install` in commands."""
    if REQUIREMENTS.fullmatch(path):
        yield from (match[1] for match in LISTED.finditer(text))
        return
    if PROJECTS.fullmatch(path):
        yield from (name for found in NEEDED.findall(text) for name in found if name)
    for command in INSTALLS.finditer(text):
        yield from (word[0] for word in WORD.finditer(with_values(command[1], text)))
