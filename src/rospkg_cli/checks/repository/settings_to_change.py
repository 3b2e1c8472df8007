"""Settings that people are asked to change: by a comment next to the value, or by a page that names the file."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator

from ...files import PackageFiles
from ...lazy_regex import regex
from .linked_build import build_texts

VERB = r"(?:change|edit|adapt|adjust|modify|replace|customi[sz]e)"
OBJECT = (
    r"(?:here|this|these|me|it|them|(?:\w+_)?paths?|locations?|your|own|as needed|if (?:needed|necessary)|accordingly)"
)
ASKS = regex(
    rf"\b{VERB}\b[^\n]{{0,60}}\b{OBJECT}\b"
    r"|\b(?:set|specify|enter|put|insert)\b[^\n]{0,40}\bhere\b|\bset (?:(?:this|it) )?to your\b"
    r"|\bupdate\b[^\n]{0,60}\b(?:your|own|here|accordingly|to match|as (?:needed|required|appropriate))\b"
    r"|\byour(?: \w+){0,2} (?:paths?|files?|models?|maps?|folders?|director(?:y|ies)|locations?|user(?:name)?|home)\b"
    rf"|\b(?:TODO|FIXME)\b\W{{0,3}}{VERB}\b|\bchangeme\b"
    r"|\b(?:must|should|(?:has|have|needs?) to) be (?:changed|set|adapted|edited|adjusted|modified|replaced)\b",
    re.IGNORECASE,
)
"""How a comment asks people to write another value."""
ELSEWHERE = regex(
    r"\b(?:cambi(?:a|ar|e)|modifi(?:ca|car|que)|ajust(?:a|ar|e)|altere|mude)\b[^\n]{0,40}"
    r"\b(?:rutas?|caminhos?|est[aeo]|aqu[ií]|seg[uú]n|necess?[aá]rio|tus?|sua?)\b"
    r"|\b(?:Pfade?|hier|diese[rsn]?)\b[^\n]{0,40}\b(?:anpassen|ändern|ersetzen)\b"
    r"|\b(?:changer|modifier|remplacer|adapter)\b[^\n]{0,40}\b(?:chemins?|ici|votre|ce)\b"
    r"|(?:修改|替换|更改|改成|改为|换成)[^\n]{0,20}(?:路径|目录|这里|此处|你|自己)"
    r"|(?:路径|目录|这里|此处)[^\n]{0,20}(?:修改|替换|更改|改成|改为|换成)|(?:你|自己)的[^\n]{0,12}(?:路径|目录|文件)"
    r"|(?:パス|ここ)[^\n]{0,20}変更|(?:경로|여기)[^\n]{0,20}(?:변경|수정)",
    re.IGNORECASE,
)
"""The same in other languages."""
NAMES = regex(
    r"\b(?:set|configure|specify|enter|define)\b[^\n]{0,30}\b(?:paths?|folders?|director(?:y|ies)|files?|locations?)\b",
    re.IGNORECASE,
)
"""The heading of settings in a script that people start; in other files it may only say what the code does."""
ON_PAGE = regex(rf"\b(?:{VERB}|set|update)\b", re.IGNORECASE)
ABOUT = regex(r"\b(?:paths?|folders?|director(?:y|ies)|locations?|variables?|constants?|settings?)\b", re.IGNORECASE)
CONSTANT = regex(r"[ \t]*[A-Za-z_]\w*[ \t]*=[ \t]*[\"'rf]")
PAGES = (".md", ".rst")
HISTORY = "changelog"
COMMENTS, CONSTANTS = 3, 8
"""The most lines of a comment above, and of other settings between it and a value."""


def has_comment_to_change(text: str, bare: str, place: int, *, is_script: bool) -> bool:
    """Return whether a comment at a place, or above the settings there, asks people to change the value.

    `bare` is the text with blanks in place of comments; `is_script` says that only people start the file.
    """
    said = "\n".join(comments_at(text, bare, place))
    is_asked = ASKS.search(said) is not None or ELSEWHERE.search(said) is not None
    return is_asked or (is_script and NAMES.search(said) is not None)


def comments_at(text: str, bare: str, place: int) -> Iterator[str]:
    """Yield the comments of the line of a place and of those above, as far as they belong to it."""
    end = text.find("\n", place)
    start = text.rfind("\n", 0, place) + 1
    yield comment_of(text, bare, start, end if end >= 0 else len(text))
    comments = constants = 0
    while start > 0 and comments < COMMENTS:
        start, end = text.rfind("\n", 0, start - 1) + 1, start - 1
        code = bare[start:end].strip()
        if not text[start:end].strip() or (code and (comments or constants >= CONSTANTS)):
            return
        if not code:
            comments += 1
            yield comment_of(text, bare, start, end)
        elif CONSTANT.match(bare, start, end):
            constants += 1
        else:
            return


def comment_of(text: str, bare: str, start: int, end: int) -> str:
    """Return the comments of a part of the text, with blanks in place of code."""
    return "".join(each if bare[at : at + 1] == " " else " " for at, each in enumerate(text[start:end], start))


def has_page_to_change(files: PackageFiles, path: str) -> bool:
    """Return whether a line of a page of the package or repository asks people to change a path in a file."""
    name = re.compile(rf"(?<![\w-]){re.escape(posixpath.basename(path))}(?!\w)")
    pages = (each for each in files.paths if each.endswith(PAGES) and HISTORY not in each.lower())
    for page in (*map(files.readable_text, pages), *build_texts(files)):
        for line in page.splitlines() if name.search(page) else ():
            if name.search(line) and ON_PAGE.search(line) and ABOUT.search(name.sub("", line)):
                return True
    return False
