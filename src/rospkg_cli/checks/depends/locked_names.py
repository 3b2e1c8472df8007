"""The libraries in lock files and in conda environments, whatever the names of these files are."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...lazy_regex import regex

LOCKS = regex(
    r"(?:.*/)?(?:(?:uv|poetry|pdm|pixi|Pipfile)\.lock|pylock(?:\.[^/.]+)?\.toml|(?:[^/]*[.-])?conda-lock\.ya?ml)"
)
YAML = regex(r".*\.ya?ml")
LOCKED = regex(
    r"(?m)^[ \t]*(?:-[ \t]+)?name[ \t]*[:=][ \t]*[\"']?([A-Za-z][\w.-]*)"
    r"|^[ \t]*\"([A-Za-z][\w.-]*)\":[ \t]*\{"
    r"|^[ \t]*-[ \t]+conda:[ \t]+\S*/([A-Za-z][\w.-]*?)-[^-\s/]+-[^-\s/]+\.(?:conda|tar\.bz2)[ \t]*$"
)
"""An entry as TOML or YAML has it, as the JSON of pipenv has it, and as an address that pixi takes it from."""
NEEDS = regex(r"^dependencies[ \t]*:(.*?)(?=^[A-Za-z_]|\Z)", re.MULTILINE | re.DOTALL)
COMMENT = regex(r"(?m)(?:^|[ \t])#.*$")
ENTRY = regex(r"(?:^[ \t]*-|[\[,{])[ \t]*[\"']?(?:[\w.-]+::)?([A-Za-z][\w.-]*)", re.MULTILINE)
"""An entry of a list in either style of YAML, without the channel that is to have it."""
OF_CONDA = {"matplotlib-base": "matplotlib", "py-opencv": "opencv-python", "pytorch": "torch"}
"""What conda-forge calls otherwise than PyPI."""


def may_lock(path: str) -> bool:
    """Return whether a file is a lock file, or YAML, which may be an environment."""
    return any(names.fullmatch(path) for names in (LOCKS, YAML))


def locked_names(path: str, text: str) -> Iterator[str]:
    """Yield the names in a lock file, or in what is an environment of conda by its contents."""
    if LOCKS.fullmatch(path):
        yield from (name for found in LOCKED.findall(text) for name in found if name)
    elif "channels:" in text:
        for needs in NEEDS.findall(text):
            yield from (OF_CONDA.get(name, name) for name in ENTRY.findall(COMMENT.sub("", needs)))
