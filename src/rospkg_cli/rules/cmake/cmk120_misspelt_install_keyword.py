"""CMK120 misspelt-install-keyword."""

from __future__ import annotations

from collections.abc import Iterator

from ...example import CMAKE, Example
from ...finding import Edit, Fix, Hit, Safety, Severity
from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.values import Word
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.cmake_project import CMake
from ...package.cmake.install_keywords import intended_form, intended_keywords
from ...rule import rule

LINES = """\
install(DIRECTORY launch
  {} share/${{PROJECT_NAME}}
)
"""
TARGETS = """\
add_library(core SHARED src/core.cpp)
install(TARGETS core {} DESTINATION lib)
"""


def cmake(lines: str, keyword: str) -> str:
    return CMAKE.replace("ament_package", lines.format(keyword) + "ament_package")


@rule(
    "CMK120",
    "misspelt-install-keyword",
    over=CMakePackage,
    severity=Severity.ERROR,
    levels={Severity.WARNING: "under a condition that can't be evaluated"},
    examples=(
        Example(
            bad={"CMakeLists.txt": cmake(LINES, "«DESTINTION»"), "launch/talker.launch.xml": "<launch/>\n"},
            good={"CMakeLists.txt": cmake(LINES, "DESTINATION")},
            on="ament_cmake",
            fix=Safety.UNSAFE,
        ),
        Example(
            bad={"CMakeLists.txt": cmake(TARGETS, "«LIBRAY»"), "src/core.cpp": "int core() {return 1;}\n"},
            good={"CMakeLists.txt": cmake(TARGETS, "LIBRARY")},
            on="ament_cmake",
            fix=Safety.UNSAFE,
        ),
    ),
)
def misspelt_install_keyword(package: CMakePackage) -> Iterator[Hit]:
    """
    ## What it does
    Finds words in `install()` that are one or two letters off a keyword, such as `DESTINTION`.
    Its first word, which says what is installed, is also reported in small letters (`install(targets …)`).
    All other rules read the call as it is intended.

    ## Why is this bad?
    CMake takes the word for one more target, file or folder, and what follows it too: it stops, at once or when it
    installs.

    ## When it is quiet
    For words in quotes, values (`DESTINATION INCLUDE`), words that are not all in capitals, and names of targets, files
    and folders that are there.

    ## Fix safety
    The word may be the name of something that is missing.
    """
    cmake = package.cmake
    for call in cmake.named("install"):
        if form := intended_form(call):
            yield hit(cmake, call, call.words[0], form, "it does not say what to install")
        for word, keyword in intended_keywords(call):
            if keyword and not (cmake.target(word.text) or cmake.package_files.is_there(word.text)):
                yield hit(cmake, call, word, keyword, "it takes it for something to install")


def hit(cmake: CMake, call: EvaluatedCommand, word: Word, keyword: str, why: str) -> Hit:
    start = f"`install` has no keyword `{word.text}` (did you mean `{keyword}`?)"
    message = f"{start}: CMake stops, as {why}; correct it"
    fix = Fix(f"write `{keyword}`", (Edit(word.path, word.span, keyword),), Safety.UNSAFE)
    is_literal = cmake.source_text(word) == word.text
    level = Severity.WARNING if call.maybe or word.maybe else None
    return Hit(word.path, word.span, message, level, fix=fix if is_literal else None)
