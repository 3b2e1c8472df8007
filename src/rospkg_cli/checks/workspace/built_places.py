"""Where pages and scripts of a repository start colcon: it looks for packages from there on."""

from __future__ import annotations

from ...files import PackageFiles
from ...lazy_regex import regex
from ..setup.linked_build import build_texts

STEP = regex(
    r"""(?:\b(?:cd|pushd|WORKDIR)|\bworking-directory:)[ \t]+["']?([\w./~${}-]+)"""
    r"""|\bcolcon[ \t]+build\b(?:.*--base-paths[ \t]+([\w./~${}-]+))?"""
)
"""A change of the folder, or a build, perhaps of another folder."""


def is_built_from(files: PackageFiles, folder: str) -> bool:
    """Return whether colcon is started in a folder of the package, or around it: `cd ~/robot/control`."""
    parts = folder.split("/")
    around = tuple("/".join(parts[:end]) for end in range(1, len(parts) + 1))
    places = {place for text in build_texts(files) if "colcon" in text for place in places_in(text)}
    return any(place == each or place.endswith(f"/{each}") for place in places for each in around)


def places_in(text: str) -> list[str]:
    """Return the folders in which a page or a script starts colcon, as it writes them."""
    found, here = list[str](), ""
    for step in STEP.finditer(text):
        if step[1]:
            here = step[1].rstrip("/")
        else:
            found.append((step[2] or here).rstrip("/"))
    return found
