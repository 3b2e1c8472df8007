"""CMK002 old-cmake-minimum."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.cmake.branches_for_ros1 import only_for_ros1
from ...checks.cmake.unknown_commands import UnknownCommands
from ...checks.repository.older_distribution import OlderDistribution
from ...edits.cmake_commands import literal_span
from ...example import CMAKE, Example
from ...finding import Edit, Fix, Hit, Related, Safety, Severity
from ...languages.cmake.values import Word
from ...lazy_regex import regex
from ...package.cmake.cmake_package import CMakeForTargets
from ...package.cmake.cmake_project import CMake
from ...ros.distros import Targets
from ...rule import rule
from ...source import Span

MINIMUM, WANTED = "cmake_minimum_required", "3.10"
VERSION = regex(r"(?:[\d.]+?\.\.\.)?(\d{1,9})\.(\d{1,9})(?:\.\d+)*")


@rule(
    "CMK002",
    "old-cmake-minimum",
    over=CMakeForTargets,
    severity=Severity.INFO,
    levels={
        Severity.WARNING: "a named target has CMake 4, which warns; or the version is below 3.5, and the repository is "
        "not for distributions with CMake 3 alone",
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
    Where nothing calls it at all, it says so.

    ## Why is this bad?
    CMake 4, which Lyrical and later have, prints a deprecation warning for each below 3.10 and stops at one below 3.5.
    3.10 is there on every supported distribution.

    ## When it is quiet
    In packages of catkin, in a branch for catkin next to one for ament, and where the version
    can't be evaluated. A range (`3.5...3.27`) counts by its upper end. All places of a package are one finding, at the
    oldest version. It is an info where all distributions that the pages, scripts and workflows of the repository name
    are older than Lyrical.
    """
    if checked.package.facts.build_type == "catkin":
        return
    if has_none(checked.package.cmake):
        yield without_minimum(checked.package.cmake)
    found = sorted(old_minimums(checked.package.cmake), key=lambda old: old[1])
    if not found:
        return
    cmake = checked.package.cmake
    (word, version), *others = found
    spans = {old: literal_span(cmake.file(old.path).source, old.span, old.text) for old, _ in found}
    edits = tuple(Edit(old.path, span, WANTED) for old, span in spans.items() if span)
    fix = Fix(f"ask for CMake {WANTED}", edits) if edits else None
    related = tuple(Related(old.path, old.span, f"and version {old.text} here") for old, _ in others)
    level = severity(version, checked.targets)
    if level is Severity.WARNING and OlderDistribution(cmake.package_files, checked.targets).is_before_lyrical:
        level = Severity.INFO
    yield Hit(word.path, word.span, message(word.text, version), level, related=related, fix=fix)


def has_none(cmake: CMake) -> bool:
    """Return whether no file that is read calls it, or nearly so, and none may do so that can't be read."""
    commands = (command for file in cmake.files for command in file.syntax.commands)
    is_called = any(command.name == MINIMUM for command in commands)
    is_known = cmake.is_complete and cmake.ends_a_package and not cmake.reads_unknown_files
    return is_known and not is_called and all(near != MINIMUM for _, near in UnknownCommands(cmake).all())


def without_minimum(cmake: CMake) -> Hit:
    start = f"CMakeLists.txt never calls `{MINIMUM}()`: CMake warns, and does all as its oldest versions did"
    message = f"{start}; begin with `{MINIMUM}(VERSION {WANTED})`"
    return Hit(cmake.root.path, cmake.root.source.line_span(1), message)


def old_minimums(cmake: CMake) -> Iterator[tuple[Word, tuple[int, int]]]:
    """Yield the versions below 3.10, each place once."""
    seen: set[tuple[str, Span]] = set()
    of_ros1 = only_for_ros1(cmake)
    for call in cmake.named(MINIMUM):
        if id(call.command) in of_ros1:
            continue
        word = call.words[1] if call.texts[:1] == ("VERSION",) and len(call.words) > 1 else None
        match = VERSION.fullmatch(word.text) if word else None
        if word is None or match is None or (word.path, word.span) in seen:
            continue
        seen.add((word.path, word.span))
        version = (int(match[1]), int(match[2]))
        if version < (3, 10):
            yield word, version


def severity(version: tuple[int, int], targets: Targets) -> Severity:
    meets_cmake_4 = targets.named(lambda distro: distro.cmake >= (4,))
    ladder = (Severity.INFO, Severity.WARNING, Severity.ERROR)
    return ladder[meets_cmake_4 + (version < (3, 5))]


def message(text: str, version: tuple[int, int]) -> str:
    does = "stops" if version < (3, 5) else "warns that compatibility with CMake < 3.10 will be removed"
    start = f"`cmake_minimum_required(VERSION {text})`: CMake 4 (Lyrical and later)"
    return f"{start} {does}; write {WANTED}, which every supported distribution has"
