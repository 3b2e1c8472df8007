"""XML209 depend-in-python-package."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.manifest.manifest_inputs import ManifestAndFiles
from ...edits.manifest_tags import rename_tag
from ...example import Example, manifest
from ...finding import Fix, Hit, Safety, Severity
from ...rule import Profile, rule


@rule(
    "XML209",
    "depend-in-python-package",
    over=ManifestAndFiles,
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
def depend_in_python_package(package: ManifestAndFiles) -> Iterator[Hit]:
    """
    ## What it does
    Finds `<depend>` in packages of pure Python (build type ament_python).

    ## Why is this bad?
    Nothing is compiled, so nothing is needed to build: `<depend>` also means build_depend and build_export_depend, and
    makes the build farm install what only the running program needs.

    ## References
    - [Managing dependencies with rosdep](https://docs.ros.org/en/rolling/Tutorials/Intermediate/Rosdep.html)
    """
    manifest = package.manifest
    if manifest.build_type(package.targets) != "ament_python" or package.files.exists("CMakeLists.txt"):
        return
    for each in manifest.dependencies:
        if each.tag == "depend" and each.name and not manifest.depends_on(each.name, ("exec_depend",)):
            fix = Fix("Write `<exec_depend>`", rename_tag(manifest, each.element, "exec_depend"))
            message = (
                f"a Python package needs `{each.name}` only to run, and `<depend>` means to build as well; write "
                f"`<exec_depend>{each.name}</exec_depend>`"
            )
            yield Hit(manifest.path, each.element.span, message, fix=fix)
