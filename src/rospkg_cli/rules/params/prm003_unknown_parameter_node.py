"""PRM003 unknown-parameter-node."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.params.launch_parameters import LaunchParameters
from ...edits.plain_names import only_plain_names
from ...example import CMAKE, Example, manifest
from ...finding import Edit, Fix, Hit, Related, Safety, Severity
from ...rule import rule

LAUNCH = """\
<launch>
  <node pkg="turtlesim" exec="turtlesim_node" name="sim_node">
    <param from="$(find-pkg-share my_pkg)/config/robot.yaml"/>
  </node>
</launch>
"""
INSTALL = "install(DIRECTORY config launch DESTINATION share/${PROJECT_NAME})"
GOOD = """\
sim_node:
  ros__parameters:
    background_r: 0
"""


@rule(
    "PRM003",
    "unknown-parameter-node",
    over=LaunchParameters,
    severity=Severity.WARNING,
    examples=(
        Example(
            on="config",
            bad={
                "package.xml": manifest("  <exec_depend>turtlesim</exec_depend>\n", "ament_cmake"),
                "CMakeLists.txt": CMAKE.replace("ament_package()", f"{INSTALL}\nament_package()"),
                "launch/robot.launch.xml": LAUNCH,
                "config/robot.yaml": GOOD.replace("sim_node", "«sim»"),
            },
            good={"config/robot.yaml": GOOD},
            fix=Safety.UNSAFE,
        ),
    ),
)
def unknown_parameter_node(launched: LaunchParameters) -> Iterator[Hit]:
    """
    ## What it does
    Finds parameters for a node that no launch file starts, where a similar node lacks them.
    The block belongs to no node that the launch files here start, and a node that is given the file, and has no block
    in it, has a similar name; or the file has this block alone, and goes to no other node.

    ## Why is this bad?
    rcl goes by the node's name, as the launch file gives it, and ignores all other blocks without a warning: the node
    runs with its defaults.

    ## When it is quiet
    Blocks of nodes that any launch file here starts are left alone, and those of several whose name is like that of no
    node which lacks one: nodes that other packages start may read them.

    ## Fix safety
    The file may be for another node as well, one that is started elsewhere.
    """
    for file, block, given in launched.misnamed():
        key = block.key.text
        name = given.name or ""
        message = f"no node is called `{key}`: the one that `{given.launch.path}` gives this file to is `{name}`"
        fix = None
        if file.source.slice(block.key.span) == key and key == block.name.rpartition("/")[2]:
            fix = Fix(f"write `{name}`", (Edit(file.path, block.key.span, name),), Safety.UNSAFE)
        where = (Related(given.launch.path, given.node.span, "the node"),)
        what = f"{message}, and it never reads the block"
        yield Hit(file.path, block.key.span, what, related=where, fix=only_plain_names(fix, name))
