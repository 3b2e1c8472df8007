"""What the variables of a shell script hold, as far as it is written out."""

from __future__ import annotations

import re

from ...lazy_regex import regex

USED = regex(r"\$\{?([A-Za-z_]\w*)")


def with_values(text: str, script: str) -> str:
    """Return a part of a script and, behind it, what the lists and the loops of the script give its variables, and
    those that these hold.
    """
    found, seen = [text], set[str]()
    for part in found:
        new = set(USED.findall(part)) - seen
        seen |= new
        found.extend(value for name in sorted(new) for value in values_of(name, script))
    return " ".join(found)


def values_of(name: str, script: str) -> list[str]:
    """Return the quoted values and the arrays that are assigned to a variable, and what loops give it."""
    assigned = rf"(?:^|[\s;]){name}\+?=(?:\"([^\"]*)\"|'([^']*)'|\(([^)]*)\))"
    looped = rf"\bfor[ \t]+{name}[ \t]+in[ \t]+([^;\n]*)"
    return ["".join(found) for found in re.findall(f"(?m){assigned}|{looped}", script)]
