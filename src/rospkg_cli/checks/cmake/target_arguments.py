"""Arguments of the commands of targets that CMake or the compiler refuses: scopes, keywords, definitions (CMK123)."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.values import UNKNOWN
from ...lazy_regex import regex
from ...package.cmake.cmake_project import CMake
from .linker_runs import runs_linker
from .refused_argument import RefusedArgument
from .stray_arguments import late_options

SCOPED = frozenset({
    "target_include_directories", "target_compile_definitions", "target_compile_options", "target_compile_features",
    "target_sources", "target_link_options", "target_link_directories", "target_precompile_headers",
})  # fmt: skip
"""Commands of CMake that want PUBLIC, PRIVATE or INTERFACE before their items."""
BEFORE_SCOPE = frozenset({"SYSTEM", "BEFORE", "AFTER"})
SCOPES = frozenset({"PUBLIC", "PRIVATE", "INTERFACE", "REUSE_FROM"})
NOT_LINKED = frozenset({"SHARED", "STATIC", "MODULE", "REQUIRED", "COMPONENTS"})
"""Keywords of add_library() and find_package(), which target_link_libraries() links."""
OPTIONS = ("add_compile_options", "target_compile_options", "add_definitions")
"""Commands whose arguments the compiler gets as they are."""
OF_MSVC = "/D"
"""How Microsoft's compiler writes `-D`, perhaps with a blank behind it."""
WHOLE = ("-W", "-O", "-f", "-std", "-g", "-m", "-D", "-p")
"""How options begin that have their value in them."""
DEFINITION = regex(r"[A-Z_][A-Z0-9]*_[A-Z0-9_]*(=\w*)?|[A-Z_][A-Z0-9_]+=\w*")
STOPS = "the linker stops"


def unscoped(call: EvaluatedCommand) -> Iterator[RefusedArgument]:
    """Yield the first item of a call that lacks PUBLIC, PRIVATE or INTERFACE before it."""
    if call.name not in SCOPED or not call.words or UNKNOWN in call.texts[0]:
        return
    first = next((word for word in call.words[1:] if word.text not in BEFORE_SCOPE), None)
    if first is not None and first.text not in SCOPES and UNKNOWN not in first.text:
        why = f'CMake stops with "{call.name} called with invalid arguments"'
        message = f"`{call.name}` has no `PUBLIC`, `PRIVATE` or `INTERFACE` before its items: {why}; write `PRIVATE`"
        yield RefusedArgument(call, first, message)


def late_keywords(cmake: CMake, call: EvaluatedCommand) -> Iterator[RefusedArgument]:
    """Yield options such as SHARED behind the sources of a target."""
    for word in late_options(call):
        if not cmake.package_files.is_there(word.text):
            start = f"`{word.text}` stands behind a source in `{call.name}`"
            why = 'CMake takes it for one more, and stops with "Cannot find source file"'
            yield RefusedArgument(call, word, f"{start}: {why}; write it before the sources")


def linked_keywords(cmake: CMake, call: EvaluatedCommand) -> Iterator[RefusedArgument]:
    """Yield what `target_link_libraries()` links though it is a keyword, or has blanks around it."""
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
