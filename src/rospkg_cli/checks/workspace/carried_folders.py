"""Folders that pages and scripts of a repository bring to colcon: linked, copied or mounted into a workspace."""

from __future__ import annotations

from collections.abc import Iterator

from ...files import PackageFiles
from ...lazy_regex import regex
from ..repository.linked_build import TEXTS, build_texts

CARRIES = regex(r"\b(?:ln|cp|mv|rsync|robocopy|xcopy|COPY|ADD)\s+([^\n#;&|]*)")
"""A command that puts a folder elsewhere, with its words."""
LISTED = regex(r"\bcolcon\s[^\n#;&|]{0,200}?--(?:base-)?paths\s+([^\n#;&|]*)")
"""The folders that `--paths` or `--base-paths` of colcon lists."""
BASES = regex(r"\bbase-paths[\"']?\s*:((?:\s*-\s*[^\s-]\S*)+|\s*\[[^\]]*\])")
"""The same in the defaults of colcon, or in the options that a workflow passes to it."""
MOUNTS = regex(r"([^\s\"':=,]{0,200}[\w}./~)]):/[\w./$-]|\b(?:source|src)=([^,\s\"']+)")
"""A folder of the host that a container sees in another place."""
CONTINUED = regex(r"\\\n\s*")


def is_carried(files: PackageFiles, folder: str) -> bool:
    """Return whether a page or a script brings a folder of the package, or one around it, to another place."""
    parts = folder.split("/")
    around = tuple("/".join(parts[:end]) for end in range(1, len(parts) + 1))
    found = {word for text in every_text(files) for word in carried(text)}
    return any(word == each or word.endswith(f"/{each}") for word in found for each in around)


def every_text(files: PackageFiles) -> Iterator[str]:
    """Yield the pages and scripts of the package and the packages in it, and those that say how all is built."""
    yield from build_texts(files)
    for path in files.every:
        if is_page(path):
            yield files.readable_text(path)


def is_page(path: str) -> bool:
    return path.endswith(TEXTS) or path.rpartition("/")[2].startswith("Dockerfile")


def carried(text: str) -> Iterator[str]:
    """Yield the folders that a text brings elsewhere, as it writes them; of `arm/*` and `arm/.` the folder."""
    text = CONTINUED.sub(" ", text)
    found = [match[1] or match[2] for match in MOUNTS.finditer(text)]
    for match in CARRIES.finditer(text):
        words = [word for word in words_in(match[1]) if not word.startswith("-")]
        found += words[:-1] or words
    for match in LISTED.finditer(text):
        found += words_in(match[1])
    for match in BASES.finditer(text):
        found += words_in(match[1].replace(",", " "))
    yield from (word.strip("\"',[]()").removesuffix("*").removesuffix("/.").rstrip("/") for word in found)


def words_in(text: str) -> list[str]:
    return text.replace("`", " ").split()
