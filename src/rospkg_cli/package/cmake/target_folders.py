"""Folders of targets: which of them are for tests, examples or third parties."""

from __future__ import annotations

import posixpath

from ...languages.cmake.targets import Target

ASIDE = frozenset({"test", "tests", "benchmark", "benchmarks", "example", "examples", "third_party", "thirdparty"})
EXAMPLES = frozenset({"example", "examples"})


def folders_of(target: Target) -> set[str]:
    return {posixpath.join(target.call.folder, posixpath.dirname(word.text)) for word in target.sources}


def is_aside(target: Target) -> bool:
    return bool(parts_of(target) & ASIDE)


def parts_of(target: Target) -> set[str]:
    """Return the names of all folders that the target and its sources lie in."""
    found = {part for word in target.sources for part in word.text.split("/")[:-1]}
    return found | {*target.call.folder.split("/")}
