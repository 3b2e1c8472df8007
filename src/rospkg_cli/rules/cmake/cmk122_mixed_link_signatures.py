"""CMK122 mixed-link-signatures."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.cmake.ament_target_dependencies import REMOVED
from ...checks.cmake.link_keywords import KEYWORDS
from ...checks.cmake.link_signatures import LinkSignatures, MixedLink
from ...example import CMAKE, Example, manifest
from ...finding import Edit, Fix, Hit, Related, Safety, Severity
from ...rule import rule
from ...source import Span

CORE = """\
find_package(rclcpp REQUIRED)
add_library(core SHARED src/core.cpp)
target_link_libraries(core PUBLIC rclcpp::rclcpp)
target_link_libraries(«core» m)
install(TARGETS core DESTINATION lib)
"""
TEST = """\
if(BUILD_TESTING)
  find_package(ament_cmake_gtest REQUIRED)
  ament_add_gtest(test_core test/test_core.cpp)
  target_link_libraries(«test_core» PRIVATE m)
endif()
"""
NEEDS = manifest("  <depend>rclcpp</depend>\n", "ament_cmake")
NEEDS_GTEST = manifest("  <test_depend>ament_cmake_gtest</test_depend>\n", "ament_cmake")


def cmake(lines: str) -> str:
    return CMAKE.replace("ament_package", lines + "ament_package")


@rule(
    "CMK122",
    "mixed-link-signatures",
    over=LinkSignatures,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "one of the calls is under a condition that can't be evaluated, or an `ament_auto_add_…`, "
        "which links in its own way",
        Severity.INFO: "one of them waits for a package that nothing looks for, or for a switch that nothing turns on",
    },
    examples=(
        Example(
            bad={"CMakeLists.txt": cmake(CORE), "package.xml": NEEDS, "src/core.cpp": "int core() {return 1;}\n"},
            good={"CMakeLists.txt": cmake(CORE.replace("(«core» ", "(core PUBLIC "))},
            on="ament_cmake",
            fix=Safety.SAFE,
        ),
        Example(
            bad={
                "CMakeLists.txt": cmake(TEST),
                "package.xml": NEEDS_GTEST,
                "test/test_core.cpp": "int core() {return 1;}\n",
            },
            good={"CMakeLists.txt": cmake(TEST.replace("«test_core» PRIVATE", "test_core"))},
            on="ament_cmake",
        ),
    ),
)
def mixed_link_signatures(signatures: LinkSignatures) -> Iterator[Hit]:
    """
    ## What it does
    Finds targets that one call links with a keyword (PUBLIC …) and another one without.
    `ament_target_dependencies()` and the commands that make tests (`ament_add_gtest()`) link without one, if none is
    given.

    ## Why is this bad?
    CMake stops: "All uses of target_link_libraries with a target must be either all-keyword or all-plain."

    ## When it is quiet
    In a branch for a package (`if(OpenMP_CXX_FOUND)`) that nothing here looks for it is an info: it is not taken. So
    it is in one for an option that is off (`option(WITH_TOOLS "…" OFF)`), and that no page or script has.
    In branches that exclude each other, in those for a target (`if(TARGET plugins)`) that is only made in a branch that
    is never taken, as for a file that is not there, where the libraries of one call can't be evaluated or there are
    none, and for `ament_target_dependencies()` with packages of which it is unknown whether they bring targets.

    ## Fix safety
    `PUBLIC` means what a call without a keyword means.
    """
    for each in signatures.mixed():
        call, former = each.link.call, each.former.call
        how, other = ("with a keyword", "without one") if each.link.has_keyword else ("without a keyword", "with one")
        kind = "without a keyword" if each.link.has_keyword else "with a keyword"
        by = f"`{former.name}`" if former.name != call.name else "another call"
        start = f"`{each.link.target}` is linked {how} here, and {other} by {by}"
        stops = "CMake stops as soon as somebody turns its switch on" if each.is_off else "CMake stops"
        stops = f"CMake stops where something finds `{each.unsought}`" if each.unsought else stops
        message = f"{start}: {stops}, since it takes one kind for a target; {advice(each)}"
        related = (Related(former.words[0].path, former.words[0].span, f"linked {kind} here"),)
        level = Severity.INFO if each.unsought or each.is_off else None if each.is_certain else Severity.WARNING
        yield Hit(call.words[0].path, call.words[0].span, message, level, related, fix=repair(signatures, each))


def advice(each: MixedLink) -> str:
    plain = each.former if each.link.has_keyword else each.link
    if plain.call.name in ("target_link_libraries", REMOVED):
        return f"write `PUBLIC` behind the target of `{plain.call.name}`"
    return f"leave out the keyword, as `{plain.call.name}` takes none"


def repair(signatures: LinkSignatures, mixed: MixedLink) -> Fix | None:
    """Return the keyword for each call for the target that has none; None where one takes none."""
    links = [each for each in signatures.links() if each.target == mixed.link.target and not each.has_keyword]
    if any(each.call.name not in ("target_link_libraries", REMOVED) or "SYSTEM" in each.call.texts for each in links):
        return None
    ends = sorted({(each.call.words[0].path, each.call.words[0].span.end) for each in links})
    edits = tuple(Edit(path, Span(end, end), f" {KEYWORDS[0]}") for path, end in ends)
    return Fix("write `PUBLIC` where the keyword lacks", edits, Safety.SAFE)
