"""CMK001 project-name-mismatch."""

from __future__ import annotations

from collections.abc import Iterator

from ...edits.cmake import literal
from ...example import CMAKE, Example
from ...finding import Edit, Fix, Hit, Related, Safety, Severity
from ...model.cmake.package import CMakePackage
from ...rule import rule


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
    if not package.ament or not name or word is None or not word.known or word.maybe or word.text == name:
        return
    span = literal(package.cmake.file(word.path).source, word.span, word.text)
    fix = Fix(f"call the project `{name}`", (Edit(word.path, span, name),)) if span else None
    message = (
        f"the project is called `{word.text}`, the package `{name}`: ament_package() stops the build with "
        f"\"package name '{name}' in package.xml does not match current PROJECT_NAME\"; write `project({name})`"
    )
    related = Related(package.manifest.path, package.manifest.name_span, "the package's name")
    yield Hit(word.path, span or word.span, message, related=(related,), fix=fix)
