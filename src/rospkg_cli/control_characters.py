r"""Escape invisible characters and those that control a terminal or a log, as Python writes them.

`\x1b` for a control character, `\u202e` for one that turns the direction of writing, `\udcff` for a byte of a file name
that is not text. Every report, diff, table and message that shows a user's text calls this.
"""

from __future__ import annotations

import re

OBEYED = (
    r"\x00-\x08\x0b-\x1f\x7f-\x9f"  # C0, DEL, C1: what moves cursors, sets titles, answers as if it were typed
    r"\u061c\u200e\u200f\u202a-\u202e\u2066-\u206f"  # the direction of writing: https://trojansource.codes
    r"\u2028\u2029\ufeff\ufff9-\ufffb\ufffe\uffff"  # ends of lines, marks of encodings, no characters
    r"\ud800-\udfff\U000e0000-\U000e007f"  # bytes that are no text; letters that are never drawn
)
BRACKET = r"(?<=##)\[|(?<=##vso)\["
"""`##[…]` and `##vso[…]` are commands to the runners of GitHub and Azure, wherever they stand in a line."""

IN_LINES = f"[{OBEYED}]|{BRACKET}"
IN_ONE_LINE = rf"[{OBEYED}\t\n]|{BRACKET}"
SURROGATE = r"[\ud800-\udfff]"
NO_ASCII = r"[^\x00-\x7f]"
COMMAND = r"(?m)^([^\S\n]*):(?=:)"
"""`::…` begins a command to GitHub's runner, at the start of a line or behind blanks."""

SHORT = {"\t": "\\t", "\n": "\\n", "\r": "\\r"}

# Patterns are compiled when a text is not plain: a start on a usual package does without them.


def visible(text: str) -> str:
    """Return a text as one line without invisible characters or control characters.

    A prefix of a text becomes a prefix of what is returned, so that a column can be found again.
    """
    return text if is_plain(text) else re.sub(IN_ONE_LINE, escape, text)


def visible_lines(text: str) -> str:
    """Return a text as `visible` does, but keep its line ends (also `\\r\\n`) and tabs."""
    if is_plain(text.replace("\n", "")):
        return text
    return "\r\n".join(re.sub(IN_LINES, escape, line) for line in text.split("\r\n"))


def is_plain(text: str) -> bool:
    """Return whether a text certainly holds nothing to be escaped; quick, and false for some that hold nothing too."""
    return text.isprintable() and "##" not in text


def without_workflow_commands(text: str) -> str:
    """Escape lines that begin with `::`, commands of GitHub's runner; for text that is already laid out."""
    return re.sub(COMMAND, r"\1\\x3a", text) if "::" in text else text


def escape(found: re.Match[str]) -> str:
    code = ord(found.group())
    if short := SHORT.get(found.group()):
        return short
    return f"\\x{code:02x}" if code < 0x100 else f"\\u{code:04x}" if code < 0x10000 else f"\\U{code:08x}"


def in_json(text: str, only_ascii: bool = False) -> str:
    """Return a JSON document with the escapes of JSON for these characters, or for all that are not ASCII."""
    if not is_plain(text.replace("\n", "")):
        text = re.sub(IN_LINES, json_escape, text)
    return re.sub(NO_ASCII, json_escape, text) if only_ascii else text


def without_surrogates(text: str) -> str:
    """Return a JSON document in which surrogates (bytes of a name that are not text) are escaped."""
    return text if is_plain(text.replace("\n", "")) else re.sub(SURROGATE, lambda found: "\\" + escape(found), text)


def json_escape(found: re.Match[str]) -> str:
    code = ord(found.group())
    if code < 0x10000:
        return f"\\u{code:04x}"
    high, low = divmod(code - 0x10000, 0x400)
    return f"\\u{0xD800 + high:04x}\\u{0xDC00 + low:04x}"
