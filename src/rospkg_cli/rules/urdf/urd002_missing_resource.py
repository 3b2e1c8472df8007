"""URD002 missing-resource."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.fault import Fault, softer
from ...checks.urdf.bare_meshes import bare_meshes, without_scheme
from ...checks.urdf.missing_level import missing_fault
from ...checks.urdf.missing_resource import MissingResource, advice, also
from ...checks.urdf.personal_paths import PathMessage, Place, by_machine, personal_paths
from ...checks.urdf.robot_in_workspace import RobotInWorkspace
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
SHOW = """\
<launch>
  <let name="model" value="$(find-pkg-share my_pkg)/urdf/robot.urdf.xacro"/>
</launch>
"""
FILES = {
    "CMakeLists.txt": CMAKE.replace(
        "ament_package", "install(DIRECTORY launch meshes urdf\n  DESTINATION share/${PROJECT_NAME}\n)\nament_package"
    ),
    "urdf/wheel.xacro": '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"/>\n',
    "meshes/base_link.stl": "solid base\n",
    "launch/show.launch.xml": SHOW,
}


@rule(
    "URD002",
    "missing-resource",
    over=RobotInWorkspace,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "a mesh is missing, a condition is around it, it is for Gazebo alone, or code or a command "
        "of a page, and no launch file, opens the robot",
        Severity.INFO: "nothing is shown to open the robot, or Gazebo, calls the macro or reads the property or "
        "default that it is in, launch files replace the default or part of the path, or people or containers have it",
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
    package and others of the workspace, and checks whether they install the file, there or at another path, which it
    reports; it follows `model://name/…` into models that are here. It also reports files in a home folder
    (`file:///home/ada/…`), and meshes named by a path alone that the package has: only URLs are looked for. Files of a
    missing folder are one finding, and so are three or more of a folder of which none is there, and one that several
    robots of a folder name at the same place.

    ## Why is this bad?
    xacro stops at an include that isn't there. A missing mesh is not shown, and the launch goes on: that is a warning.

    ## When it is quiet
    Nothing is said of packages that are not in the workspace, of paths that a property or an argument fills in, of
    files that the build or code writes, git ignores or a submodule holds that is not checked out, and where install
    rules are not all known (a CMake macro of another package may install files). A folder that is not installed is
    another rule's. In a condition of xacro, in a file that is only included under one which defaults switch off, and in
    a `<gazebo>` or `<plugin>`, which Gazebo alone reads, it is a warning (an info where nothing here starts it), and so
    in a robot that only code names, or a command of a page, and of an include of a `.urdf` that only another package
    may open. It is an info in a robot that no launch file, code or command of a page is shown to open by default, by
    its folder, or that lies in a folder such as `old/` or is not installed, and in a macro that nothing calls, or a
    condition that is constant, or off in each robot by default or as launch files say. The default of an argument is
    one where nothing reads it, or only what is off by default, or each launch file that opens the robot gives another,
    or spawns it, where Gazebo alone reads it. A path without a scheme is one where no launch file opens it, or none
    that does starts RViz or move_group by default, or what publishes the robot, where Gazebo finds it: `$(find …)`, or
    a relative one where `create -file` alone opens the robot. So is a path that each such launch file replaces, what a
    page or a script fetches or makes, and a mesh that people bring or name, or that lies in a home which many accounts
    or the containers of the repository have, or where these mount a folder.
    """
    for each in scope.missing():
        same = list(scope.in_folder.lacking(scope.robot, each))
        if any(path < scope.robot.path for path, _ in same):
            continue  # the finding is at that robot
        again = tuple(Related(scope.robot.path, other.span, also(each, other)) for other in each.others)
        again += tuple(Related(path, span, f"`{each.path}` here too") for path, span in same)
        level, message = judged(scope, each)
        yield Hit(scope.robot.path, each.span, message, level, again)
    named = scope.in_folder.untold(scope.robot, list(personal_paths(scope.robot.document)))
    for found, said in by_machine(named, scope.robot.document, scope.files):
        yield of_several(scope, found, said)
    bare = bare_meshes(scope.robot.document, scope.files, scope.package) if not scope.is_idle else {}
    if found := scope.in_folder.untold(scope.robot, list(bare)):
        is_met = scope.misses_bare(bare)
        yield of_several(scope, found, (*without_scheme(bare, is_shown=is_met), None if is_met else "info"))


def judged(scope: RobotInWorkspace, missing: MissingResource) -> tuple[Severity | None, str]:
    """Return the level and the message: an error only where xacro stops at what a launch file opens."""
    best = missing_fault(scope, missing)
    level = best.level or (None if missing.is_include and scope.launched.has(scope.robot.path) else "warning")
    return Severity(level) if level else None, best.message + advice(missing)


def of_several(scope: RobotInWorkspace, found: list[Place], said: PathMessage) -> Hit:
    (first, _), *others = found
    message, todo, level = said
    best = scope.weighed(Fault(first, message, "warning"))
    if "info" not in (level, best.level) and not scope.is_met:
        best = softer(best, "info", "as soon as something opens this robot")
    again = tuple(Related(scope.robot.path, span, f"`{other}` too") for span, other in others)
    return Hit(scope.robot.path, first, f"{best.message}; {todo}", Severity(level or best.level or "warning"), again)
