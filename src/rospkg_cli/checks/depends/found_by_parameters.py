"""Packages whose share directory parameter files look for: `$(find-pkg-share nav2_bt_navigator)/…`."""

from __future__ import annotations

from collections.abc import Iterator

from ...files import PackageFiles
from ...lazy_regex import regex
from ...source import Span

FINDS = regex(r"(?m)^[^#\n]*?\$\(find-pkg-(?:share|prefix)\s+([A-Za-z]\w*)\s*\)")
SUFFIXES = (".yaml", ".yml")


def found_by_parameters(files: PackageFiles) -> Iterator[tuple[str, str, Span]]:
    """Yield the name of each package with its path and place, the first of a line; comments are left out."""
    for path in files.paths:
        text = files.readable_text(path) if path.endswith(SUFFIXES) else ""
        if "$(find-pkg-" in text:
            for found in FINDS.finditer(text):
                yield found[1], path, Span(*found.span(1))
