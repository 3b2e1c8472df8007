"""Where the files that setuptools reads name the package they belong to: all but addresses, prose and longer names."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ..lazy_regex import regex
from ..source import Source, Span
from .common import URL
from .own_paths import own_paths
from .patterns import found
from .renamed_package import RenamedPackage

PROSE = regex(r"^[ \t]*(?:#|description\b|keywords\b|long_description\b).*$", re.MULTILINE)
COMMANDS = (r"""(?:^|["'])[ \t]*%NAME%(?=[ \t]*=[ \t]*[\w.]+:\w)""",)
TEXTS = (r"\bresource/%NAME%", r"""\bdescription\s*=\s*["']The %NAME%(?= package["'])""")
MODULES = (r"(?<![\w.-])%PART%(?=[.:]\w+)",)


def in_setup_cfg(source: Source, renamed: RenamedPackage) -> Iterator[Span]:
    """Yield the places in setup.cfg, pyproject.toml, MANIFEST.in and other files that Python tools read."""
    aside = [match.span() for each in (PROSE, URL) for match in each.finditer(source.text)]
    for match in re.finditer(rf"(?<![\w.-]){re.escape(renamed.old)}(?![\w-])", source.text):
        if any(start <= match.start() < end for start, end in aside):
            continue
        if is_file_name(source.text[match.end() :], renamed) or not may_follow(source.text, match, renamed):
            continue
        yield Span(*match.span())


def may_follow(text: str, match: re.Match[str], renamed: RenamedPackage) -> bool:
    """Return whether a name is no command that keeps its name, and no folder that does."""
    if not renamed.has_executable and re.match(r"[\"']?[ \t]*=[ \t]*[\"']?[\w.]+:\w", text[match.end() :]):
        return False
    before = text[: match.start()]
    return not before.endswith("/") or before.endswith(("lib/", "share/", "resource/", "src/", "include/"))


def is_file_name(rest: str, renamed: RenamedPackage) -> bool:
    """Return whether a dot and what follows make the name of a file, no module."""
    inner = re.match(r"\.(\w+)(?P<more>(?:\.\w+)*\s*:\s*\w)?", rest)
    return inner is not None and not inner["more"] and inner[1] not in renamed.submodules


def entry_points(source: Source, renamed: RenamedPackage) -> Iterator[Span]:
    """Yield the places in the entry points of a setup.py, however they are written."""
    if renamed.has_executable:
        yield from found(COMMANDS, source.text, renamed.old)
    for span in found(MODULES, source.text, renamed.old) if renamed.has_module else ():
        if not is_file_name(source.text[span.end :], renamed):
            yield span
    yield from own_paths(source.text, renamed)
    yield from found(TEXTS, source.text, renamed.old)
