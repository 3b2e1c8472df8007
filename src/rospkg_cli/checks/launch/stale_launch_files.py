"""Launch files whose first lines, or a page, say that they are no longer used or not finished yet."""

from __future__ import annotations

import posixpath
import re

from ...files import PackageFiles
from ...lazy_regex import regex
from ...package.file_role import role_of
from ...package.launch.live_text import live_text
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ..repository.pages_and_scripts import pages_and_scripts
from ..repository.spare_files import HEAD, SAYS
from ..share.opened_elsewhere import opening_elsewhere
from ..unintended_starts import UNDONE, UNFINISHED
from ..unstarted_programs import STALE, sentences

SAID_BY_PAGE = "a page says that this launch file is no longer used, or not finished yet"
FAILS = regex(r"(?i)\b(?:this|the) (?:launch |launch ?file |file ){1,2}(?:no longer works|does(?: not|n't) work)\b")
MARKUP = regex(r"\s*(?:<\?xml[^>]*\?>\s*)?(?:<launch\b[^>]*>\s*)?((?:<!--(?:[^-]|-(?!->)){0,2000}-->\s*)*)")
"""The comments with which a launch file in XML begins, also behind its first tag."""
STARTS = regex(r"\bros2[\s\"',]+launch\b")


def why_stale(files: PackageFiles, package: PackageFacts, workspace: Workspace, path: str) -> str:
    """Return what says that a launch file is not to be started; "" where nothing does, or something starts it."""
    name = posixpath.basename(path)
    word = re.compile(rf"(?<![\w-]){re.escape(name)}(?!\.?\w)")
    lines = [each for text in pages_and_scripts(files) if name in text for each in sentences(text)]
    named = [line for line in lines if word.search(line)]
    is_stale = any(map(STALE.search, named))
    if not is_stale and not says_so(files.readable_text(path)):
        return ""
    if any(STARTS.search(line) and not STALE.search(line) for line in named):
        return ""
    launches = (each for each in files.paths if each != path and role_of(each) == "launch")
    others = (*(live_text(files, each) for each in launches), *opening_elsewhere(files, package.name, workspace))
    if any(map(word.search, others)):
        return ""
    return SAID_BY_PAGE if is_stale else UNDONE


def says_so(text: str) -> bool:
    """Return whether the first comment of a launch file says that it is given up, or not finished."""
    head = (MARKUP if text.lstrip().startswith("<") else HEAD).match(text)
    return head is not None and any(each.search(head[0]) for each in (SAYS, UNFINISHED, FAILS))
