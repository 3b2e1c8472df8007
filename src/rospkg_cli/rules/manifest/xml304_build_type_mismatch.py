"""XML304 build-type-mismatch."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...checks.manifest.manifest_inputs import ManifestAndFiles
from ...example import CMAKE, Example, manifest
from ...files import PackageFiles
from ...finding import Hit, Severity
from ...lazy_regex import regex
from ...package.contested_build_type import has_several_build_types
from ...ros.manifest import BUILD_FILES
from ...rule import rule

GOOD = manifest(build_type="ament_cmake")

PLAIN = "cmake"
ENDS = regex(r"^(?:ament|ament_auto)_package\s*\(", re.MULTILINE)
"""A call that stands in no block, by the looks of it."""
BLOCK = regex(r"^(?:if|macro|function)\s*\([^()]*(?:ament|catkin|ROS)", re.MULTILINE | re.IGNORECASE)
PLAINLY = (
    "the build type is `cmake`, and CMakeLists.txt is one of ament_cmake: colcon builds it as any CMake project, and "
    "`--symlink-install` links nothing; write `<build_type>ament_cmake</build_type>`"
)


@rule(
    "XML304",
    "build-type-mismatch",
    over=ManifestAndFiles,
    severity=Severity.ERROR,
    levels={Severity.INFO: "it is `cmake`, and CMakeLists.txt is one of ament_cmake: it is built all the same"},
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
        Example(
            on="ament_cmake",
            bad={"package.xml": GOOD.replace("<build_type>ament_cmake", "<build_type>«cmake»")},
            good={"package.xml": GOOD},
        ),
    ),
)
def build_type_mismatch(package: ManifestAndFiles) -> Iterator[Hit]:
    """
    ## What it does
    Finds packages whose setup.py or CMakeLists.txt is missing for their build type.
    ament_python needs a setup.py, ament_cmake and cmake a CMakeLists.txt. It also finds the build type cmake where
    CMakeLists.txt calls `ament_package()` in any case.

    ## Why is this bad?
    `colcon build` fails: "setup.py not found", or CMake's "does not appear to contain CMakeLists.txt".

    ## When it is quiet
    A CMakeLists.txt with a condition on ament, catkin or ROS may be built plainly. A build type whose condition
    excludes the targets is left alone. Two build types at once are left to XML303, and a pyproject.toml without
    setup.py to SET307.

    ## References
    - [REP-149, build_type](https://ros.org/reps/rep-0149.html)
    """
    manifest, files = package.manifest, package.files
    if has_several_build_types(manifest, package.targets):
        return
    for element in manifest.build_types(package.targets):
        wanted = BUILD_FILES.get(element.text)
        if wanted is None or files.exists(wanted):
            if element.text == PLAIN and ends_with_ament(files):
                yield Hit(manifest.path, manifest.span(element), PLAINLY, Severity.INFO)
            continue
        if wanted == "setup.py" and files.exists("pyproject.toml"):
            continue  # said by SET307, which knows what to do
        others = [name for name, path in BUILD_FILES.items() if path != wanted and files.exists(path)]
        advice = f"add it, or write `<build_type>{others[0]}</build_type>`" if others else "add it"
        message = f"the build type is `{element.text}`, and there is no `{wanted}`: `colcon build` fails; {advice}"
        yield Hit(manifest.path, manifest.span(element), message)


def ends_with_ament(files: PackageFiles) -> bool:
    """Return whether CMakeLists.txt calls `ament_package()`, whatever is there."""
    text = files.readable_text("CMakeLists.txt")
    return ENDS.search(text) is not None and BLOCK.search(text) is None
