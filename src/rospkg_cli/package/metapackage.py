"""Metapackages: packages that have nothing of their own and only depend on others."""

from __future__ import annotations

import re

from ..files import PackageFiles
from ..lazy_regex import regex
from .manifest import Manifest

PAPER = regex(r"(.*/)?(README|CHANGELOG|LICENSE|LICENCE|CONTRIBUTING|QUALITY_DECLARATION|NOTICE|Doxyfile)[^/]*", re.I)
FRAME = regex(
    r"package\.xml|CMakeLists\.txt|setup\.(py|cfg)|resource/[^/]*|\.[^/]*|docs?/.*|rosdoc2?\.ya?ml|(.*/)?__init__\.py|COLCON_IGNORE"
)


def is_metapackage(files: PackageFiles, manifest: Manifest) -> bool:
    """Return whether a package declares itself one, or has only the files of an empty package and dependencies."""
    if any(element.tag == "metapackage" for element in manifest.exports):
        return True
    runs = any(d.tag in ("exec_depend", "depend", "run_depend") for d in manifest.dependencies)
    return runs and all(PAPER.fullmatch(path) or FRAME.fullmatch(path) for path in files.paths)
