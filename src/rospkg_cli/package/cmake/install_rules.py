"""Rules of `install(…)` in all its forms: TARGETS, FILES, PROGRAMS, DIRECTORY, CODE."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import takewhile
from typing import Literal

from ...languages.cmake.evaluated_command import EvaluatedCommand, by_keyword
from ...languages.cmake.values import UNKNOWN, Word
from ...light_dataclasses import replace
from .install_destinations import below_prefix, destination_of
from .install_keywords import ARTIFACTS, OPTIONS, form_of, intended_keywords
from .install_rule import InstallRule, Pattern

PERSONS = ("OWNER_", "GROUP_", "WORLD_")
"""The first words of permissions."""


def rules_of_install(call: EvaluatedCommand) -> Iterator[InstallRule]:
    """Yield the rule of one call of `install(…)`."""
    kind = form_of(call)
    words = [replace(word, text=keyword) if keyword else word for word, keyword in intended_keywords(call)]
    if kind == "TARGETS":
        yield targets_rule(call, words)
    elif kind in ("FILES", "PROGRAMS"):
        yield files_rule(call, "FILES" if kind == "FILES" else "PROGRAMS", words)
    elif kind == "DIRECTORY":
        yield directory_rule(call, words)
    elif kind in ("CODE", "SCRIPT", "RUNTIME_DEPENDENCY_SET", UNKNOWN, ""):
        yield InstallRule("CODE", tuple(words), None, call)


def targets_rule(call: EvaluatedCommand, words: Sequence[Word]) -> InstallRule:
    """Return the rule of `install(TARGETS …)`: each kind of artifact may go to its own place; the last one counts."""
    destinations: dict[str, str | None] = {}
    artifact, keyword = "", "items"
    items: list[Word] = []
    place: Word | None = None
    export: Word | None = None
    for word in words:
        text = word.text
        if text in ARTIFACTS:
            artifact, keyword = text, text
        elif text == "TARGETS":
            keyword = "items"
        elif text in OPTIONS:
            keyword = text
        elif keyword == "items":
            items.append(word)
        elif keyword == "EXPORT":
            export, keyword = word, ""
        elif keyword == "DESTINATION":
            if artifact == "INCLUDES":
                continue
            place = word if place is None or artifact in destinations else place
            destinations[artifact], keyword = below_prefix(word.text), ""
    return InstallRule(
        "TARGETS", tuple(items), destinations.get(""), call, place, destinations, export=export,
        optional="OPTIONAL" in call.texts,
    )  # fmt: skip


def files_rule(call: EvaluatedCommand, kind: Literal["FILES", "PROGRAMS"], words: Sequence[Word]) -> InstallRule:
    found = by_keyword(words, (*OPTIONS, kind))
    destination, word = destination_of(words)
    return InstallRule(
        kind, (*found[""], *found.get(kind, [])), destination, call, word,
        rename=next(iter(found.get("RENAME", [])), None),
        permissions=frozenset(w.text for w in found.get("PERMISSIONS", [])),
        optional="OPTIONAL" in found,
    )  # fmt: skip


def directory_rule(call: EvaluatedCommand, words: Sequence[Word]) -> InstallRule:
    found = by_keyword(words, OPTIONS)
    destination, word = destination_of(words)
    kept = {w.text for w in found.get("FILE_PERMISSIONS", [])}
    kept |= {"USE_SOURCE_PERMISSIONS"} & found.keys()
    return InstallRule(
        "DIRECTORY", tuple(found[""]), destination, call, word,
        patterns=tuple(patterns_in(words)), matching="FILES_MATCHING" in found, permissions=frozenset(kept),
        optional="OPTIONAL" in found,
    )  # fmt: skip


def patterns_in(words: Sequence[Word]) -> Iterator[Pattern]:
    """Yield `PATTERN …` and `REGEX …` of install(DIRECTORY)."""
    for at, word in enumerate(words[:-1]):
        if word.text in ("PATTERN", "REGEX"):
            exclude = at + 2 < len(words) and words[at + 2].text == "EXCLUDE"
            given = takewhile(lambda text: text not in ("PATTERN", "REGEX"), (each.text for each in words[at + 2 :]))
            permissions = frozenset(text for text in given if text.startswith(PERSONS))
            yield Pattern(words[at + 1].text, word.text == "REGEX", exclude, permissions)
