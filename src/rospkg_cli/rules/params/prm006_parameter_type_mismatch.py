"""PRM006 parameter-type-mismatch."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.params.differing_numbers import differing_numbers
from ...checks.params.idle_nodes import level_of, may_start
from ...checks.params.mistyped_known import MistypedValues, mistyped_known
from ...checks.params.mistyped_launched import article, mistyped_launched, what_stops
from ...checks.params.rcl_types import given_type
from ...edits.double_numbers import INTEGERS, as_double, known_as_double
from ...example import CMAKE, Example, manifest
from ...finding import Hit, Related, Safety, Severity
from ...package.params.parameter_file import Parameter, ParameterFile
from ...rule import rule

NODE = """\
class Talker : public rclcpp::Node
{
public:
  Talker() : Node("talker")
  {
    declare_parameter("rate", 10.0);
    declare_parameter<std::vector<std::string>>("frames", {"map"});
  }
};
"""
GOOD = """\
talker:
  ros__parameters:
    rate: 50.0
    frames: [odom]
"""

FOXY = ", but not in Foxy"
NEWER = ", but not in Humble, which has no such parameter"
INSTALL = "install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})"
LAUNCH = """\
<launch>
  <node pkg="joy" exec="joy_node">
    <param name="deadzone" value="{}"/>
  </node>
</launch>
"""


def example(bad: str, good: str, fix: Safety | None = None) -> Example:
    files = {"include/my_pkg/talker.hpp": NODE, "config/robot.yaml": GOOD.replace(good, bad)}
    return Example(on="config", bad=files, good={"config/robot.yaml": GOOD}, fix=fix)


@rule(
    "PRM006",
    "parameter-type-mismatch",
    over=MistypedValues,
    severity=Severity.WARNING,
    levels={
        Severity.INFO: "nothing names the file, adds the action, reads the block or lists the plugin, the block is one "
        "of a well-known node by its name alone, or another file has a double"
    },
    examples=(
        example("rate: «50»", "rate: 50.0", Safety.SAFE),
        example("frames: «odom»", "frames: [odom]"),
        Example(
            on="ament_cmake",
            bad={
                "CMakeLists.txt": CMAKE.replace("ament_package()", f"{INSTALL}\nament_package()"),
                "package.xml": manifest("  <exec_depend>joy</exec_depend>\n", "ament_cmake"),
                "launch/joy.launch.xml": LAUNCH.format("«0»"),
            },
            good={"launch/joy.launch.xml": LAUNCH.format("0.0")},
            fix=Safety.SAFE,
        ),
    ),
)
def parameter_type_mismatch(scope: MistypedValues) -> Iterator[Hit]:
    """
    ## What it does
    Finds values in a parameter file whose type differs from the declared type.
    Types are declared by `declare_parameter` and its like in C++ and Python, and by definitions for
    generate_parameter_library. Those of well-known packages (nav2, ros2_control, slam_toolbox,
    robot_localization and others) are known without their sources. Values in launch files are compared likewise, with
    the defaults of arguments, and the texts that `perform` returns in Python, as YAML makes no number of these. Where a
    type is not known, and another file of the package gives the same node a double for an int, that is an info.

    ## Why is this bad?
    A parameter never changes its type. `50` is an integer, and a node that declared a double stops when it starts:
    "parameter 'rate' has invalid type".

    ## When it is quiet
    A block belongs to the package that declares most of its names: this one, one that it depends on, or any by at least
    three names. Nothing is reported where declarations differ, also between releases of a well-known package, where a
    type is not known, a launch file or script fills the value in, or only code opens the file. What Humble lacks yet is
    an info, unless pages name newer distributions alone. Where pages and scripts name Foxy alone, which takes any type,
    only types of well-known packages are reported, as an info; where other pages or names of files do, all is an info.
    It is an info, too, where nothing names the file but an argument that no launch file takes; nothing adds the action
    that starts the node; launch files replace the value; no node that is started (and configured) reads the block; code
    declares what only ends so (`prefix + '.x'`); no list of the block has the plugin; or only the name of the block
    shows its package (those of nav2 are known by several blocks). Launch files for ROS 1 (LCH006) are left alone.
    """
    reported, is_old = set(), scope.distribution.is_named_alone
    for group in () if is_old else scope.given.groups():
        for parameter in group.parameters:
            given, wanted = given_type(parameter.value), group.wanted_type(parameter)
            if wanted is not None and given and given != wanted[0]:
                message = f"`{parameter.name}` is declared as {wanted[0]} in `{wanted[1].path}`"
                fix = as_double(group.file.path, parameter) if (given, wanted[0]) in INTEGERS else None
                reported.add(place := (group.file.path, parameter.value.span))
                foxy = FOXY if scope.distribution.is_for_older(group.file.path) else ""
                what = f"{message}: {article(given)} stops the node when it starts{foxy}; write {article(wanted[0])}"
                is_mild = foxy or wanted[1].tail or scope.readers.is_idle(*place)
                yield Hit(*place, what, Severity.INFO if is_mild else None, fix=fix)
    for each in mistyped_known(scope.known):
        if (each.path, each.value.value) not in reported:
            message = f"`{each.value.name}` is declared as {each.wanted} by `{each.package}`"
            fix = known_as_double(each) if (each.value.type, each.wanted) in INTEGERS else None
            given = f"{article(each.value.type)} stops the {each.kind} when it starts"
            is_foxy = is_old or scope.distribution.is_for_older(each.path)
            is_newer = each.is_newer and not scope.distribution.is_from_jazzy_on
            given += FOXY if is_foxy else NEWER if is_newer else level_of(each.start)[1]
            is_mild = is_foxy or is_newer or not each.is_certain or not may_start(each.start)
            level = Severity.INFO if is_mild or scope.readers.is_idle(each.path, each.value.value) else None
            yield Hit(each.path, each.value.value, f"{message}: {given}; write {article(each.wanted)}", level, fix=fix)
    for each in () if is_old else mistyped_launched(scope.known.launched):
        fix = known_as_double(each) if (each.value.type, each.wanted) in INTEGERS and not each.how else None
        is_foxy = scope.distribution.is_for_older(each.path)
        level = None if may_start(each.start) and not is_foxy else Severity.INFO
        yield Hit(each.path, each.value.value, what_stops(each) + (FOXY if is_foxy else ""), level, fix=fix)
    for file, several in () if is_old else differing_numbers(scope.given.files, set(scope.with_types())):
        yield unequal(file, several)


def unequal(file: ParameterFile, several: list[tuple[Parameter, str]]) -> Hit:
    (first, other), *rest = several
    more = f" (so with {len(rest)} more)" if rest else ""
    message = f"`{first.name}` is an int here and a double in `{other}`{more}: a parameter has one type"
    others = tuple(Related(file.path, each.value.span, f"`{each.name}` too") for each, _ in rest)
    what = f"{message}, and one of the two stops the node if it declares it; write them alike"
    return Hit(file.path, first.value.span, what, Severity.INFO, others, as_double(file.path, first))
