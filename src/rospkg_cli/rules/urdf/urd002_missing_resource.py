"""URD002 missing-resource."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.fault import Fault, softer
from ...checks.urdf.missing_files import MissingResource, RobotInWorkspace
from ...example import CMAKE, Example
from ...finding import Hit, Related, Severity
from ...light_dataclasses import replace
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
    "README.md": "Show it: `ros2 launch urdf_launch display.launch.py urdf_package_path:=urdf/robot.urdf.xacro`\n",
}


LEVELS = (None, "warning", "info")


@rule(
    "URD002",
    "missing-resource",
    over=RobotInWorkspace,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "a condition is around it, it is for Gazebo alone, or nothing opens the robot",
        Severity.INFO: "nothing calls the macro or reads the property or default that it is in, or each launch file "
        "replaces the default",
    },
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

    Several files of one missing folder are one finding, and so are three or more of a folder of which none is there.

    ## Why is this bad?
    xacro stops at an include that isn't there. A missing mesh is not shown: RViz prints an error, Gazebo leaves the
    shape out.

    ## When it is quiet
    Nothing is said of packages that are not in the workspace, of paths that a property or an argument fills in, of
    files that the build or the package's Python code writes, git ignores or a submodule holds that is not checked out,
    and where install rules are not all known (a CMake macro of another package may install files). Where another rule
    reports that the folder is not installed, it says so alone. In a condition of xacro, in a file that is only included
    under one which the defaults of the arguments switch off, and in a `<gazebo>` or `<plugin>`, which Gazebo alone
    reads, it is a warning; so it is in a robot that no file of the workspace opens: none of the package names it, in
    code or in a command of a page, and no other that names the package; and of an include of a `.urdf` that only
    another package may open, perhaps without xacro. In a macro that nothing here calls it is an info. The default of an
    argument is an info where nothing reads the argument, or where each launch file that opens the robot gives another
    value.
    """
    for each in scope.missing():
        again = tuple(Related(scope.robot.path, other.span, also(each, other)) for other in each.others)
        level, message = judged(scope, each)
        yield Hit(scope.robot.path, each.span, message, level, again)


def judged(scope: RobotInWorkspace, missing: MissingResource) -> tuple[Severity | None, str]:
    """Return the level and the message: those of the place that xacro is most certain to reach."""
    harm = "xacro stops here" if missing.is_include else "it is missing wherever the robot is shown"
    fault = Fault(missing.span, f"{wrong(missing, scope.package.name)}: {harm}")
    each = [scope.weighed(replace(fault, span=span)) for span in missing.spans]
    best = min(each, key=lambda one: LEVELS.index(one.level))
    if best.level is None and not scope.is_installed:
        best = softer(best, "warning", "where the robot is read from the source: it is not installed")
    elif best.level is None and not scope.opened.has(scope.robot.path):
        best = softer(best, "warning", "and no file of the package opens this robot")
    elif best.level is None and missing.is_include and scope.may_be_read_as_it_is:
        best = softer(best, "warning", "where xacro reads it")
    return Severity(best.level) if best.level else None, best.message + advice(missing)


def wrong(missing: MissingResource, own: str) -> str:
    several = f" and {len(missing.other_paths)} more" if missing.other_paths else ""
    if missing.state == "not installed":
        verb, them = ("are", "them") if several else ("is", "it")
        return f"`{missing.path}`{several} {verb} there, but `{missing.package}` does not install {them}"
    verb = "has" if missing.package == own else "installs"
    if missing.folder:
        return f"`{missing.package}` {verb} no folder `{missing.folder}` for `{missing.path}`{several}"
    return f"`{missing.package}` {verb} no file `{missing.path}`{several}"


def advice(missing: MissingResource) -> str:
    if missing.state == "not installed":
        folder = missing.path.rpartition("/")[0] or missing.path
        return f"; install `{folder}` (`data_files` in setup.py, `install(…)` in CMakeLists.txt)"
    return f"; did you mean `{missing.suggestion}`?" if missing.suggestion else "; add it, or correct the path"


def also(missing: MissingResource, other: MissingResource) -> str:
    return "here too" if other.path == missing.path else f"`{other.path}` too"
