"""The pages and scripts that tell people what to type: those of a package, and those above it that build it."""

from __future__ import annotations

from ..files import PackageFiles
from .setup.linked_build import build_texts

TEXTS = (".md", ".rst", ".txt", ".sh", ".bash", "Makefile")


def pages_and_scripts(files: PackageFiles) -> tuple[str, ...]:
    """Return what they say."""
    return (*own_pages(files), *build_texts(files))


def own_pages(files: PackageFiles) -> tuple[str, ...]:
    paths = [path for path in files.paths if path.endswith(TEXTS) and not path.endswith("CMakeLists.txt")]
    return tuple(map(files.readable_text, paths))


def pages_above(files: PackageFiles) -> tuple[str, ...]:
    """Return what those say that build the repository and are no pages of the package."""
    own = own_pages(files)
    return tuple(text for text in build_texts(files) if text not in own)
