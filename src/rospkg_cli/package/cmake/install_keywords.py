"""Keywords of `install(…)`, and which one is intended by a word that is a letter or two off."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.values import Word
from ...suggest import near_names

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
"""Letters that a keyword needs so that a name in capitals may be a slip of it, and from which two may be wrong."""

PACKAGE_KEYWORDS = ("VERSION", "PACKAGE_DIR", "SETUP_CFG", "DESTINATION", "SCRIPTS_DESTINATION")
"""Of ament_python_install_package: each takes one value."""


def intended_form(call: EvaluatedCommand) -> str | None:
    """Return the form that the first word is a letter or two off, or writes in small letters; None for all others."""
    first = call.words[0] if call.words else None
    if first is None or not first.is_known or first.text in FORMS:
        return None
    form = first.text.upper()
    return form if form in FORMS else next(iter(near_names(form, FORMS, 2)), None)


def intended_keywords(call: EvaluatedCommand) -> Iterator[tuple[Word, str | None]]:
    """Yield the words after `install(form`, each with the keyword that it is a letter or two off; None for all others.

    Rules are read with the intended keywords; a check reports the wrong words. A value (`DESTINATION INCLUDE`) is none.
    """
    kind = form_of(call)
    keywords = (*OPTIONS, *(ARTIFACTS if kind == "TARGETS" else ()))
    before = kind
    for word in call.words[1:]:
        yield word, None if word.quoted or before in TAKE_A_VALUE else intended_keyword(word.text, keywords)
        before = word.text


def form_of(call: EvaluatedCommand) -> str:
    """Return the intended form of a call: `TARGETS`, `FILES`, …; "" where there is no word."""
    return intended_form(call) or (call.texts[0] if call.words else "")


def intended_keyword(text: str, keywords: Sequence[str]) -> str | None:
    """Return the keyword that a word in capitals is a letter or two off; None for all others."""
    if len(text) < SHORTEST or not text.replace("_", "").isupper() or text in keywords:
        return None
    return next(iter(near_names(text, keywords, 1 if len(text) < SHORT else 2)), None)
