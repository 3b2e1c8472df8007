"""The text of a launch file without its comments."""

from __future__ import annotations

from ...lazy_regex import regex

IN_XML = regex(r"<!--(?:(?!-->)[\s\S]){0,5000}-->")
OTHERS = regex(r"#[^\n]*")


def uncommented(path: str, text: str) -> str:
    """Return a text without comments; in Python and YAML a `#` in a string counts as the beginning of one."""
    return (IN_XML if path.endswith((".xml", ".launch")) else OTHERS).sub("", text)
