"""Which Python libraries a repository has pip install: by its requirements, its Dockerfiles, scripts and pages."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Callable, Iterator
from functools import cached_property, lru_cache

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...ros.aliases import key_for_pip
from ...ros.names import Names
from ...tree import READABLE
from ..repository.container_files import BARE, OF_CONTAINER, SHELL, files_called
from .locked_names import locked_names, may_lock
from .own_requirements import own_requirements
from .pip_requirements import distributions_of, required_by
from .shell_variables import with_values

REQUIREMENTS = regex(
    r"(?:.*/)?(?:(?:[^/]*requirements[^/]*|(?:[^/]*[-_.])?(?:reqs?|requirement)(?:[-_.][^/]*)?)\.(?:txt|in|pip)"
    r"|requirements/[^/]+\.(?:txt|in))"
)
PROJECTS = regex(r"(?:.*/)?(?:[^/]*(?:environment|conda)[^/]*\.ya?ml|Pipfile|pixi\.toml|pyproject\.toml)")
"""What conda, pipenv, pixi, poetry and uv install."""
TYPED = regex(r"(?:.*/)?(?:README[^/]*|[^/]*\.(?:md|rst|sh|bash)|[Mm]akefile|justfile)")
"""Files with commands: some run them, and people type those of the others."""
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
"""The folders, in one above a package, whose files say what is to be installed."""
LISTED = regex(r"^[ \t]*([A-Za-z][\w.-]*)", re.MULTILINE)
NEEDED = regex(
    r"(?m)^[ \t]*(?:-[ \t]*)?[\"']?([A-Za-z][\w.-]*)|\[[ \t]*[\"']([A-Za-z][\w.-]*)|,[ \t]*[\"']([A-Za-z][\w.-]*)"
)
"""An entry of a list or a table, on a line of its own or between brackets."""
INSTALLS = regex(r"\b(?:pip3?\s+install|(?:uv|poetry|pdm|pixi)\s+add|pipenv\s+install)\b((?:[^\n&|;\\]|\\\n)*)")
WORD = regex(r"(?<![\w./:-])[A-Za-z][\w.-]*")


@dataclass(frozen=True)
class PipInstalls:
    files: PackageFiles

    def has(self, module: str, key: str, index: Names) -> bool:
        """Return whether pip installs the distribution of a module, under its own name or one that rosdep knows."""
        wanted = {normalized(module.partition(".")[0]), *distributions_of(key)}
        return not wanted.isdisjoint(self.names) or any(key_of(name, index) == key for name in self.written)

    def bringer(self, module: str, key: str, index: Names) -> str:
        """Return the library that pip installs and that requires the distribution of a module; "" for none."""
        wanted = normalized(module.partition(".")[0])
        found = (by for name, by in self.required.items() if name == wanted or key_of(name, index) == key)
        return next(found, "")

    @cached_property
    def names(self) -> frozenset[str]:
        return frozenset(map(normalized, self.written))

    @cached_property
    def required(self) -> dict[str, str]:
        """What these require, each with the one that does."""
        return required_by(self.names)

    @cached_property
    def written(self) -> frozenset[str]:
        """The names of distributions, as the files of the package and of the folders above it write them."""
        texts = [*installing_texts(self.files), *texts_called(self.files, is_job)]
        found = {name for path, text in texts for name in names_in(path, text)}
        found.update(own_requirements(self.files, texts))
        listed = (name for path, text in texts_called(self.files, may_lock) for name in locked_names(path, text))
        return frozenset(found.union(listed))


def installing_texts(files: PackageFiles) -> Iterator[tuple[str, str]]:
    """Yield the requirements, pages and scripts of the package and of the folders above it, and all that containers
    are made by, with their paths.
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
    """Yield the names in a file of requirements, or behind `pip install` in commands."""
    if REQUIREMENTS.fullmatch(path):
        yield from (match[1] for match in LISTED.finditer(text))
        return
    if PROJECTS.fullmatch(path):
        yield from (name for found in NEEDED.findall(text) for name in found if name)
    for command in INSTALLS.finditer(text):
        yield from (word[0] for word in WORD.finditer(with_values(command[1], text)))


@lru_cache(maxsize=4096)
def key_of(name: str, index: Names) -> str | None:
    """Return the key of rosdep for a name on PyPI; each import that is missing asks for all of them."""
    return key_for_pip(name, index)


def normalized(name: str) -> str:
    return re.sub(r"[-_.]+", "-", name).lower()
