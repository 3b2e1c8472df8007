"""PRM008 missing-parameter."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...checks.params.idle_nodes import level_of, start_of
from ...checks.params.missing_parameters import MissingParameters, missing_parameters
from ...checks.params.needed_parameters import needed_faults
from ...checks.params.plugin_faults import plugin_faults
from ...edits.fault_hits import hits
from ...example import CMAKE, Example, manifest
from ...finding import Hit, Severity
from ...light_dataclasses import replace
from ...rule import rule

SHOWN = 5
"""How many names the message lists."""
NODE = """\
class Talker : public rclcpp::Node
{
public:
  Talker() : Node("talker")
  {
    declare_parameter<double>("rate");
    declare_parameter<std::string>("frame");
  }
};
int main() {return 0;}
"""
GOOD = """\
<launch>
  <node pkg="my_pkg" exec="talker">
    <param name="rate" value="10.0"/>
    <param name="frame" value="map"/>
  </node>
</launch>
"""
PLUGINS = """\
behavior_server:
  ros__parameters:
    behavior_plugins: [spin, wait]
    spin:
      plugin: nav2_behaviors::Spin
    wait:
      plugin: nav2_behaviors::Wait
"""
FILES = {
    "CMakeLists.txt": CMAKE.replace(
        "ament_package",
        "add_executable(talker src/talker.cpp)\n"
        "install(TARGETS talker DESTINATION lib/${PROJECT_NAME})\n"
        "install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})\nament_package",
    ),
    "src/talker.cpp": NODE,
}


@rule(
    "PRM008",
    "missing-parameter",
    over=MissingParameters,
    severity=Severity.WARNING,
    levels={
        Severity.INFO: "nothing adds the action that starts the node, its launch file is not installed or ends "
        "before at a package that nothing brings, no node that is started reads the block, or a list of plugins is for "
        "unsupported distributions alone"
    },
    examples=(
        Example(
            on="ament_cmake",
            bad={
                **FILES,
                "launch/talker.launch.xml": GOOD.replace('    <param name="frame" value="map"/>\n', "").replace(
                    '"talker"', '"«talker»"'
                ),
            },
            good={"launch/talker.launch.xml": GOOD},
        ),
        Example(
            on="config",
            bad={
                "config/nav.yaml": PLUGINS.replace("[spin, wait]", "[spin, «waiting»]"),
                "package.xml": manifest("  <exec_depend>nav2_behaviors</exec_depend>\n", "ament_cmake"),
            },
            good={"config/nav.yaml": PLUGINS},
        ),
    ),
)
def missing_parameter(scope: MissingParameters) -> Iterator[Hit]:
    """
    ## What it does
    Finds parameters without a default that neither the launch file nor a parameter file sets.
    A node's code declares them (`declare_parameter<double>("rate")`), and a launch file starts the node. It also finds
    copies of a package's own parameter file that lack such a parameter, and names in a list of plugins that have no
    group of their own, or stand there twice, while another group has no name in the list, or the node is a server of
    nav2. Of robot_state_publisher, map_server and lifecycle_manager it knows what they need.

    ## Why is this bad?
    The node stops when it starts: "Statically typed parameter 'rate' must be initialized".

    ## When it is quiet
    Left alone are

    - nodes that are given values which can't be evaluated, or a file that is not here, nodes with parameters on their
      command line or behind a SetParameter, and programs that give values to their own nodes;
    - parameters whose declaration has a default, or stands under a condition, in a `try`, or in a
      function that is called so;
    - the default list of plugins in nav2, which brings its types, and launch files that ROS 2 refuses (LCH006).

    It is an info where the node is never started, no node that is started reads the block, or every launch ends before,
    as it looks for a package that is neither here, nor released, nor in a listed repository. Lists of plugins had other
    names before Humble: in a file or a repository for unsupported distributions alone, what they lack is an info.
    """
    if not scope.launched.is_whole:
        return
    for given, missing in missing_parameters(scope.launched):
        started = given.node.executable or given.node.plugin
        if started is not None:
            names, code = listed([one.name for one in missing]), missing[0].path
            message = f"this node is not given {names}, and `{code}` declares no default: it stops when it starts"
            _, why = level_of(start_of(given.launch, given.node, scope.launched.workspace))
            level = None if scope.readers.is_met(given) else Severity.INFO
            yield Hit(given.launch.path, started.span, f"{message}{why}; give a value here", level)
    for path, fault in needed_faults(scope.launched):
        yield from hits(path, [fault])
    for left in scope.code.left_out():
        message = f"{listed(left.names)} is missing here, and `{left.path}` of `{left.facts.name}` declares no default"
        place = left.block.key.span
        level = Severity.INFO if scope.level_at(left.file.path, place) else None
        yield Hit(left.file.path, place, f"{message}: the node stops when it starts; give a value here", level)
    for path, fault in plugin_faults(scope.code.files, scope.launched.launches):
        yield from hits(path, [replace(fault, level=scope.level_of_plugin(path, fault.span))])


def listed(names: Sequence[str]) -> str:
    more = f" and {len(names) - SHOWN} more" if len(names) > SHOWN else ""
    return ", ".join(f"`{name}`" for name in names[:SHOWN]) + more
