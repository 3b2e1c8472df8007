"""Missing plugins that do no harm: a comment or page has people write them, or says that nothing reads the name."""

from __future__ import annotations

import re

from ...files import PackageFiles
from ...finding import Hit, Severity

CODE = "PLG003"
WRITES = r"(?i)\b(?:write|create|implement|complete|develop)\b[^\n]*(?<![\w.-]){0}(?![\w-])"
UNREAD, ASKED = "a comment says that nothing reads it", "a comment says that it is still to be written"
BY_PAGE = "a page has people write it"


def why_left(files: PackageFiles, code: str, _: Severity, hit: Hit) -> str:
    """Return why a missing plugin of a parameter file does no harm; "" where it may.

    Args:
        files: of the whole run, for paths that begin with `/`.
    """
    path = hit.path.removeprefix("/")
    if code != CODE or not path.endswith((".yaml", ".yml")):
        return ""
    from ...checks.paths.home_path_texts import without_comments
    from ...checks.python.left_blank import is_asked_at, is_asked_for
    from ...checks.repository.pages_and_scripts import own_pages
    from ...checks.repository.settings_to_change import comments_at
    from .announced import UNUSED

    text, place = files.readable_text(path), hit.span.start
    lines = (place, text.rfind("\n", 0, place))
    said = [each for at in lines if at > 0 for each in comments_at(text, without_comments(path, text), at)]
    if any(re.search(UNUSED, each, re.IGNORECASE) for each in said):
        return UNREAD
    name = text[hit.span.start : hit.span.end].strip("'\"")
    last = re.split(r"\W+", name)[-1]
    if is_asked_for(text, last) or is_asked_at(text, place, last):
        return ASKED
    word = re.compile(WRITES.format(re.escape(last)))
    return BY_PAGE if last and any(map(word.search, own_pages(files))) else ""
