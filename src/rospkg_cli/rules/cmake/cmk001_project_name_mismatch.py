"""CMK001 project-name-mismatch."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...edits.cmake_commands import literal_span
from ...example import CMAKE, Example
from ...finding import Edit, Fix, Hit, Related, Safety, Severity
from ...package.cmake.cmake_package import CMakePackage
from ...rule import rule

NAME = re.compile(r"[A-Za-z][A-Za-z0-9_-]*")
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
    ),
)
def project_name_mismatch(package: CMakePackage) -> Iterator[Hit]:
    """
    ## What it does
    Compares `project()` in CMakeLists.txt with `<name>` in package.xml.

    ## Why is this bad?
    ament_package() stops the build when they differ. This is what is left when a package was copied or renamed.
    """
    name, word = package.manifest.name, package.cmake.project
    if not package.is_ament or not name or word is None or not word.is_known or word.maybe or word.text == name:
        return
    span = literal_span(package.cmake.file(word.path).source, word.span, word.text)
    valid = NAME.fullmatch(name)
    fix = Fix(f"call the project `{name}`", (Edit(word.path, span, name),)) if span and valid else None
    advice = f"write `project({name})`" if valid else "give both one name"
    message = (
        f"the project is called `{word.text}`, the package `{name}`: ament_package() stops the build with "
        f"\"package name '{name}' in package.xml does not match current PROJECT_NAME\"; {advice}"
    )
    related = Related(package.manifest.path, package.manifest.name_span, "the package's name")
    yield Hit(word.path, span or word.span, message, related=(related,), fix=fix)
