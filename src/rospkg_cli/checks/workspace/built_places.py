"""Where pages and scripts of a repository start colcon: it looks for packages from there on."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator

from ...files import PackageFiles
from ...lazy_regex import regex
from ..repository.container_files import OF_CONTAINER, files_called
from ..repository.linked_build import build_texts

STEP = regex(
    r"""(?:\b(?:cd|pushd|WORKDIR)|\bworking-directory:|"cwd"[ \t]*:)[ \t]+["']?(?:\$\([^)\n]*\)["']?)?([\w./~${}-]+)"""
    r"""|\bcolcon[ \t]+(?:--log-\w+[ \t]+\S+[ \t]+)*build\b(?:.*--base-paths[ \t]+["']?([\w./~${}-]+))?"""
)
"""A change of the folder, or a build, perhaps of another folder."""
INSTALLED = r"(?<![\w-]){0}/install/(?:local_)?(?:setup\.\w+|{1}\b)"
"""What colcon leaves where it was started: `inner/install/setup.bash`, `inner/install/inner/lib`."""


def is_built_from(files: PackageFiles, folder: str) -> bool:
    """Return whether colcon is started in a folder of the package, or around it: `cd ~/robot/control`."""
    parts = folder.split("/")
    around = tuple("/".join(parts[:end]) for end in range(1, len(parts) + 1))
    texts = tuple(building_texts(files))
    places = {place for text in texts if "colcon" in text for place in places_in(text)}
    if any(place == each or place.endswith(f"/{each}") for place in places for each in around):
        return True
    left = [re.compile(INSTALLED.format(re.escape(each), re.escape(parts[-1]))) for each in around]
    return any(each.search(text) for text in texts if "/install/" in text for each in left)


def building_texts(files: PackageFiles) -> Iterator[str]:
    """Yield the texts that tell how a repository is built, and those of its containers, wherever they lie."""
    yield from build_texts(files)
    yield from (owner.readable_text(path) for owner, path in files_called(files, OF_CONTAINER))


def places_in(text: str) -> list[str]:
    """Return the folders in which a page or a script starts colcon, each by the steps to it, as it writes these."""
    found, here = list[str](), ""
    for step in STEP.finditer(text):
        if step[1]:
            here = posixpath.normpath(posixpath.join(here, step[1]))
        else:
            found.append(posixpath.normpath(step[2] or here) if step[2] or here else "")
    return found
