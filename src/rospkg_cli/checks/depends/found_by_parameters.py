"""Packages that parameter files name: `$(find-pkg-share nav2_bt_navigator)/…`, `interface_type: std_srvs/srv/Empty`."""

from __future__ import annotations

from collections.abc import Iterator

from ...files import PackageFiles
from ...lazy_regex import regex
from ...source import Span

FINDS = regex(r"(?m)^[^#\n]*?\$\(find-pkg-(?:share|prefix)\s+([A-Za-z]\w*)\s*\)")
TYPES = regex(
    r"(?m)^[ \t-]*(?:interface|message|service|action)_type[ \t]*:[ \t]*"
    r"['\"]?(([a-z][a-z0-9_]*)/(?:msg|srv|action)/[A-Z]\w*)['\"]?[ \t]*(?:#.*)?$"
)
NAMES = regex(r"(?m)^[^#\n]*?:[ \t]*['\"]?package://([A-Za-z]\w*)/([\w./-]+\.\w+)['\"]?[ \t]*(?:#.*)?$")
SUFFIXES = (".yaml", ".yml")


def found_by_parameters(files: PackageFiles) -> Iterator[tuple[str, str, Span]]:
    """Yield the name of each package with its path and place, the first of a line; comments are left out."""
    for path in files.paths:
        text = files.readable_text(path) if path.endswith(SUFFIXES) else ""
        if "$(find-pkg-" in text:
            for found in FINDS.finditer(text):
                yield found[1], path, Span(*found.span(1))


def named_by_parameters(files: PackageFiles) -> Iterator[tuple[str, str, str, Span]]:
    """Yield the package of each `package://` value, with the path in it, the path of the file and the place."""
    for path in files.paths:
        text = files.readable_text(path) if path.endswith(SUFFIXES) else ""
        if "package://" in text:
            for found in NAMES.finditer(text):
                yield found[1], found[2], path, Span(*found.span(1))


def typed_by_parameters(files: PackageFiles) -> Iterator[tuple[str, str, str, Span]]:
    """Yield the package of each interface type that a parameter has a node load, with the type, its path and place."""
    for path in files.paths:
        text = files.readable_text(path) if path.endswith(SUFFIXES) else ""
        if "_type:" in text:
            for found in TYPES.finditer(text):
                yield found[2], found[1], path, Span(*found.span(1))
