"""Which libraries the pages of a repository tell people to install by hand: wheels, clones, conda, from source."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cached_property

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from .pip_installs import ABOVE, TYPED

CLONES = regex(r"\bgit\s+clone\b[^\n]*?[/:]([\w.-]+?)(?:\.git)?/?(?=[\s'\"`)]|$)", re.MULTILINE)
CONDA = regex(r"\b(?:conda|mamba)\s+install\b([^\n&|;]*)")
WHEELS = regex(r"((?:[\w.+-]+(?:\s*[/,&]\s*|\s+and\s+))*[\w.+-]+)\s+(?:wheels\b|wheel files?\b|\S+\.whl\b)")
"""Names that stand before the word: `torch / flash-attn wheels`; a `wheel` alone is often one of a robot."""
SOURCE = regex(r"\b(?:build|compile|install)\w*\b((?:[^.\n]|\.(?!\s)){0,80}?)\bfrom sources?\b", re.IGNORECASE)
COPIES = regex(r"\bcp\b([^\n]*)/usr/(?:local/)?include")
WORD = regex(r"[A-Za-z][\w.+-]*")
AROUND = regex(r"^(?:python3?-|lib)|(?:-dev|\.h|\.hpp|\.git|\d+)$")
"""What keys, headers and packages of CMake have around the name of a library."""
BY_PAGE = "; a page here tells to install it by hand, and the key may bring another version"


@dataclass(frozen=True)
class HandInstalls:
    files: PackageFiles

    def has(self, names: Iterable[str]) -> bool:
        """Return whether a page tells to install a library by hand, by one of its names."""
        return not self.told.isdisjoint({plain(each.partition("/")[0]) for each in names} - {""})

    @cached_property
    def told(self) -> frozenset[str]:
        """What pages tell so of, without what keys and headers have around it; words of prose are among it."""
        found = set[str]()
        for text in self.texts:
            found.update(CLONES.findall(text))
            told = (part for each in (CONDA, WHEELS, SOURCE, COPIES) for part in each.findall(text))
            found.update(word for part in told for word in WORD.findall(part))
        return frozenset(map(plain, found))

    @property
    def texts(self) -> Iterable[str]:
        for path in self.files.paths:
            if TYPED.fullmatch(path):
                yield self.files.readable_text(path)
        whole = PackageFiles(self.files.whole) if self.files.whole is not None else None
        for each in ABOVE if whole is not None else ():
            above = self.files.above((each,))
            if whole is not None and above:
                yield whole.readable_text(above)


def plain(name: str) -> str:
    """Return a name as people write it: `nanoflann` of `libnanoflann-dev` and `nanoflann.hpp`."""
    lower = re.sub(r"[-_.]+$", "", name.lower())
    return re.sub(r"[-_]+", "-", AROUND.sub("", AROUND.sub("", lower)))
