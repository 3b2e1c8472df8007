"""Which names the pages, scripts and containers of a repository have rosdep skip: their absence stops nobody there."""

from __future__ import annotations

from ...files import PackageFiles
from ...lazy_regex import regex
from ..pages_and_scripts import pages_and_scripts
from .pip_installs import installing_texts

SKIPS = regex(
    r"(?:--skip-keys?[ \t=]+|\brosdep-skip-keys[ \t]*:[ \t]*|\bROSDEP_SKIP_KEYS[\"']?[ \t]*[=:][ \t]*)"
    r"(?:\"([^\"\n]{0,2000})\"|'([^'\n]{0,2000})'|([^\s\"'\\;&|`]+))"
)
"""A word of rosdep's command line, and what action-ros-ci and industrial_ci call it."""


def skipped_keys(files: PackageFiles) -> frozenset[str]:
    """Return the names, as far as they are written out."""
    texts = (*pages_and_scripts(files), *(text for _, text in installing_texts(files)))
    found = (match for text in texts if "skip" in text.lower() for match in SKIPS.finditer(text))
    return frozenset(name for match in found for name in (match[1] or match[2] or match[3] or "").split())
