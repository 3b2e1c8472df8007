"""A message in brief: what is wrong, and what to do; what happens because of it is left out."""

from __future__ import annotations

import re

from ..finding import Finding
from ..lazy_regex import regex

CLAUSE = regex(r"`[^`\n]*`|\"[^\"\n]*\"|(?P<end>[:;] )|.", re.DOTALL)


def clauses(message: str) -> list[str]:
    """Return the parts of a message between colons and semicolons that are not in code or in quotes."""
    ends = [(found.start(), found.end()) for found in CLAUSE.finditer(message) if found["end"]]
    starts = [0, *(end for _, end in ends)]
    return [message[start:end] for start, end in zip(starts, [*(at for at, _ in ends), len(message)], strict=True)]


def without_advice(finding: Finding) -> str:
    """Return the message without its last clause, where that is what the fix is called."""
    title = lowered(finding.fix.title) if finding.fix else ""
    tail = f"; {title}"
    return finding.message[: -len(tail)] if title and finding.message.endswith(tail) else finding.message


def short_message(finding: Finding) -> str:
    """Return what is wrong and, where no fix says it, what to do; the whole message where both can't be separated."""
    parts = clauses(finding.message)
    if finding.fix:
        return parts[0]
    has_advice = len(parts) > 2 and f"; {parts[-1]}" in finding.message
    return f"{parts[0]}; {parts[-1]}" if has_advice else finding.message


def lowered(title: str) -> str:
    """Return the title of a fix as it stands inside of a sentence."""
    return title[:1].lower() + title[1:]
