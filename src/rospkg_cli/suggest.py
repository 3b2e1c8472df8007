"""Suggest the one name that is similar to a misspelt one."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from typing import ClassVar

from .lazy_regex import regex

LONGEST = 200
"""Characters; a longer word is not a misspelt name, and comparing it is slow."""

ALIKE = 0.75
"""The share of letters in common from which two names are alike."""

MARGIN = 0.05
"""Of that share, within which one name is as near as another."""

WORDS = regex(r"[^A-Za-z0-9]")
SLIP = 4
"""Letters of a word from which another one is a slip of it."""

MAX_STEPS = 15_000_000
"""Of some 40 ns each between two calls of `refill`: enough for 100 wrong names among 1,000 right ones."""

NAME_STEPS, LETTER_STEPS, MATCHER_STEPS, EDIT_STEPS = 20, 4, 800, 16
"""What it costs to look at a name, to count one of its letters, SequenceMatcher, and each letter pair of a distance."""


class Effort:
    """How much may still be compared: thousands of wrong names among thousands of right ones get no guess."""

    left = MAX_STEPS
    answers: ClassVar[dict[tuple[str, frozenset[str], int], str | None]] = {}
    """Of `nearest`, where effort sufficed: one wrong name is often written many times."""


def refill() -> None:
    """Start anew, as each rule does for each package."""
    Effort.left = MAX_STEPS
    Effort.answers.clear()


def distance(a: str, b: str, limit: int = 3) -> int:
    """Return the number of edits (insert, delete, replace, swap) between two words, or limit + 1."""
    if abs(len(a) - len(b)) > limit:
        return limit + 1
    before: list[int] = []
    row = list(range(len(b) + 1))
    for i, char in enumerate(a, 1):
        before, last, row = row, before, [i]
        for j, other in enumerate(b, 1):
            cost = min(row[j - 1] + 1, before[j] + 1, before[j - 1] + (char != other))
            if i > 1 and j > 1 and char == b[j - 2] and a[i - 2] == other:
                cost = min(cost, last[j - 2] + 1)
            row.append(cost)
        if min(row) > limit:
            return limit + 1
    return min(row[-1], limit + 1)


def near_names(word: str, names: Iterable[str], limit: int = 2) -> list[str]:
    """Return the names within a distance, nearest first; short words allow fewer edits; none when effort is used up."""
    limit = min(limit, max(1, len(word) // 3))
    if Effort.left < 0:
        return []
    names, letters = set(names) - {word}, Counter(word)
    Effort.left -= NAME_STEPS * len(names)
    found = sorted((distance(word, name, limit), name) for name in names if may_be_near(word, letters, name, limit))
    return [name for far, name in found if far <= limit] if Effort.left >= 0 else []


def nearest(word: str, names: Iterable[str], limit: int = 2) -> str | None:
    """Return the near name if there is exactly one, else one that shares most of its letters, else None."""
    if len(word) > LONGEST or Effort.left < 0:
        return None
    question = word, frozenset(names), limit
    if question not in Effort.answers:
        Effort.answers[question] = compare(*question)
    return Effort.answers[question]


def same_words(word: str, names: Iterable[str]) -> list[str]:
    """Return the names of the same words in another order: `fixed_resolution` for `resolution_fixed`."""
    words = sorted(word.split("_"))
    return [name for name in names if name != word and len(words) > 1 and sorted(name.split("_")) == words]


def is_misspelt(word: str, name: str) -> bool:
    """Return whether two names have the same words, but for some letters: `acme_test` is none of `acme_arm`."""
    words, others = word.split("_"), name.split("_")
    if len(words) != len(others):
        return word.replace("_", "") == name.replace("_", "")
    return all(own == other or near_names(own, [other]) for own, other in zip(words, others, strict=True))


def begins_alike(word: str, name: str) -> bool:
    """Return whether a word has a name's first letter, or lost or swapped it: another letter makes another name."""
    is_long = len(word) > SLIP
    return word[0] == name[0] or (is_long and (name[1:] == word or sorted(name[:2]) == sorted(word[:2])))


def slips(word: str, names: Iterable[str]) -> list[str]:
    """Return the names of which a word is a slip of the fingers: certain enough where not all names are known."""
    return [name for name in near_names(word, names, 1) if is_slip(word, name)]


def is_slip(word: str, name: str) -> bool:
    """Return whether two letters of a name are swapped, or one is lost or doubled, inside of a long word of it.

    Another letter makes another name, and so do a digit and an ending: `left` and `lift`, `arm_1`, `arms`.
    """
    words, others = (WORDS.split(each) for each in (word, name))
    different = [pair for pair in zip(words, others, strict=False) if pair[0] != pair[1]]
    if len(words) != len(others) or len(different) != 1:
        return False
    wrong, right = different[0]
    is_short, is_end = len(right) < SLIP or not wrong.isalpha(), wrong.startswith(right) or right.startswith(wrong)
    if is_short or is_end or distance(wrong, right, 1) > 1:
        return False
    return sorted(wrong) == sorted(right) or (len(wrong) != len(right) and wrong[0] == right[0])


def compare(word: str, names: frozenset[str], limit: int) -> str | None:
    """Return what `nearest` does, found out anew."""
    different = names - {word}
    found = near_names(word, different, limit)
    if len(found) == 1:
        return found[0]
    alike = [] if found else alike_names(word, different)
    return alike[0] if len(alike) == 1 else None


def alike_names(word: str, names: Iterable[str]) -> list[str]:
    """Return the names that share most of their letters with a word; none when effort is used up."""
    letters = Counter(word)
    alike = []
    for name in names:
        if is_alike(word, letters, name):
            alike.append(name)
        if Effort.left < 0:
            return []
    return alike


def letters_in_common(letters: Mapping[str, int], name: str) -> int:
    """Return how many letters a name shares with the counted ones, wherever they stand, and pay for counting."""
    Effort.left -= NAME_STEPS + LETTER_STEPS * len(letters)
    return sum([min(count, name.count(letter)) for letter, count in letters.items()])


def may_be_near(word: str, letters: Mapping[str, int], name: str, limit: int) -> bool:
    """Return whether a distance may be within a limit, and pay for finding out; an edit changes one letter."""
    if abs(len(word) - len(name)) > limit or Effort.left < 0:
        return False
    if max(len(word), len(name)) - letters_in_common(letters, name) > limit:
        return False
    Effort.left -= EDIT_STEPS * len(word) * len(name)
    return Effort.left >= 0


def is_alike(word: str, letters: Mapping[str, int], name: str) -> bool:
    """Return whether two names share most of their letters; cheap bounds of what SequenceMatcher finds come first."""
    least = ALIKE * (len(word) + len(name))
    if 2 * min(len(word), len(name)) < least or 2 * letters_in_common(letters, name) < least:
        return False
    Effort.left -= MATCHER_STEPS + len(word) * len(name)
    if Effort.left < 0:
        return False
    from difflib import SequenceMatcher

    return SequenceMatcher(None, word, name).ratio() >= ALIKE


def as_near(word: str, near: str, names: Iterable[str]) -> list[str]:
    """Return the names that are about as near to a word as the nearest one, and this; one of few edits has no rival."""
    if near_names(word, [near]):
        return [near]
    from difflib import SequenceMatcher

    shares = {}
    for name in {near, *names} - {word}:
        Effort.left -= MATCHER_STEPS + len(word) * len(name)
        if Effort.left < 0:
            return [near]
        shares[name] = SequenceMatcher(None, word, name).ratio()
    return sorted(name for name, share in shares.items() if share >= shares[near] - MARGIN)


def did_you_mean(word: str, names: Iterable[str]) -> str:
    """Return ` (did you mean `x`?)`, or nothing."""
    found = nearest(word, names)
    return f" (did you mean `{found}`?)" if found else ""
