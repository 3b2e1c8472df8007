"""XML209 depend-in-python-package."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.manifest.python_dependencies import PythonDependencies
from ...edits.manifest_tags import rename_tag
from ...example import Example, manifest
from ...finding import Fix, Hit, Safety, Severity
from ...rule import Profile, rule


@rule(
    "XML209",
    "depend-in-python-package",
    over=PythonDependencies,
    severity=Severity.INFO,
    profile=Profile.PEDANTIC,
    examples=(
        Example(
            bad={"package.xml": manifest("  «<depend>rclpy</depend>»\n")},
            good={"package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n")},
            fix=Safety.SAFE,
        ),
    ),
)
def depend_in_python_package(depends: PythonDependencies) -> Iterator[Hit]:
    """
    ## What it does
    Finds `<depend>` in packages of pure Python (build type ament_python).

    ## Why is this bad?
    Nothing is compiled, so nothing is needed to build: `<depend>` also means build_depend and build_export_depend, and
    makes the build farm install what only the running program needs.

    ## When it is quiet
    It runs with `--pedantic` alone. A package that has a CMakeLists.txt may compile, a name that has an `<exec_depend>`
    too is left alone, and one that nothing uses is left to DEP202.

    ## References
    - [Managing dependencies with rosdep](https://docs.ros.org/en/rolling/Tutorials/Intermediate/Rosdep.html)
    """
    manifest = depends.package.manifest
    for each in depends.needed_to_run():
        fix = Fix("Write `<exec_depend>`", rename_tag(manifest, each.element, "exec_depend"))
        message = (
            f"a Python package needs `{each.name}` only to run, and `<depend>` means to build as well; write "
            f"`<exec_depend>{each.name}</exec_depend>`"
        )
        yield Hit(manifest.path, each.element.span, message, fix=fix)
