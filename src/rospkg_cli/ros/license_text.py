"""Read what people write into a <license>: one name, several, or prose."""

from __future__ import annotations

import re

from ..lazy_regex import regex
from .licenses import spdx_id

FAMILY = regex(
    r"(the |gnu )*(apache|apl|asl|bsd|mit|boost|bsl|[al]?gpl|lesser|general public|affero|mozilla|mpl|eclipse|epl|edl|"
    r"cc|creative commons|isc|zlib|proprietary|public domain|unlicense|[0-9]-clause bsd|cddl|qpl|artistic|python|psf)"
    r"(?![a-z])",
    re.IGNORECASE,
)
PARTED = regex(r"\s*(?:[,;/&]|\+\s|\band\b|\bor\b)\s*", re.IGNORECASE)
SPDX_CHOICE = regex(r"[\w.+-]+( (OR|WITH) [\w.+-]+)+")
STORY = regex(r"\b(see|refer|licen[cs]ed under|copyright|distributed|this (package|software|file))\b|://", re.I)
MAX_WORDS = 13
"""`GNU Library or "Lesser" General Public License version 2.1 or any later version` has so many."""


MAX_LENGTH = 300
"""A longer text is prose, not the name of a license."""


def licenses_in(text: str) -> list[str]:
    """Return the licenses that a text names, by SPDX id where it is known; one for a name that can't be parted.

    >>> licenses_in("BSD, MIT"), licenses_in("Apache License, Version 2.0"), licenses_in("GPLv2 or later")
    (['BSD', 'MIT'], ['Apache-2.0'], ['GPLv2 or later'])
    """
    if len(text) > MAX_LENGTH:
        return [text]
    known = spdx_id(text)
    parts = [part for part in PARTED.split(text) if part]
    if known or SPDX_CHOICE.fullmatch(text) or len(parts) < 2 or not all(map(names_one, parts)):
        return [known or text]
    return [spdx_id(part) or part for part in parts]


def names_one(text: str) -> bool:
    return spdx_id(text) is not None or FAMILY.match(text) is not None


def is_prose(text: str) -> bool:
    """Return whether a text is prose (where to look, what is permitted) instead of the name of a license."""
    if len(text) > MAX_LENGTH:
        return True
    return spdx_id(text) is None and (STORY.search(text) is not None or len(text.split()) > MAX_WORDS)
