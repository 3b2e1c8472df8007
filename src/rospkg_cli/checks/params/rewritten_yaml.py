"""Parameter files that launch files write anew with RewrittenYaml of nav2_common before nodes read them."""

from __future__ import annotations

import re
from collections.abc import Iterable

from ...lazy_regex import regex

REWRITES = "RewrittenYaml"
"""Of nav2_common: it fills in values of a parameter file."""

RESOLVES = regex(r"RewrittenYaml\(|nav2_bringup(?s:.*)\bparams_file\b")
"""What reads a whole parameter file by PyYAML, and writes it anew."""


def is_written_out(name: str, launch_texts: Iterable[str]) -> bool:
    """Return whether one of some launch files has a parameter file of a name written anew, with aliases resolved."""
    return any(name in text and RESOLVES.search(text) is not None for text in launch_texts)


def is_replaced(parameter: str, launch_texts: Iterable[str]) -> bool:
    """Return whether one of some launch files may give a parameter another value as it writes the file anew."""
    named = re.compile(rf"[\"'.]{re.escape(parameter)}[\"']")
    return any(named.search(text) for text in launch_texts if REWRITES in text)
