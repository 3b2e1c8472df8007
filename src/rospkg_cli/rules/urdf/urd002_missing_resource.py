"""URD002 missing-resource."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.urdf.missing_files import MissingResource, RobotInWorkspace
from ...example import CMAKE, Example
from ...finding import Hit, Related, Severity
from ...rule import rule

GOOD = """\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="robot">
  <xacro:include filename="$(find my_pkg)/urdf/wheel.xacro"/>
  <link name="base">
    <visual>
      <geometry>
        <mesh filename="package://my_pkg/meshes/base_link.stl"/>
      </geometry>
    </visual>
  </link>
</robot>
"""
FILES = {
    "CMakeLists.txt": CMAKE.replace(
        "ament_package", "install(DIRECTORY meshes urdf\n  DESTINATION share/${PROJECT_NAME}\n)\nament_package"
    ),
    "urdf/wheel.xacro": '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"/>\n',
    "meshes/base_link.stl": "solid base\n",
}


@rule(
    "URD002",
    "missing-resource",
    over=RobotInWorkspace,
    severity=Severity.ERROR,
    examples=(
        Example(
            on="ament_cmake",
            bad={**FILES, "urdf/robot.urdf.xacro": GOOD.replace("/meshes/base_link.stl", "«/meshes/base-link.stl»")},
            good={"urdf/robot.urdf.xacro": GOOD},
        ),
        Example(
            on="ament_cmake",
            bad={**FILES, "urdf/robot.urdf.xacro": GOOD.replace("/urdf/wheel.xacro", "«/urdf/wheels.xacro»")},
            good={"urdf/robot.urdf.xacro": GOOD},
        ),
        Example(
            on="ament_cmake",
            bad={
                **FILES,
                "CMakeLists.txt": FILES["CMakeLists.txt"].replace("meshes urdf", "urdf"),
                "meshes/base_link.stl": None,
                "urdf/robot.urdf.xacro": GOOD.replace("/meshes/base_link.stl", "«/meshes/base_link.stl»"),
            },
            good={**FILES, "urdf/robot.urdf.xacro": GOOD},
        ),
    ),
)
def missing_resource(scope: RobotInWorkspace) -> Iterator[Hit]:
    """
    ## What it does
    Finds meshes, includes and other files that a robot or a world names and that do not exist.
    It follows `package://name/…`, `$(find name)/…` and relative includes of urdf, xacro, sdf and world files into this
    package and the others of the workspace, and checks whether the file is among what they install.

    ## Why is this bad?
    xacro stops at an include that isn't there. A missing mesh is not shown: RViz prints an error, Gazebo leaves the
    shape out.
    """
    for each in scope.missing():
        again = tuple(Related(scope.robot.path, span, "here too") for span in each.other_spans)
        yield Hit(scope.robot.path, each.span, message(each), related=again)


def message(missing: MissingResource) -> str:
    harm = "xacro stops here" if missing.is_include else "it is missing wherever the robot is shown"
    if missing.state == "not installed":
        return f"`{missing.path}` is there, but `{missing.package}` does not install it: {harm}"
    hint = f" (did you mean `{missing.suggestion}`?)" if missing.suggestion else ""
    return f"`{missing.package}` has no file `{missing.path}`{hint}: {harm}"
