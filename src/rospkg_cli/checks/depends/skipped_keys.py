"""The names that pages, scripts and containers of a repository have rosdep skip, so that it does not miss them."""

from __future__ import annotations

from collections.abc import Iterator

from ...files import PackageFiles
from ...lazy_regex import regex
from ..repository.pages_and_scripts import pages_and_scripts
from .installing_texts import installing_texts
from .shell_variables import with_values

SKIPS = regex(
    r"(?:--skip-keys?[ \t=]+|\brosdep-skip-keys[ \t]*:[ \t]*|\bROSDEP_SKIP_KEYS[\"']?[ \t]*[=:][ \t]*)"
    r"(?:\"([^\"\n]{0,2000})\"|'([^'\n]{0,2000})'|([^\s\"'\\;&|`]+))"
    r"|--skip-keys?[\"'][ \t]*,[ \t]*[\"']([^\"'\n]{0,2000})[\"']"
)
"""The option of rosdep, also in a Python list, and its names in action-ros-ci and industrial_ci."""


def skipped_keys(files: PackageFiles) -> frozenset[str]:
    """Return the names, as far as they are written out, be it in a variable of the script."""
    texts = (text for text in texts_on_dependencies(files) if "skip" in text.lower())
    found = (
        with_values(next(filter(None, match.groups()), ""), text) for text in texts for match in SKIPS.finditer(text)
    )
    return frozenset(name for each in found for name in each.split())


def texts_on_dependencies(files: PackageFiles) -> Iterator[str]:
    """Yield the texts that say how the dependencies of a repository are installed."""
    yield from pages_and_scripts(files)
    yield from (text for _, text in installing_texts(files))
