"""Which libraries the pages of a repository have people install by hand: wheels, clones, conda, from source."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cached_property

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from .installing_texts import installing_texts, is_job, texts_called

CLONES = regex(r"\bgit\s+clone\b[^\n]*?[/:]([\w.-]+?)(?:\.git)?/?(?=[\s'\"`)]|$)", re.MULTILINE)
CONDA = regex(r"\b(?:conda|mamba)\s+install\b([^\n&|;]*)")
WHEELS = regex(r"((?:[\w.+-]+(?:\s*[/,&]\s*|\s+and\s+))*[\w.+-]+)\s+(?:wheels\b|wheel files?\b|\S+\.whl\b)")
"""Names that stand before the word: `torch / flash-attn wheels`; a `wheel` alone is often one of a robot."""
SOURCE = regex(r"\b(?:build|compile|install)\w*\b((?:[^.\n]|\.(?!\s)){0,80}?)\bfrom sources?\b", re.IGNORECASE)
COPIES = regex(r"(?i)\b(?:cp|mv|copy|move|put)\b([^\n]{0,300}?)(?:/usr/(?:local/)?include|\b(?:site|dist)-packages)")
FETCHES = regex(r"\bgit\+[^\s\"']{0,200}?/([\w.-]+?)(?:\.git)?/?(?=[@#\s\"'`)]|$)", re.MULTILINE)
WHEEL_FILES = regex(r"\bpip3?\s+install\b[^\n]{0,300}?\b([A-Za-z]\w*)(?:[-.][\w.+-]{0,80})?\.(?:whl|tar\.gz|zip)\b")
DEBS = regex(
    r"\b(?:dpkg|gdebi|apt(?:-get)?|wget|curl)\b[^\n]{0,300}?(?<![\w.+-])([A-Za-z][\w.+-]*?)(?:_[^\s/]*)?\.deb\b"
)
"""A package for apt that comes as a file: `dpkg -i libmodbus_3.1_amd64.deb`."""
LINKED = regex(
    r"(?i)\b(?:install|build|compile)\b(?![^\n]{0,160}\b(?:rosdep|apt)\b)[^\n]{0,160}?\]\(https?://git(?:hub|lab)\.com"
    r"/[\w.-]{1,100}/([\w.-]{1,100}?)(?:\.git)?(?=[/)#?])"
)
"""What a page has people install, and where it links to: `Install the [SDK](https://github.com/acme/libacme)`."""
ROBOTPKG = regex(r"\brobotpkg-(?:py\d+-)?([a-z][\w-]*)")
"""The names of packages of robotpkg, the apt repository of LAAS that has Pinocchio."""
RELEASES = regex(r"\bgithub\.com/[\w.-]{1,100}/([\w.-]{1,100})/(?:releases|archive)\b")
"""The address of a release, or of its sources, on GitHub."""
FOLDERS = regex(r"\bpip3?\s+install\s+(?:-\w\s+)?((?:\.{1,2}|~)?/[^\s&|;]+)")
SETUPS = regex(r"\bcd\s+([^\n;&|]{1,200})[^c]{0,9}(?:sudo\s+)?python[\d.]*\s+setup\.py\s+install\b")
"""Commands that install a library from a folder: `cd lib && python setup.py install`."""
MAKES = regex(
    r"\b(?:cd|pushd|WORKDIR)[ \t]+\"?(?:[^\s;&|]{0,200}/)?([A-Za-z][\w.+-]*)\*?(?=/?[\s;&|\"'`)])(?=(?s:.){0,400}?\b(?:"
    r"(?:make|ninja)[ \t][^\n;&|]{0,40}?install|cmake[^\n;&|]{0,60}?[ \t]--(?:install|target[ =]install))\b)"
)
"""The folder of sources that are built and installed: `cd lcm-1.4.0 && mkdir build && cd build && …`."""
MADE_THERE = regex(
    r"\b(?:make|ninja)[ \t]+-C[ \t]+(?:[^\s;&|]{0,200}/)?([A-Za-z][\w.+-]*)(?=/?[ \t][^\n;&|]{0,40}?install\b)"
    r"|\bcmake[ \t][^\n;&|]{0,200}?-S[ \t]*(?:[^\s;&|]{0,200}/)?([A-Za-z][\w.+-]*)/?"
    r"(?=[\s;&|](?s:.){0,400}?\bcmake[^\n;&|]{0,60}?[ \t]--install\b)"
)
"""The same without `cd` into the folder: `make -C lcm install`."""
ARCHIVES = regex(
    r"\b(?:wget|curl)\b[^\n]{0,300}?/([A-Za-z][\w+]*?(?:-[A-Za-z]\w*)*)[-_]v?\d[\w.]*\.(?:tar\.\w+|tgz|zip)\b"
    r"(?=(?s:.){0,800}?\b(?:make|ninja|cmake)\b[^\n;&|]{0,60}?\binstall\b)"
)
"""An archive of sources that is downloaded, and built and installed after that."""
RELEASE = regex(r"[-_.]v?\d+(?:\.\d+)+$")
"""The version at the end of the name of an unpacked archive's folder."""
WORD = regex(r"[A-Za-z][\w.+-]*")
AROUND = regex(r"^(?:python3?-|lib)|(?:-dev|\.h|\.hpp|\.git|\.py|\d+)$")
"""Prefixes and suffixes of keys, headers and packages of CMake around the name of a library."""
BY_PAGE = "; a page here says to install it by hand, and the key may bring another version"


@dataclass(frozen=True)
class HandInstalls:
    files: PackageFiles

    def has(self, names: Iterable[str]) -> bool:
        """Return whether a page says to install a library by hand, by one of its names."""
        return not self.named.isdisjoint({plain(each.partition("/")[0]) for each in names} - {""})

    @cached_property
    def named(self) -> frozenset[str]:
        """What pages say to install by hand, without `lib`, `-dev` and the like; words of prose are among it."""
        found = set[str]()
        for _, text in (*installing_texts(self.files), *texts_called(self.files, is_job)):
            found.update(
                name
                for each in (CLONES, FETCHES, RELEASES, ROBOTPKG, LINKED, WHEEL_FILES, ARCHIVES)
                for name in each.findall(text)
            )
            found.update(RELEASE.sub("", name) for each in (MAKES, DEBS) for name in each.findall(text))
            found.update(RELEASE.sub("", name) for names in MADE_THERE.findall(text) for name in names if name)
            parts = (part for each in (CONDA, WHEELS, SOURCE, COPIES, FOLDERS, SETUPS) for part in each.findall(text))
            found.update(word for part in parts for word in WORD.findall(part))
        return frozenset(map(plain, found))


def plain(name: str) -> str:
    """Return a name as people write it: `nanoflann` of `libnanoflann-dev` and `nanoflann.hpp`."""
    lower = re.sub(r"[-_.]+$", "", name.lower())
    return re.sub(r"[-_]+", "-", AROUND.sub("", AROUND.sub("", lower)))
