"""LCH006 ros1-launch-syntax."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.fault import once_each
from ...checks.launch.ros1_leftovers import Ros1Leftovers
from ...checks.launch.ros1_syntax import first_sign, ros1_syntax
from ...edits.fault_hits import hits
from ...example import Example, manifest
from ...finding import Hit, Related, Safety, Severity
from ...rule import rule

BAD = """\
<launch>
  <let name="map" value="«$(find my_pkg)»/maps/house.yaml"/>
</launch>
"""
WHOLE = """\
<launch>
  <node pkg="my_pkg" «type»="talker" name="talker"/>
</launch>
"""
PARAM = """\
<launch>
  <«param» name="speed" value="1.0"/>
  <let name="speed" value="1.0"/>
</launch>
"""
FILES = {
    "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n"),
    "maps/house.yaml": "image: house.pgm\n",
    "README.md": "    ros2 launch my_pkg house.launch.xml\n",
}


@rule(
    "LCH006",
    "ros1-launch-syntax",
    over=Ros1Leftovers,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "the whole file is one for ROS 1, and something for ROS 2 starts or includes it",
        Severity.INFO: "nothing for ROS 2 does",
    },
    examples=(
        Example(
            bad={**FILES, "launch/house.launch.xml": BAD},
            good={
                "launch/house.launch.xml": BAD.replace("«", "").replace("»", "").replace("(find ", "(find-pkg-share ")
            },
            fix=Safety.SAFE,
        ),
        Example(
            bad={"launch/house.launch.xml": PARAM},
            good={"launch/house.launch.xml": PARAM.replace("«param»", "set_parameter")},
        ),
        Example(
            bad={"launch/house.launch.xml": WHOLE, "README.md": "    ros2 launch my_pkg house.launch.xml\n"},
            good={"launch/house.launch.xml": "<launch>\n</launch>\n"},
        ),
    ),
)
def ros1_launch_syntax(leftovers: Ros1Leftovers) -> Iterator[Hit]:
    """
    ## What it does
    Finds ROS 1 syntax in XML and YAML launch files.
    It is `$(find x)`, `$(arg x)`, and `<param>`, `<rosparam>`, `<remap>`, `<env>` or `<machine>` among the actions. A
    file that is for ROS 1 altogether is reported once, where this package installs it, and all such files of a package
    together.

    ## Why is this bad?
    `ros2 launch` stops with "Unknown substitution: find" or "Unrecognized entity of the type: param".

    ## When it is quiet
    A file that is for ROS 1 altogether is left alone where this package does not install it, is built with catkin, or
    names catkin in its manifest. So are all launch files of a package that catkin alone builds.

    It is an info

    - where nothing for ROS 2 names the file together with its package: no `ros2 launch my_pkg old.launch` of a page or
      a script, no code, no launch file;
    - in a file that was ported in part, with `type=`, `$(find …)` or `$(arg …)` left, which nothing names;
    - in a file that has nothing but `<param>` and the like, as MoveIt's setup assistant wrote them.
    """
    scope = leftovers.scope
    if scope.package.is_for_ros1:
        return
    yield from hits(scope.file.path, once_each(ros1_syntax(scope.file)))
    for file, *others in [leftovers.together] if leftovers.together else ():
        start = f"{len(others) + 1} launch files are" if others else "this launch file is"
        ends = "are installed: `ros2 launch` refuses them" if others else "is installed: `ros2 launch` refuses it"
        it = "them" if others else "it"
        signs, advice = "(`type=`, `$(find …)`, `$(arg …)`)", f"port {it}, or do not install {it}"
        is_met = leftovers.is_met(file)
        idle = "" if is_met else f", but nothing for ROS 2 starts {it}"
        message = f"{start} written for ROS 1 {signs} and {ends}{idle}; {advice}"
        places = tuple(Related(each.path, first_sign(each), "and this one") for each in others)
        yield Hit(file.path, first_sign(file), message, Severity.WARNING if is_met else Severity.INFO, places)
