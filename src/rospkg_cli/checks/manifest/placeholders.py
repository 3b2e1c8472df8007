"""What templates leave in package.xml and setup.py for the owner to fill in."""

from __future__ import annotations

import re

from ...lazy_regex import regex

TODO = regex(
    r"\W*(?i:TODO|TBD|FIXME|XXX|none|description|(a )?package description)\W*|\W*TODO\b.*|(?i:todo:).*", re.DOTALL
)
EMAIL = regex(r".*@todo(\.\w+)?|(todo@|your[._-]?e?-?mail|(user|you|email|name)@(example|domain)\b).*", re.I)
NAMES = frozenset({"TODO", "YOUR NAME", "YOUR_NAME"})
"""In upper case."""


def is_placeholder(text: str) -> bool:
    """Return whether a license, a name or an address is a template's."""
    return not text or any(each.fullmatch(text) for each in (TODO, EMAIL)) or text.upper() in NAMES
