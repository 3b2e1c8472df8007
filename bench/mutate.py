"""Small, reproducible damage to a text: what people do to interface files, parameter files and urdf."""

from __future__ import annotations

import random
from collections.abc import Sequence


def mutate(text: str, words: Sequence[str], chance: random.Random) -> str:
    """Return the text with one to three small changes: characters and lines lost, swapped, doubled, words put in."""
    for _ in range(chance.choice((1, 1, 1, 2, 3))):
        text = chance.choice((drop_char, put_word, double_line, drop_line, swap_words, put_word))(text, words, chance)
    return text


def drop_char(text: str, words: Sequence[str], chance: random.Random) -> str:
    at = chance.randrange(len(text) + 1)
    return text[:at] + text[at + 1 :]


def put_word(text: str, words: Sequence[str], chance: random.Random) -> str:
    at = chance.randrange(len(text) + 1)
    if chance.random() < 0.6:  # at a place where words begin or end
        edges = [i for i in range(1, len(text)) if text[i - 1].isspace() != text[i].isspace()]
        at = chance.choice(edges) if edges else at
    return text[:at] + chance.choice(words) + text[at:]


def double_line(text: str, words: Sequence[str], chance: random.Random) -> str:
    lines = text.split("\n")
    lines.insert(chance.randrange(len(lines) + 1), chance.choice(lines))
    return "\n".join(lines)


def drop_line(text: str, words: Sequence[str], chance: random.Random) -> str:
    lines = text.split("\n")
    del lines[chance.randrange(len(lines))]
    return "\n".join(lines)


def swap_words(text: str, words: Sequence[str], chance: random.Random) -> str:
    parts = text.split(" ")
    a, b = chance.randrange(len(parts)), chance.randrange(len(parts))
    parts[a], parts[b] = parts[b], parts[a]
    return " ".join(parts)
