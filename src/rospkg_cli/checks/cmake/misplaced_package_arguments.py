"""Keywords, variables with libraries and imported targets, where commands of CMake take packages (CMK117)."""

from __future__ import annotations

from collections.abc import Iterator

from ...lazy_regex import regex
from ...package.cmake.cmake_project import CMake
from ...package.cmake.set_variables import SetVariables
from ...package.cmake.target_links import TargetLinks
from .mistyped_package import EXPORTED, HANDED, MistypedPackage

OF_PACKAGE = regex(r"\$\{(\w+?)_(LIBRARIES|LIBRARY|LIBS|TARGETS|INCLUDE_DIRS?)\}")
KEYWORDS = frozenset({"PUBLIC", "PRIVATE", "INTERFACE", "SYSTEM"})


def keywords(cmake: CMake) -> Iterator[MistypedPackage]:
    """Yield what `ament_target_dependencies` takes for a package: PRIVATE, and a keyword behind a package."""
    for call in cmake.named(HANDED):
        first = next((at for at, word in enumerate(call.words) if at and word.text not in KEYWORDS), len(call.words))
        for at, word in enumerate(call.words[1:], 1):
            is_misplaced = word.text in KEYWORDS and at > first and all(each.is_known for each in call.words[:at])
            if (word.text == "PRIVATE" or is_misplaced) and not call.maybe and not word.maybe:
                yield MistypedPackage(word, call, "keyword")
                break


def variables_of_libraries(cmake: CMake, found: frozenset[str]) -> Iterator[MistypedPackage]:
    """Yield variables with the libraries of a found package (`${OpenCV_LIBRARIES}`) that are exported as packages."""
    variables = SetVariables(cmake)
    for call in cmake.named(EXPORTED):
        for argument, words in call.by_argument() if not call.maybe else ():
            match = OF_PACKAGE.fullmatch(argument.text)
            if match is not None and words and not variables.may_be_set(f"{match[1]}_{match[2]}"):
                near = next((each for each in (match[1], match[1].lower()) if each in found), None)
                if near is not None:
                    yield MistypedPackage(words[0], call, "variable", near, argument.text, is_certain=False)


def imported_targets(cmake: CMake, found: frozenset[str]) -> Iterator[MistypedPackage]:
    """Yield the names of imported targets (`Eigen3::Eigen`) that `find_package` looks for."""
    for each in cmake.packages:
        package, colons, _ = each.name.partition("::")
        if colons and each.word.is_known and not each.word.maybe and not each.call.maybe:
            is_certain = "REQUIRED" in each.call.texts or (package not in found and is_linked(cmake, each.name))
            yield MistypedPackage(each.word, each.call, "imported", package, is_certain=is_certain)


def is_linked(cmake: CMake, target: str) -> bool:
    return any(link.word.text == target for link in TargetLinks(cmake).all)
