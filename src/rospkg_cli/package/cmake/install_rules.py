"""Install rules: what `install` and the commands of ament install where, one rule for each."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise, takewhile
from typing import Literal

from ...languages.cmake.call_stack import PYTHON
from ...languages.cmake.evaluated_command import EvaluatedCommand, by_keyword
from ...languages.cmake.values import PREFIX, UNKNOWN, Word
from ...lazy_regex import regex
from ...light_dataclasses import dataclass, replace
from ...suggest import near_names

Kind = Literal["TARGETS", "FILES", "PROGRAMS", "DIRECTORY", "CODE", "EXPORT"]

ARTIFACTS = ("ARCHIVE", "LIBRARY", "RUNTIME", "OBJECTS", "FRAMEWORK", "BUNDLE", "PRIVATE_HEADER", "PUBLIC_HEADER",
             "RESOURCE", "INCLUDES")  # fmt: skip
OPTIONS = ("EXPORT", "DESTINATION", "TYPE", "PERMISSIONS", "FILE_PERMISSIONS", "DIRECTORY_PERMISSIONS",
           "USE_SOURCE_PERMISSIONS", "CONFIGURATIONS", "COMPONENT", "NAMELINK_COMPONENT", "OPTIONAL",
           "EXCLUDE_FROM_ALL", "NAMELINK_ONLY", "NAMELINK_SKIP", "RENAME", "MESSAGE_NEVER", "FILES_MATCHING",
           "PATTERN", "REGEX", "FILE_SET", "CXX_MODULES_BMI", "RUNTIME_DEPENDENCIES",
           "RUNTIME_DEPENDENCY_SET")  # fmt: skip
TAKE_A_VALUE = frozenset(("EXPORT", "DESTINATION", "TYPE", "COMPONENT", "NAMELINK_COMPONENT", "RENAME", "PATTERN",
                          "REGEX", "FILE_SET", "RUNTIME_DEPENDENCY_SET", "NAMESPACE", "FILE"))  # fmt: skip
FORMS = ("TARGETS", "FILES", "PROGRAMS", "DIRECTORY", "CODE", "SCRIPT", "EXPORT", "IMPORTED_RUNTIME_ARTIFACTS",
         "RUNTIME_DEPENDENCY_SET", "EXPORT_ANDROID_MK", "PACKAGE_INFO", "SBOM")  # fmt: skip
"""The first word, which says what is installed: CMake stops at any other one, up to 4.2."""
SHORTEST, SHORT = 6, 9
"""Letters of a keyword that can be told from a name in capitals, and from which two may be wrong."""

TYPES = {"BIN": "bin", "SBIN": "sbin", "LIB": "lib", "INCLUDE": "include", "SYSCONF": "etc", "DATA": "share"}
"""Where `TYPE` puts files, by GNUInstallDirs."""

SITE = regex(r"\Alib/python3(?:\.\d+)?/(?:site|dist)-packages(?=/|\Z)")
"""Where modules go, with the version of Python written out: they are found on distributions with that Python alone."""

PACKAGE_KEYWORDS = ("VERSION", "PACKAGE_DIR", "SETUP_CFG", "DESTINATION", "SCRIPTS_DESTINATION")
"""Of ament_python_install_package: each takes one value."""


PERSONS = ("OWNER_", "GROUP_", "WORLD_")
"""How permissions begin."""


@dataclass(frozen=True, slots=True)
class Pattern:
    """`PATTERN "*.hpp"` or `REGEX …` of install(DIRECTORY)."""

    text: str
    is_regex: bool
    is_exclude: bool = False
    permissions: frozenset[str] = frozenset()
    """What the files that it fits get."""


@dataclass(frozen=True)
class InstallRule:
    kind: Kind
    items: tuple[Word, ...]
    destination: str | None
    """Relative to the prefix, absolute where it is written so; None where it is unknown."""
    call: EvaluatedCommand
    destination_word: Word | None = None
    destinations: Mapping[str, str | None] | None = None
    """Of targets: the destination of each kind of artifact."""
    rename: Word | None = None
    patterns: tuple[Pattern, ...] = ()
    matching: bool = False
    """Only files that fit a pattern are installed."""
    permissions: frozenset[str] = frozenset()
    """`USE_SOURCE_PERMISSIONS`, or what PERMISSIONS and FILE_PERMISSIONS name."""
    export: Word | None = None
    optional: bool = False


def plain_root(text: str) -> str:
    """Return a path with one slash at its root: `/${CMAKE_INSTALL_PREFIX}` names the prefix."""
    return "/" + text.lstrip("/") if text.startswith("//") else text


def below_prefix(text: str) -> str | None:
    """Return a destination relative to the prefix; None where it is unknown."""
    text = plain_root(text)
    if text.startswith(PREFIX):
        text = text[len(PREFIX) :].lstrip("/") or "."
    if UNKNOWN in text or "\1" in text or "$<" in text:
        return None
    return SITE.sub(PYTHON, posixpath.normpath(text)) if text else "."


def meant_form(call: EvaluatedCommand) -> str | None:
    """Return the form that the first word is a letter or two off, or writes in small letters; None for all others."""
    first = call.words[0] if call.words else None
    if first is None or not first.is_known or first.text in FORMS:
        return None
    form = first.text.upper()
    return form if form in FORMS else next(iter(near_names(form, FORMS, 2)), None)


def meant_keywords(call: EvaluatedCommand) -> Iterator[tuple[Word, str | None]]:
    """Yield the words after `install(form`, each with the keyword that it is a letter or two off; None for all others.

    The rule is read as it is meant: what is wrong is told at the word. A value, as in `DESTINATION INCLUDE`, is none.
    """
    kind = form_of(call)
    keywords = (*OPTIONS, *(ARTIFACTS if kind == "TARGETS" else ()))
    before = kind
    for word in call.words[1:]:
        yield word, None if word.quoted or before in TAKE_A_VALUE else meant_keyword(word.text, keywords)
        before = word.text


def form_of(call: EvaluatedCommand) -> str:
    return meant_form(call) or (call.texts[0] if call.words else "")


def meant_keyword(text: str, keywords: Sequence[str]) -> str | None:
    if len(text) < SHORTEST or not text.replace("_", "").isupper() or text in keywords:
        return None
    return next(iter(near_names(text, keywords, 1 if len(text) < SHORT else 2)), None)


def rules_of_install(call: EvaluatedCommand) -> Iterator[InstallRule]:
    """`install(…)` in all its forms."""
    kind = form_of(call)
    words = [replace(word, text=meant) if meant else word for word, meant in meant_keywords(call)]
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


def destination_of(words: Sequence[Word]) -> tuple[str | None, Word | None]:
    """Return the last one that is given, which counts, and its word."""
    given = {before.text: word for before, word in pairwise(words) if word.text not in OPTIONS}
    if word := given.get("DESTINATION"):
        return below_prefix(word.text), word
    return (TYPES.get(given["TYPE"].text) if "TYPE" in given else None), None


def patterns_in(words: Sequence[Word]) -> Iterator[Pattern]:
    for at, word in enumerate(words[:-1]):
        if word.text in ("PATTERN", "REGEX"):
            exclude = at + 2 < len(words) and words[at + 2].text == "EXCLUDE"
            given = takewhile(lambda text: text not in ("PATTERN", "REGEX"), (each.text for each in words[at + 2 :]))
            permissions = frozenset(text for text in given if text.startswith(PERSONS))
            yield Pattern(words[at + 1].text, word.text == "REGEX", exclude, permissions)
