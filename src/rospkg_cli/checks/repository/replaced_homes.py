"""Pages and scripts that have people write their own home in place of the one that files name, or that mount one."""

from __future__ import annotations

import re

from ...files import PackageFiles
from ...lazy_regex import regex
from .pages_and_scripts import pages_and_scripts

REPLACES = regex(r"(?i)\b(?:change|replace|adapt|adjust|substitute|update|sed|perl)\b")
WRITTEN_OUT = r"\b(?:hard[- ]?coded|absolute)\b"
VERB = r"\b(?:change|replace|adapt|adjust|update|modify|edit)\b"
HARD_CODED = regex(
    rf"(?i)(?:{WRITTEN_OUT}[^\n]{{0,40}}\bpaths?\b|\bpaths?\b[^\n]{{0,40}}{WRITTEN_OUT})[^#]{{0,160}}{VERB}"
    rf"|{VERB}[^\n]{{0,40}}{WRITTEN_OUT}[^\n]{{0,20}}\bpaths?\b"
)
"""What a page says of the paths in all files: `Paths are hard-coded: replace them with yours`."""
HOME = r"/(?:home|Users)/{0}(?![\w.-])"
MOUNTS = r"(?:(?:-v|--volume)[ \t=]+[^\s:]+:|\b(?:target|dst|destination)=){0}"


def is_home_replaced(files: PackageFiles, user: str) -> bool:
    """Return whether a page or a script has people replace the home of an account, or all paths that are written out.

    One in which a container is started with a folder mounted below that home shows that everybody has it there.
    """
    home = HOME.format(re.escape(user))
    named, mounted = re.compile(home), re.compile(MOUNTS.replace("{0}", home))
    for text in pages_and_scripts(files):
        if HARD_CODED.search(text) or mounted.search(text):
            return True
        lines = text.splitlines() if named.search(text) else []
        if any(named.search(line) and REPLACES.search(line) for line in lines):
            return True
    return False
