"""Members of messages that C++ may name, found quickly: whether its variables need to be followed at all."""

from __future__ import annotations

from collections.abc import Iterator

from ...lazy_regex import regex
from ...package.interfaces.generated_types import generated_types
from ...source import Source

BEHIND = regex(
    r"::(msg|srv|action)::([A-Z]\w*)(?:::(Request|Response|Goal|Result|Feedback))?(?:::\w+Ptr)?"
    r"(?:\s+const)?(?:\s*>)?(?:\s+const)?[\s&]*([A-Za-z_]\w*)?"
)
BEFORE = regex(r"auto\s+(\w+)\s*=\s*(?:std::make_\w+<\s*(?:const\s+)?)?(?:::)?\Z")
MOST_BEFORE = 120
"""Characters before a type that are looked at."""
CHAIN = regex(r"[A-Za-z_][\w.]*")


def named_members(source: Source) -> Iterator[tuple[frozenset[str], tuple[str, ...]]]:
    """Yield members that a text may name of one of some messages: a quick look that finds more than there is."""
    text = source.text
    found: dict[str, set[str]] = {}
    for name, message in named_variables(source):
        found.setdefault(name, set()).add(message)
    for name, messages in found.items():
        several = frozenset(messages)
        for access in (".", "->"):
            start = name + access
            at = text.find(start)
            while at >= 0:
                chain = CHAIN.match(text, at + len(start))
                if chain is not None and not (text[at - 1].isalnum() or text[at - 1] == "_"):
                    names = tuple(filter(None, chain[0].split(".")))
                    yield several, names[:-1] if text.startswith("(", chain.end()) else names
                at = text.find(start, at + 1)


def named_variables(source: Source) -> Iterator[tuple[str, str]]:
    """Yield what may be the name of a variable, with the message that stands next to it."""
    text = source.text
    for each in generated_types(source):
        found = BEHIND.match(text, each.behind_package)
        if found is not None and each.package:
            kind, base, part, name = found.groups()
            message = f"{each.package}/{kind}/{base}{f'_{part}' if part else ''}"
            made = BEFORE.search(text[max(0, each.start - MOST_BEFORE) : each.start])
            yield from ((variable, message) for variable in (name, made[1] if made else None) if variable)
