"""Arguments that a command of CMake or ament refuses, or takes for something else than is intended."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.values import UNKNOWN, Word
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.cmake.install_keywords import ARTIFACTS
from .linker_runs import runs_linker
from .stray_arguments import OF_ALL, late_options, stray_argument

SCOPED = frozenset({
    "target_include_directories", "target_compile_definitions", "target_compile_options", "target_compile_features",
    "target_sources", "target_link_options", "target_link_directories", "target_precompile_headers",
})  # fmt: skip
"""Commands of CMake that want PUBLIC, PRIVATE or INTERFACE before their items."""
BEFORE_SCOPE = frozenset({"SYSTEM", "BEFORE", "AFTER"})
SCOPES = frozenset({"PUBLIC", "PRIVATE", "INTERFACE", "REUSE_FROM"})
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
NOT_LINKED = frozenset({"SHARED", "STATIC", "MODULE", "REQUIRED", "COMPONENTS"})
"""Keywords of add_library() and find_package(), which target_link_libraries() links."""
OPTIONS = ("add_compile_options", "target_compile_options", "add_definitions")
"""Commands whose arguments the compiler gets as they are."""
OF_MSVC = "/D"
"""How Microsoft's compiler writes `-D`, perhaps with a blank behind it."""
WHOLE = ("-W", "-O", "-f", "-std", "-g", "-m", "-D", "-p")
"""How options begin that have their value in them."""
DEFINITION = regex(r"[A-Z_][A-Z0-9]*_[A-Z0-9_]*(=\w*)?|[A-Z_][A-Z0-9_]+=\w*")
COUNTS = {
    "pluginlib_export_plugin_description_file": (2, "the package of the base class and the description's path"),
    "generate_parameter_library": (2, "the library's name and the YAML file"),
    "rosidl_get_typesupport_target": (3, "a variable, the interface target and a typesupport"),
}
"""How many arguments a command wants at least, and which."""

STOPS = "the linker stops"
LONGEST = 60
"""Characters of an argument that a message shows."""


@dataclass(frozen=True)
class RefusedArgument:
    call: EvaluatedCommand
    word: Word | None
    """The argument at fault; None where one lacks."""
    message: str
    is_idle: bool = False
    """Whether nothing fails as the package is built by default."""
    others: tuple[Word, ...] = ()
    """More words of the call with the same fault."""
    is_linked: bool = False
    """Whether a build with `--symlink-install` takes the words as they are intended."""


def refused_calls(cmake: CMake) -> Iterator[RefusedArgument]:
    """Yield each place once; nothing for commands that the package defines itself."""
    seen: set[tuple[str, int]] = set()
    for call in cmake.calls:
        place = (call.path, call.command.span.start)
        if place in seen or call.name in cmake.functions:
            continue
        seen.add(place)
        yield from unscoped(call)
        yield from without_destination(call)
        yield from misplaced_words(cmake, call)
        yield from late_keywords(cmake, call)
        yield from linked_keywords(cmake, call)
        yield from too_few(call)
        yield from without_sign(call)


def unscoped(call: EvaluatedCommand) -> Iterator[RefusedArgument]:
    if call.name not in SCOPED or not call.words or UNKNOWN in call.texts[0]:
        return
    first = next((word for word in call.words[1:] if word.text not in BEFORE_SCOPE), None)
    if first is not None and first.text not in SCOPES and UNKNOWN not in first.text:
        why = f'CMake stops with "{call.name} called with invalid arguments"'
        message = f"`{call.name}` has no `PUBLIC`, `PRIVATE` or `INTERFACE` before its items: {why}; write `PRIVATE`"
        yield RefusedArgument(call, first, message)


def without_destination(call: EvaluatedCommand) -> Iterator[RefusedArgument]:
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
    """Yield one for all of a call: somebody took the form of install() for one that knows them."""
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
    """Yield the keywords of other forms of install(), or else what stands where no argument belongs."""
    foreign = list(foreign_keywords(cmake, call))
    yield from foreign
    if not foreign and (stray := stray_argument(call)):
        word, keyword = stray
        start = f"`{word.text}` stands behind what belongs to `{keyword}` in `install({call.texts[0]} …)`"
        why = f'CMake stops with "install {call.texts[0]} given unknown argument"'
        place = f"`{keyword}`" if word.text in OF_ALL else "the first keyword"
        yield RefusedArgument(call, word, f"{start}: {why}; write it before {place}")


def late_keywords(cmake: CMake, call: EvaluatedCommand) -> Iterator[RefusedArgument]:
    for word in late_options(call):
        if not cmake.package_files.is_there(word.text):
            start = f"`{word.text}` stands behind a source in `{call.name}`"
            why = 'CMake takes it for one more, and stops with "Cannot find source file"'
            yield RefusedArgument(call, word, f"{start}: {why}; write it before the sources")


def linked_keywords(cmake: CMake, call: EvaluatedCommand) -> Iterator[RefusedArgument]:
    for word in call.words[1:] if call.name == "target_link_libraries" else ():
        if word.text.strip() and word.text != word.text.strip():
            why = 'CMake stops with "has leading or trailing whitespace"'
            message = (
                f"blanks stand around what is linked here: {why}; separate names with `;`, and leave out the quotes"
            )
            yield RefusedArgument(call, word, message)
        if word.text in NOT_LINKED and not word.quoted and cmake.target(word.text) is None:
            start = f"`{word.text}` is no keyword of `target_link_libraries`: it links `-l{word.text}`"
            is_idle = not runs_linker(cmake, call.texts[0])
            why = "no linker runs for a static library, but one stops where it is shared" if is_idle else STOPS
            yield RefusedArgument(call, word, f"{start}, and {why}; remove the word", is_idle)


def too_few(call: EvaluatedCommand) -> Iterator[RefusedArgument]:
    if call.name in COUNTS and not any(UNKNOWN in text for text in call.texts):
        count, which = COUNTS[call.name]
        if len(call.words) < count:
            yield RefusedArgument(call, None, f"`{call.name}` wants {which}: CMake stops; name them all")


def without_sign(call: EvaluatedCommand) -> Iterator[RefusedArgument]:
    """Yield definitions among options that lack their `-D`, but for values of the flag before them."""
    before = ""
    for word in call.words[call.name.startswith("target_") :] if call.name in OPTIONS else ():
        is_value = (before.startswith("-") and not before.startswith(WHOLE)) or before in ("-D", "-mllvm", OF_MSVC)
        before = word.text
        if word.is_known and not is_value and word.text not in SCOPES and DEFINITION.fullmatch(word.text):
            start = f"`{word.text}` is a definition without its `-D`"
            todo = f"write `-D{word.text}`"
            yield RefusedArgument(call, word, f"{start}: the compiler takes it for a file, and the build stops; {todo}")
