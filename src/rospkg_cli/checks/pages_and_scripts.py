"""The pages and scripts that tell people what to type: those of a package, and those above it that build it."""

from __future__ import annotations

from ..files import PackageFiles
from .setup.linked_build import build_texts

TEXTS = (".md", ".rst", ".txt", ".sh", ".bash", "Makefile")


def pages_and_scripts(files: PackageFiles) -> tuple[str, ...]:
    """Return what they say."""
    paths = [path for path in files.paths if path.endswith(TEXTS) and not path.endswith("CMakeLists.txt")]
    return (*map(files.readable_text, paths), *build_texts(files))
