"""XML208 missing-buildtool."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.depends.name_source import is_installed_with_others
from ...checks.manifest.build_tools import BuildTools
from ...edits.brought_hits import comes_with
from ...edits.manifest import add_dependency
from ...example import Example, manifest
from ...finding import Fix, Hit, Safety, Severity
from ...lazy_regex import regex
from ...rule import rule

GOOD = manifest(build_type="ament_cmake")
BAD = GOOD.replace("  <buildtool_depend>ament_cmake</buildtool_depend>\n", "")
FAMILY = regex(r"(.*_)?cmake(_.*)?")
"""ament_cmake and its parts, and what wraps it, such as autoware_cmake."""

PART = regex(
    r"ament_cmake_(core|export_\w+|gen_version_h|gmock|gtest|include_directories|libraries|pytest|python|test)"
)
"""Packages that are parts of ament_cmake, or siblings of it, and do not depend on it."""

NOT_FOR_BUILDING = frozenset({"test_depend", "doc_depend", "exec_depend"})


@rule(
    "XML208",
    "missing-buildtool",
    over=BuildTools,
    severity=Severity.WARNING,
    levels={
        Severity.INFO: "where a dependency that is declared for building brings it, or another package of an "
        "unreleased repository declares it"
    },
    examples=(
        Example(
            on="ament_cmake",
            bad={"package.xml": BAD.replace("<build_type>ament_cmake", "<build_type>«ament_cmake»")},
            good={"package.xml": GOOD},
            fix=Safety.SAFE,
        ),
    ),
)
def missing_buildtool(tools: BuildTools) -> Iterator[Hit]:
    """
    ## What it does
    Finds ament_cmake packages that declare no dependency on ament_cmake.
    One of its parts (ament_cmake_auto, ament_cmake_ros, …), or a package that wraps it, will do.

    ## Why is this bad?
    It builds where ament_cmake happens to be sourced. In a workspace that builds ament_cmake itself the order is
    undefined, and on the build farm CMake ends with `Could not find a package configuration file provided by
    "ament_cmake"`.

    ## When it is quiet
    A build tool of the ament_cmake family under any tag that is there when the package is built is enough, but for
    parts such as ament_cmake_core and ament_cmake_python where CMakeLists.txt finds ament_cmake itself. A
    CMakeLists.txt that neither finds such a package nor calls `ament_package()` is left alone. Where a dependency that
    is there to build certainly brings it, as the generators of interfaces do, it is an info, and
    so it is where another package of the repository declares it and nothing shows a release. A part of ament_cmake that
    `find_package(… REQUIRED)` names, where ament_cmake itself is not found, is reported by DEP104.

    ## References
    - [ament_cmake user documentation](https://docs.ros.org/en/rolling/How-To-Guides/Ament-CMake-Documentation.html)
    """
    package, manifest = tools.package, tools.package.manifest
    asked = sorted(name for name in package.found_to_build if name.startswith("ament_cmake"))
    there = [each for each in manifest.dependencies if each.tag not in NOT_FOR_BUILDING]
    if any(
        FAMILY.fullmatch(each.name) and not ("ament_cmake" in asked and PART.fullmatch(each.name)) for each in there
    ):
        return
    if not asked and not package.ends_a_package:
        return
    name = "ament_cmake" if "ament_cmake" in asked or not asked else asked[0]
    if tools.declared.misnamed.has(name) or (name in asked and package.requires(name)):
        return
    for element in manifest.build_types(package.targets):
        if element.text == "ament_cmake":
            bringer = tools.bringer(name)
            harm = comes_with(bringer) if bringer else "on the build farm `find_package` fails"
            message = (
                f"package.xml does not declare `{name}`, which CMakeLists.txt needs: {harm}; "
                f"add `<buildtool_depend>{name}</buildtool_depend>`"
            )
            level = Severity.INFO if bringer or is_installed_with_others(tools.declared, [name]) else None
            fix = Fix(f"Add `{name}`", (add_dependency(manifest, "buildtool_depend", name),))
            yield Hit(manifest.path, manifest.span(element), message, level, fix=fix)
            return
