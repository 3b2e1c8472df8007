"""Interfaces that CMake generates: the calls of rosidl_generate_interfaces()."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...languages.cmake.evaluated_command import EvaluatedCommand, flags_and_values, path_in_package
from ...languages.cmake.list_text import as_value
from ...languages.cmake.values import Word
from ...light_dataclasses import dataclass


@dataclass(frozen=True)
class InterfaceTarget:
    """`rosidl_generate_interfaces(target files… DEPENDENCIES packages…)`"""

    target: Word
    files: tuple[Word, ...]
    """`msg/Name.msg`, relative to the folder of the call; an absolute one is `base:msg/Name.msg`."""
    dependencies: tuple[Word, ...]
    skip_install: bool
    call: EvaluatedCommand

    def path_of(self, word: Word) -> str | None:
        """Return the path of a listed file, relative to the package; None where it is elsewhere or unknown.

        An absolute one has a `:` where its own part begins.
        """
        text = word.text
        if text.startswith("/") and ":" in text:
            base, _, own = text.rpartition(":")
            text = f"{base}/{own}"
        return path_in_package(text, self.call.folder) if word.is_known else None


def interface_targets_of(calls: Iterable[EvaluatedCommand]) -> Iterator[InterfaceTarget]:
    """Yield the interface targets of some calls, in order."""
    flags = ("ADD_LINTER_TESTS", "SKIP_INSTALL", "SKIP_GROUP_MEMBERSHIP_CHECK")
    for call in calls:
        if call.name == "rosidl_generate_interfaces" and call.words:
            words = as_value(call.words[1:])  # a macro: what is quoted is split at `;` once more
            used_flags, values, files = flags_and_values(words, flags, ("LIBRARY_NAME",), ("DEPENDENCIES",))
            needs = tuple(values.get("DEPENDENCIES", []))
            yield InterfaceTarget(call.words[0], tuple(files), needs, "SKIP_INSTALL" in used_flags, call)


def generated_files(targets: Iterable[InterfaceTarget]) -> dict[str, bool]:
    """Return the interface files of the package that are generated, by path: whether that is certain."""
    found: dict[str, bool] = {}
    for target in targets:
        for word in target.files:
            if (path := target.path_of(word)) is not None:
                found[path] = found.get(path, False) or not (word.maybe or target.call.maybe)
    return found
