"""XML304 build-type-mismatch."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.manifest.manifest_inputs import ManifestAndFiles
from ...example import CMAKE, Example, manifest
from ...finding import Hit, Severity
from ...package.contested_build_type import has_several_build_types
from ...ros.manifest import BUILD_FILES
from ...rule import rule

GOOD = manifest(build_type="ament_cmake")


@rule(
    "XML304",
    "build-type-mismatch",
    over=ManifestAndFiles,
    severity=Severity.ERROR,
    examples=(
        Example(
            on="ament_cmake",
            bad={
                "package.xml": GOOD.replace("<build_type>ament_cmake", "<build_type>«ament_cmake»"),
                "CMakeLists.txt": None,
            },
            good={"package.xml": GOOD, "CMakeLists.txt": CMAKE},
        ),
        Example(
            on="",
            bad={
                "package.xml": manifest().replace("<build_type>ament_python", "<build_type>«ament_python»"),
                "LICENSE": "MIT\n",
            },
            good={"package.xml": manifest(), "setup.py": "from setuptools import setup\n"},
        ),
    ),
)
def build_type_mismatch(package: ManifestAndFiles) -> Iterator[Hit]:
    """
    ## What it does
    Finds packages whose setup.py or CMakeLists.txt is missing for their build type.
    ament_python needs a setup.py, ament_cmake and cmake a CMakeLists.txt.

    ## Why is this bad?
    `colcon build` fails: "setup.py not found", or CMake's "does not appear to contain CMakeLists.txt".

    ## When it is quiet
    A build type whose condition excludes the targets is left alone. Two build types at once are left to XML303, and a
    pyproject.toml without setup.py to SET307.

    ## References
    - [REP-149, build_type](https://ros.org/reps/rep-0149.html)
    """
    manifest, files = package.manifest, package.files
    if has_several_build_types(manifest, package.targets):
        return
    for element in manifest.build_types(package.targets):
        wanted = BUILD_FILES.get(element.text)
        if wanted is None or files.exists(wanted):
            continue
        if wanted == "setup.py" and files.exists("pyproject.toml"):
            continue  # said by SET307, which knows what to do
        others = [name for name, path in BUILD_FILES.items() if path != wanted and files.exists(path)]
        advice = f"add it, or write `<build_type>{others[0]}</build_type>`" if others else "add it"
        message = f"the build type is `{element.text}`, and there is no `{wanted}`: `colcon build` fails; {advice}"
        yield Hit(manifest.path, manifest.span(element), message)
