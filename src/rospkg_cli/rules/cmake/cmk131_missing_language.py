"""CMK131 missing-language."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.cmake.missing_languages import MissingLanguage, MissingLanguages
from ...example import CMAKE, INTERFACES_BODY, INTERFACES_CMAKE, Example, manifest
from ...finding import Hit, Severity
from ...package.cmake.cmake_package import CMakePackage
from ...rule import rule

PROJECT, CXX, BOTH = "project(my_pkg)", "«project»(my_pkg LANGUAGES CXX)", "project(my_pkg LANGUAGES C CXX)"
PROGRAM = """\
add_executable(talker src/talker.c)
install(TARGETS talker DESTINATION lib/${PROJECT_NAME})
"""
IN_C = CMAKE.replace("ament_package", PROGRAM + "ament_package")


@rule(
    "CMK131",
    "missing-language",
    over=CMakePackage,
    severity=Severity.ERROR,
    levels={Severity.INFO: "other sources of the target are compiled, and this one is not"},
    examples=(
        Example(
            bad={
                "package.xml": manifest(INTERFACES_BODY, "ament_cmake"),
                "CMakeLists.txt": INTERFACES_CMAKE.replace(PROJECT, CXX),
                "msg/Status.msg": "bool ok\n",
                "srv/SetMode.srv": "string mode\n---\nbool ok\n",
            },
            good={"CMakeLists.txt": INTERFACES_CMAKE.replace(PROJECT, BOTH)},
            on="ament_cmake",
        ),
        Example(
            bad={"CMakeLists.txt": IN_C.replace(PROJECT, CXX), "src/talker.c": "int main(void) {return 0;}\n"},
            good={"CMakeLists.txt": IN_C.replace(PROJECT, BOTH)},
            on="ament_cmake",
        ),
    ),
)
def missing_language(package: CMakePackage) -> Iterator[Hit]:
    """
    ## What it does
    Finds languages that a package is written in and that no `project()` enables.
    They are C and C++ where interfaces are generated, which become libraries of both, and those of the sources that
    targets list (C, C++, CUDA); `enable_language()` enables one too.

    ## Why is this bad?
    A project that names its languages has no other. CMake stops with "Cannot determine link language for target",
    or passes over the sources without a word, and what is in them is missing when it links.

    ## When it is quiet
    Where a `project()` names no language: it enables C and C++. Where a file is included that can't be read, a language
    is not known, or one is enabled anywhere, under a condition too; where the language of a source is set, or its
    target gets more sources elsewhere.
    """
    for each in MissingLanguages(package.cmake).all():
        severity = None if each.of_interfaces or each.is_only else Severity.INFO
        yield Hit(each.call.path, each.call.command.name_span, sentence(each), severity)


def sentence(each: MissingLanguage) -> str:
    start, add = f"no LANGUAGES of a `project()` has {each.language}", f"add {each.language}"
    stops = 'CMake stops with "Cannot determine link language"'
    if each.of_interfaces:
        what = f"the interfaces of `{each.word.text}` become libraries of {each.language} too"
        return f"{start}, and {what}: {stops}; {add}"
    ends = stops if each.is_only else "it is never compiled"
    return f"{start}, and `{each.word.text}` is written in it: {ends}; {add}"
