"""Arguments of `install(…)` that CMake refuses: no destination, keywords of other forms, stray words (CMK123)."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.values import UNKNOWN, Word
from ...package.cmake.cmake_project import CMake
from ...package.cmake.install_keywords import ARTIFACTS
from .refused_argument import RefusedArgument
from .stray_arguments import OF_ALL, stray_argument

KINDS = frozenset({"FILES", "PROGRAMS", "DIRECTORY"})
"""The forms of install() that want a destination."""
REPEATED = frozenset({"FILES", "PROGRAMS"})
"""Those of them that CMake reads once more where they are repeated: `FILES a FILES b`; another DIRECTORY is a path."""
FOREIGN = frozenset({*KINDS, "TARGETS", *(set(ARTIFACTS) - {"INCLUDES", "RESOURCE"})})
"""Keywords of the other forms of install()."""
UNLINKED = frozenset({
    "FILE_PERMISSIONS", "DIRECTORY_PERMISSIONS", "USE_SOURCE_PERMISSIONS", "PERMISSIONS", "CONFIGURATIONS", "COMPONENT",
    "FILES_MATCHING", "REGEX",
})  # fmt: skip
"""What ament leaves to CMake where it makes links."""
LONGEST = 60
"""Characters of an argument that a message shows."""


def without_destination(call: EvaluatedCommand) -> Iterator[RefusedArgument]:
    """Yield a call for files or folders that says nowhere where to install them."""
    if call.name != "install" or not call.words or call.texts[0] not in KINDS:
        return
    texts = call.texts[:-1] if lacks_value(call) else call.texts
    if call.may_have_more or any(UNKNOWN in text or "DEST" in text or text == "TYPE" for text in texts):
        return
    kind = call.texts[0]
    shown = " ".join(argument.text for argument in call.command.arguments[1:2])
    start = f"`install({kind} {shown} …)`" if 0 < len(shown) <= LONGEST else f"`install({kind} …)`"
    what = "nothing after `DESTINATION`" if lacks_value(call) else "no `DESTINATION`"
    message = f"{start} has {what}: CMake stops; write one, such as `share/${{PROJECT_NAME}}`"
    yield RefusedArgument(call, None, message)


def lacks_value(call: EvaluatedCommand) -> bool:
    """Return whether a call ends with the keyword itself, and not with what a variable holds."""
    *_, last = call.command.arguments
    return last.text == "DESTINATION" and call.texts[-1:] == (last.text,)


def foreign_keywords(cmake: CMake, call: EvaluatedCommand) -> Iterator[RefusedArgument]:
    """Yield one for all of a call: the form of install() that is used does not have these keywords."""
    if call.name != "install" or not call.words or call.texts[0] not in KINDS:
        return
    before, found = "", list[Word]()
    for word in call.words[1:]:
        is_value = before in ("PATTERN", "REGEX", "DESTINATION", "COMPONENT", "RENAME", "CONFIGURATIONS", "TYPE")
        is_value = is_value or (word.text == call.texts[0] and word.text in REPEATED)
        before = word.text
        if word.text in FOREIGN and not is_value and not word.quoted and not cmake.package_files.is_there(word.text):
            found.append(word)
    if found:
        first, *others = found
        is_linked = {call.texts[0], *(word.text for word in found)} == {"DIRECTORY"} and links(cmake, call)
        start = f"`{first.text}` is no keyword in `install({call.texts[0]} …)`"
        stops = f"{'a build without `--symlink-install`' if is_linked else 'the build'} stops when it installs"
        message = f"{start}: CMake takes it for a path, and {stops}; remove the word"
        yield RefusedArgument(call, first, message, others=tuple(others), is_linked=is_linked)


def links(cmake: CMake, call: EvaluatedCommand) -> bool:
    """Return whether a build with `--symlink-install` has ament install a folder, which parses its words otherwise."""
    return UNLINKED.isdisjoint(call.texts) and any(found.name.startswith("ament_cmake") for found in cmake.packages)


def misplaced_words(cmake: CMake, call: EvaluatedCommand) -> Iterator[RefusedArgument]:
    """Yield the keywords of other forms of install(), or else an argument where none belongs."""
    foreign = list(foreign_keywords(cmake, call))
    yield from foreign
    if not foreign and (stray := stray_argument(call)):
        word, keyword = stray
        start = f"`{word.text}` stands behind what belongs to `{keyword}` in `install({call.texts[0]} …)`"
        why = f'CMake stops with "install {call.texts[0]} given unknown argument"'
        place = f"`{keyword}`" if word.text in OF_ALL else "the first keyword"
        yield RefusedArgument(call, word, f"{start}: {why}; write it before {place}")
