"""Folders of the source tree that exported targets name to their users, which CMake refuses (CMK123)."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.cmake.evaluated_command import EvaluatedCommand, path_in_package
from ...languages.cmake.values import Word
from ...package.cmake.cmake_project import CMake
from .refused_argument import RefusedArgument

FOR_USERS = ("PUBLIC", "INTERFACE")
SCOPES = (*FOR_USERS, "PRIVATE")
WHY = 'CMake stops with "contains path … which is prefixed in the source directory"'


def source_includes(cmake: CMake) -> Iterator[RefusedArgument]:
    """Yield the first folder of each exported target that is not for the build alone."""
    exported = exported_targets(cmake)
    seen: set[str] = set()
    for call in cmake.named("target_include_directories"):
        target = call.texts[0] if call.words else ""
        if target not in exported or target in seen or call.maybe or call.testing or call.name in cmake.functions:
            continue
        word = next(for_users(call), None)
        if word is not None:
            seen.add(target)
            written = cmake.source_text(word).strip('"')
            place = path_in_package(word.text, call.folder)
            advice = f"write `$<BUILD_INTERFACE:${{CMAKE_CURRENT_SOURCE_DIR}}/{place}>` and `$<INSTALL_INTERFACE:…>`"
            message = f"`{target}` is exported and names `{written}` to its users: {WHY}; {advice}"
            yield RefusedArgument(call, word, message)


def for_users(call: EvaluatedCommand) -> Iterator[Word]:
    """Yield the folders of the package that a call names to those who link the target."""
    scope = ""
    for word in call.words[1:]:
        if word.text in SCOPES:
            scope = word.text
        elif scope in FOR_USERS and word.is_known and not word.maybe and path_in_package(word.text, call.folder):
            yield word


def exported_targets(cmake: CMake) -> frozenset[str]:
    """Return the targets of the sets that CMake writes into files for users."""
    sets = {text for call in cmake.exports if not call.maybe for text in call.texts}
    sets |= {word.text for rule in cmake.installs if rule.kind == "EXPORT" for word in rule.items}
    rules = [rule for rule in cmake.installs if rule.kind == "TARGETS" and rule.export and not rule.call.maybe]
    return frozenset(word.text for rule in rules if rule.export and rule.export.text in sets for word in rule.items)
