"""CMK002 old-cmake-minimum."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...edits.cmake_commands import literal_span
from ...example import CMAKE, Example
from ...finding import Edit, Fix, Hit, Safety, Severity
from ...package.cmake.cmake_package import CMakeForTargets
from ...ros.distros import Targets
from ...rule import rule

WANTED = "3.10"
VERSION = re.compile(r"(?:[\d.]+?\.\.\.)?(\d{1,9})\.(\d{1,9})(?:\.\d+)*")


@rule(
    "CMK002",
    "old-cmake-minimum",
    over=CMakeForTargets,
    severity=Severity.INFO,
    levels={
        Severity.WARNING: "a named target has CMake 4, which warns; or the version is below 3.5",
        Severity.ERROR: "the version is below 3.5 and a named target has CMake 4, which refuses it",
    },
    examples=(
        Example(
            bad={"CMakeLists.txt": CMAKE.replace("3.20", "«3.5»")},
            good={"CMakeLists.txt": CMAKE.replace("3.20", "3.10")},
            on="ament_cmake",
            fix=Safety.SAFE,
        ),
        Example(
            bad={"CMakeLists.txt": CMAKE.replace("3.20", "«2.8.3»")},
            good={"CMakeLists.txt": CMAKE.replace("3.20", "3.10")},
            on="ament_cmake",
            fix=Safety.SAFE,
            targets=("lyrical",),
        ),
    ),
)
def old_cmake_minimum(checked: CMakeForTargets) -> Iterator[Hit]:
    """
    ## What it does
    Finds `cmake_minimum_required()` with a version, or an upper end of a range, below 3.10.

    ## Why is this bad?
    CMake 4, which Lyrical and later have, prints a deprecation warning for each below 3.10 and stops at one below 3.5.
    3.10 is there on every supported distribution.
    """
    package = checked.package
    if package.facts.build_type == "catkin":
        return
    seen = set()
    for call in package.cmake.named("cmake_minimum_required"):
        word = call.words[1] if call.texts[:1] == ("VERSION",) and len(call.words) > 1 else None
        match = VERSION.fullmatch(word.text) if word else None
        if word is None or match is None or (call.path, word.span) in seen:
            continue
        seen.add((call.path, word.span))
        version = (int(match[1]), int(match[2]))
        if version < (3, 10):
            span = literal_span(package.cmake.file(word.path).source, word.span, word.text)
            fix = Fix(f"ask for CMake {WANTED}", (Edit(word.path, span, WANTED),)) if span else None
            yield Hit(word.path, word.span, message(word.text, version), level(version, checked.targets), fix=fix)


def level(version: tuple[int, int], targets: Targets) -> Severity:
    meets_cmake_4 = targets.named(lambda distro: distro.cmake >= (4,))
    ladder = (Severity.INFO, Severity.WARNING, Severity.ERROR)
    return ladder[meets_cmake_4 + (version < (3, 5))]


def message(text: str, version: tuple[int, int]) -> str:
    does = (
        "stops: compatibility with CMake < 3.5 has been"
        if version < (3, 5)
        else "warns: compatibility with CMake < 3.10 will be"
    )
    start = f"`cmake_minimum_required(VERSION {text})`: CMake 4 (Lyrical and later)"
    return f"{start} {does} removed; write {WANTED}, which every supported distribution has"
