"""CMK001 project-name-mismatch."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.cmake.unknown_commands import UnknownCommands
from ...edits.cmake_commands import literal_span
from ...example import CMAKE, Example
from ...finding import Edit, Fix, Hit, Related, Safety, Severity
from ...lazy_regex import regex
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.cmake_project import CMake
from ...ros.manifest import PACKAGE_NAME
from ...rule import rule

FIRST = CMAKE.partition("\n")[0]
NAME = regex(r"[A-Za-z][A-Za-z0-9_-]*")
"""What both files can hold as it is, be it a good name or not."""


@rule(
    "CMK001",
    "project-name-mismatch",
    over=CMakePackage,
    severity=Severity.ERROR,
    examples=(
        Example(
            bad={"CMakeLists.txt": CMAKE.replace("my_pkg", "«my_old_pkg»")},
            good={"CMakeLists.txt": CMAKE},
            on="ament_cmake",
            fix=Safety.SAFE,
        ),
        Example(
            bad={"CMakeLists.txt": f"«{FIRST}»\n" + CMAKE.replace("project(my_pkg)\n", "").partition("\n")[2]},
            good={"CMakeLists.txt": CMAKE},
            on="ament_cmake",
        ),
    ),
)
def project_name_mismatch(package: CMakePackage) -> Iterator[Hit]:
    """
    ## What it does
    Compares `project()` in CMakeLists.txt with `<name>` in package.xml.
    Without any `project()` CMake calls the project `Project`.

    ## Why is this bad?
    ament_package() stops the build when they differ. This is what is left when a package was copied or renamed.

    ## When it is quiet
    Where any `project()` of CMakeLists.txt has the right name: a superbuild calls another one first, and returns before
    it comes to `ament_package()`. Where a file that can't be read may call it. Where the name, or whether `project()`
    is called, can't be evaluated, and where no `ament_package()` compares the names.
    """
    name, cmake = package.manifest.name, package.cmake
    if package.is_ament and name and has_no_project(cmake):
        yield Hit(
            cmake.root.path,
            cmake.root.source.line_span(1),
            "CMakeLists.txt never calls `project()`, and CMake names it `Project`: ament_package() stops the build "
            f'with "does not match current PROJECT_NAME"; write `project({name})`',
        )
        return
    word = cmake.project
    if not package.is_ament or not name or word is None or not word.is_known or name in names(cmake):
        return
    if not cmake.ends_a_package or any(call.words[0] is word and call.maybe for call in cmake.projects):
        return
    span = literal_span(package.cmake.file(word.path).source, word.span, word.text)
    valid = NAME.fullmatch(name)
    fix = Fix(f"call the project `{name}`", (Edit(word.path, span, name),)) if span and valid else None
    advice = f"write `project({name})`" if valid else "give both one name"
    if not PACKAGE_NAME.fullmatch(name) and name.lower().replace("-", "_") == word.text:
        fix, advice = None, f"call the package `{word.text}`, as REP-144 allows no such name"
    message = (
        f"`project({word.text})` does not fit the package `{name}`: ament_package() stops the build with "
        f'"does not match current PROJECT_NAME"; {advice}'
    )
    related = Related(package.manifest.path, package.manifest.name_span, "the package's name")
    yield Hit(word.path, span or word.span, message, related=(related,), fix=fix)


def has_no_project(cmake: CMake) -> bool:
    """Return whether nothing that can be read calls project(), or is a misspelling of it, before ament_package()."""
    if not cmake.is_complete or cmake.reads_unknown_files or not cmake.ends_a_package:
        return False
    if any(call.name == "project" for call in (*cmake.calls, *cmake.unreachable)):
        return False
    return all(near != "project" for _, near in UnknownCommands(cmake).all())


def names(cmake: CMake) -> set[str]:
    """Return the names of all calls of project() in CMakeLists.txt, those of branches that are not taken too."""
    unreachable = (call for call in cmake.unreachable if call.name == "project" and call.path == cmake.root.path)
    return {call.words[0].text for call in (*cmake.projects, *unreachable) if call.words}
