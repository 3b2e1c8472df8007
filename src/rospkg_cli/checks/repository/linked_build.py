"""Whether a repository is built with `colcon build --symlink-install`, or `--merge-install`, by the files that do."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from ...files import PackageFiles
from ...lazy_regex import regex
from ...tree import READABLE
from .container_files import is_shell_script

LINKS, MERGES = b"symlink-install", b"merge-install"
PAGES = tuple(
    f"{name}{suffix}"
    for name in ("README", "Readme", "readme", "ReadMe", "SETUP", "INSTALL", "BUILD", "CLAUDE", "AGENTS")
    for suffix in (".md", ".rst", ".txt", "")
)
SCRIPTS = tuple(
    f"{name}.{end}"
    for name in "build setup install compile run start entrypoint docker_entrypoint".split()
    for end in ("sh", "bash")
)
FILES = (*PAGES, *SCRIPTS, "Makefile", "justfile", "Dockerfile", "docker-compose.yml", "docker-compose.yaml",
         "colcon_defaults.yaml", "colcon.meta", ".gitlab-ci.yml")  # fmt: skip
"""Files that say how a repository is built, in each folder from the package's up to the root."""
WORKFLOWS = ".github/"
FOLDERS = (".github/workflows", ".vscode", ".devcontainer", ".docker", "docker", "scripts")
"""Folders of files of any name that build it."""
BUILD = regex(r"(?m)^(?![ \t]*#).*?\b(colcon build\b(?:[^`\n\\]|\\.|\\\n)*)")
CHOSEN = regex(r"--packages-(?:select|up-to|above)((?:[ \t\\\n]+[\w.${}-]+)+)")
CLEANS = regex(r"--cmake-(?:target[ =]+|clean-)|--help\b")
TEXTS = (".md", ".sh", ".bash", ".yml", ".yaml", ".json", "Dockerfile")


def linking_file(files: PackageFiles) -> str:
    """Return the file, in the package's folder or above it, that builds it with links to its sources; "" for none."""
    return first_with(files, LINKS)


def is_always_linked(files: PackageFiles, package: str) -> bool:
    """Return whether files tell people how to build a package, and each command that does so links to its sources.

    A workflow builds with links for itself.
    """
    places = [(whole.readable_text(path), path) for whole, path in build_files(files) if whole.has_file(path)]
    commands = [(each, path) for text, path in places for each in BUILD.findall(text) if builds(each, package)]
    is_told = any(WORKFLOWS not in path for _, path in commands)
    return is_told and all(LINKS.decode() in each for each, _ in commands)


def builds(command: str, package: str) -> bool:
    """Return whether a `colcon build` builds a package: it names it, or none."""
    chosen = CHOSEN.search(command)
    return not CLEANS.search(command) and (chosen is None or package in chosen[1].split())


def merging_file(files: PackageFiles) -> str:
    """Return the file, in the package's folder or above it, that installs all packages into one folder; "" for none."""
    return first_with(files, MERGES)


def first_with(files: PackageFiles, word: bytes) -> str:
    return next((path for whole, path in build_files(files) if whole.holds(path, word)), "")


def build_files(files: PackageFiles) -> Iterator[tuple[PackageFiles, str]]:
    """Yield the paths where files may be that say how a repository is built, with the files of the whole of it."""
    tree = files.whole if files.whole is not None else files.tree
    whole = PackageFiles(tree)
    parts = files.folder.split("/") if files.folder and files.whole is not None else []
    for depth in range(len(parts), -1, -1):
        above = "/".join(parts[:depth])
        yield from ((whole, posixpath.join(above, name)) for name in FILES)
        yield from ((whole, path) for path in building(whole, above))


def build_texts(files: PackageFiles) -> Iterator[str]:
    """Yield what these files say; those of packages, too."""
    yield from (whole.readable_text(path) for whole, path in build_files(files) if whole.has_file(path))


def building(whole: PackageFiles, above: str) -> Iterator[str]:
    """Yield the files in the folders of scripts below a folder."""
    for folder in FOLDERS:
        place = posixpath.join(above, folder)
        for path, kind in whole.tree.sub(place).files().items():
            if kind in READABLE and (path.endswith(TEXTS) or is_shell_script(whole, f"{place}/{path}")):
                yield f"{place}/{path}"
