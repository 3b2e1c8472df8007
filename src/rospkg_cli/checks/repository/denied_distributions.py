"""Where a text rules out distributions: `not tested on Jazzy`, `Foxy is no longer supported`."""

from __future__ import annotations

from ...lazy_regex import regex
from ...ros.distros import DISTROS

EVERY = "|".join(("dashing", "eloquent", "foxy", "galactic", "iron", *(each.name for each in DISTROS)))
SIGNS = (
    "not",
    "n't",
    "n’t",
    "no longer",
    "never",
    "un",
    "inc",
    "drop",
    "rather",
    "instead",
    "plan",
    "soon",
    "[ ]",
    "不",
    "未",
)
"""Of which one stands in every text that denies something."""
NEGATION = r"(?:\bnot|n['’]t|\bcannot|\bno longer|\bnever)"
VERB = r"(?:support\w*|work\w*|test\w*|compatib\w*|compil\w*|build|built|run|guarante\w*|verified|validated|ported)"
DENIES = regex(
    rf"{NEGATION}\s+(?:\w+\s+){{0,2}}{VERB}|\b(?:unsupported|untested|incompatible|planned|coming soon)\b"
    rf"|\b(?:not|instead of|rather than)\s+(?:(?:on|for|with|in|ros[ _-]?2?)\s+){{0,2}}(?=(?:{EVERY})\b)"
    r"|\b(?:drop\w*|end\w*|remov\w*|without)\s+(?:the\s+)?support|\bdo(?:n['’]t| not) use\b"
    r"|[-*][ \t]+\[ \]|不支持|不兼容|未测试"
)
"""What says so of those behind it; an empty box stands before what is still to be done."""
ENDS = regex(
    r"[.!?;](?:\s|$)|\n[ \t]*(?:\n|[-*#|>]|\d+\.)|[|。；，]"
    r"|\b(?:but|only|however|whereas|although|because|if|unless|until|please|use|(?:tested|works?|runs?) (?:on|with))\b"
)
"""Where the statement ends, or another one begins."""
REACH = 120
"""The most characters behind the word that are read as what it denies."""
PLACE = r"(?:yet|anymore|any more|any longer|officially|here|either|at the moment|for now)"
SUBJECT = regex(
    rf"(?:^|(?<=[.!?;:,|(\n-]))[^.!?;:,|(\n]{{3,60}}(?:[|:][ \t]*)?"
    rf"(?:{NEGATION}[ \t]+(?:(?:yet|officially|currently|actively|been|fully)[ \t]+){{0,2}}"
    r"(?:supported|tested|compatible|work|working|maintained)"
    r"|\b(?:unsupported|untested|incompatible|planned|coming soon))"
    rf"(?=[ \t]*(?:{PLACE}|[).,;!|\n]|$))"
)
"""What is denied itself, before the word that does so and ends the statement: `Foxy and Galactic are not supported`."""


def without_denied(text: str) -> str:
    """Return a text in lower case without the statements that deny something."""
    if not any(sign in text for sign in SIGNS):
        return text
    text, parts, at = SUBJECT.sub(" ", text), [], 0
    for found in DENIES.finditer(text):
        if found.start() >= at:
            behind = found.end() + REACH
            end = ENDS.search(text, found.end(), behind)
            parts.append(text[at : found.start()])
            at = end.start() if end is not None else min(len(text), behind)
    return " ".join((*parts, text[at:]))
