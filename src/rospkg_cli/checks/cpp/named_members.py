"""What C++ may name of messages, at a quick look: whether a text is worth that its variables are followed."""

from __future__ import annotations

from collections.abc import Iterator

from ...lazy_regex import regex

KINDS_WITHIN = ("::msg::", "::srv::", "::action::")
BEHIND = regex(
    r"::(msg|srv|action)::([A-Z]\w*)(?:::(Request|Response|Goal|Result|Feedback))?(?:::\w+Ptr)?"
    r"(?:\s+const)?(?:\s*>)?(?:\s+const)?[\s&]*([A-Za-z_]\w*)?"
)
BEFORE = regex(r"auto\s+(\w+)\s*=\s*(?:std::make_\w+<\s*(?:const\s+)?)?(?:::)?\Z")
MOST_BEFORE = 120
"""Characters before a type that are looked at."""
CHAIN = regex(r"[A-Za-z_][\w.]*")


def named_members(text: str) -> Iterator[tuple[str, tuple[str, ...]]]:
    """Yield messages with the members that a text may name of them: a quick look that finds more than there is."""
    found: dict[str, set[str]] = {}
    for name, message in named_variables(text):
        found.setdefault(name, set()).add(message)
    for name, message in ((name, *messages) for name, messages in found.items() if len(messages) == 1):
        for access in (".", "->"):
            start = name + access
            at = text.find(start)
            while at >= 0:
                chain = CHAIN.match(text, at + len(start))
                if chain is not None and not (text[at - 1].isalnum() or text[at - 1] == "_"):
                    names = tuple(filter(None, chain[0].split(".")))
                    yield message, names[:-1] if text.startswith("(", chain.end()) else names
                at = text.find(start, at + 1)


def named_variables(text: str) -> Iterator[tuple[str, str]]:
    """Yield what may be the name of a variable, with the message that stands beside it."""
    for within in KINDS_WITHIN:
        at = text.find(within)
        while at >= 0:
            start = at
            while start and (text[start - 1].isalnum() or text[start - 1] == "_"):
                start -= 1
            found = BEHIND.match(text, at)
            if found is not None and start < at:
                kind, base, part, name = found.groups()
                message = f"{text[start:at]}/{kind}/{base}{f'_{part}' if part else ''}"
                made = BEFORE.search(text[max(0, start - MOST_BEFORE) : start])
                yield from ((each, message) for each in (name, made[1] if made else None) if each)
            at = text.find(within, at + 1)
