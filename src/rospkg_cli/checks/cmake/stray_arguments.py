"""Arguments that stand where they do not belong, and at which CMake stops (3.10 to 4.2): of install(), of targets."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.targets import LIBRARY_TYPES
from ...languages.cmake.values import UNKNOWN, Word
from ...package.cmake.install_keywords import ARTIFACTS, OPTIONS, TAKE_A_VALUE, intended_keywords

FORMS = frozenset({"TARGETS", "FILES", "PROGRAMS"})
"""Whose own keyword may stand again, before more of them; another `DIRECTORY` is reported with the foreign keywords."""
ALONE = frozenset({
    "OPTIONAL", "EXCLUDE_FROM_ALL", "NAMELINK_ONLY", "NAMELINK_SKIP", "USE_SOURCE_PERMISSIONS", "MESSAGE_NEVER",
    "FILES_MATCHING", *ARTIFACTS,
})  # fmt: skip
"""Keywords behind which another keyword stands, or nothing."""
OF_ALL = frozenset({"EXPORT", "TARGETS"})
"""What `install(TARGETS)` takes before the parts of ARCHIVE, LIBRARY and the like alone."""
UNCLEAR = frozenset({"FILE_SET", "CXX_MODULES_BMI", "RUNTIME_DEPENDENCIES", "RUNTIME_DEPENDENCY_SET"})
"""Newer keywords with rules of their own."""
OF_TARGETS = {
    "add_library": frozenset({*LIBRARY_TYPES, "IMPORTED", "GLOBAL", "EXCLUDE_FROM_ALL"}),
    "add_executable": frozenset({"WIN32", "MACOSX_BUNDLE", "IMPORTED", "GLOBAL", "ALIAS", "EXCLUDE_FROM_ALL"}),
}
"""The options of a target, which stand before its sources."""


def late_options(call: EvaluatedCommand) -> Iterator[Word]:
    """Yield the options of a target behind its sources, where one is certain: CMake takes them for sources."""
    options, has_source = OF_TARGETS.get(call.name, frozenset()), False
    for word in call.words[1:] if options else ():
        if has_source and word.text in options:
            yield word
        has_source |= word.is_known and word.text not in options


def stray_argument(call: EvaluatedCommand) -> tuple[Word, str] | None:
    """Return the first argument that CMake refuses for its place, and the keyword behind which it stands.

    None where there is none, and where an argument is unknown: it may be nothing, or a keyword.
    """
    form = call.texts[0] if call.name == "install" and call.words else ""
    if form not in FORMS or call.may_have_more or UNCLEAR.intersection(call.texts):
        return None
    return next(stray_words(call, form), None)


def stray_words(call: EvaluatedCommand, form: str) -> Iterator[tuple[Word, str]]:
    keyword, room, part = form, -1, ""
    for word, intended in intended_keywords(call):
        text = intended or word.text
        is_part = form == "TARGETS" and text in ARTIFACTS
        if is_part or text == form or text in OPTIONS:
            if part and text in OF_ALL:
                yield word, part
            part = text if is_part else part
            part = "" if part == "INCLUDES" else part
            keyword, room = text, 0 if text in ALONE else 1 if text in TAKE_A_VALUE and keyword != "INCLUDES" else -1
        elif room == 0 and UNKNOWN not in text:
            yield word, keyword
        else:
            room = 0 if room == 1 else room
