"""PRM003 unknown-parameter-node."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.params import displaced_blocks as displaced
from ...checks.params.costmap_faults import costmap_faults
from ...checks.params.misnamed_blocks import misnamed_blocks, mistyped_blocks_of
from ...checks.params.spawn_faults import spawn_faults
from ...checks.params.unread_blocks import NodeBlocks, shown_block, shown_readers
from ...edits.fault_hits import hits
from ...edits.node_blocks import renaming
from ...example import CMAKE, Example, manifest
from ...finding import Hit, Related, Safety, Severity
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
CONTROLLERS = """\
controller_manager:
  ros__parameters:
    diff_controller:
      type: diff_drive_controller/DiffDriveController
{}:
  ros__parameters:
    wheel_separation: 0.3
"""


@rule(
    "PRM003",
    "unknown-parameter-node",
    over=NodeBlocks,
    severity=Severity.WARNING,
    levels={
        Severity.INFO: "a default gives the node its name, nothing names the file, several nodes get it, another one "
        "may be intended, the block holds defaults alone, or the launch file is not installed or adds no node"
    },
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
        Example(
            on="config",
            bad={
                "config/robot.yaml": CONTROLLERS.format("«diff_controler»"),
                "package.xml": manifest("  <exec_depend>diff_drive_controller</exec_depend>\n", "ament_cmake"),
            },
            good={"config/robot.yaml": CONTROLLERS.format("diff_controller")},
            fix=Safety.UNSAFE,
        ),
    ),
)
def unknown_parameter_node(scope: NodeBlocks) -> Iterator[Hit]:
    """
    ## What it does
    Finds parameters for a node that no launch file starts, where a similar node lacks them.
    The block is for no node that the launch files here start, while a node that is given the file has a similar name
    and no block in it; or the file goes to no other node, and has only this block, or one whose parameters the node's
    package declares. Where the launch file gives a node no name, the one literal name in its code counts; where the
    name is an argument, its default does, and the finding is an info. It is an info, too, where nothing names the file,
    and the package has one node, of another name, and declares all that the block sets; and for one block for several
    nodes, none of which reads it.

    It also finds blocks with nearly the name of a controller that the same file gives `controller_manager`, or of a
    well-known node (`controller_manager`, those of nav2) that has no block there; blocks with the name of an executable
    that is started under another name; blocks of a node that is started in another namespace (`talker` is `/talker`
    alone); and controllers that are spawned under nearly the name of one that has a type. The costmaps of nav2 are in
    namespaces of their own names: `local_costmap` alone is no node, if the file has the block of the server that makes
    it.

    ## Why is this bad?
    rcl goes by the node's name, as the launch file gives it, and ignores all other blocks without a warning: the node
    runs with its defaults.

    ## When it is quiet
    Left alone are files that only code opens (launch for single values, a program by its own parser), blocks of nodes
    that any launch file here starts, and, of several blocks, those whose name is like that of no node which lacks one:
    nodes that other packages start may read them. So are names that differ by a number, and nodes inside of a process
    that is given the file: what a container or ros2_control_node loads, the costmap in a server of nav2.

    It is an info

    - where another node may be intended: code, a page, or a launch file in a comment, gives a node that name; its
      program is of a package that is not here; several blocks or nodes are left; or another package names the file;
    - where the only launch files that give the file to a node are not installed or laid aside, or the action is never
      added;
    - where the block holds no more than defaults (false, 0 or empty where they are not known), a comment says that
      nothing reads it, the launch file chooses among several namespaces, or a spawner is given a type or a file.

    ## Fix safety
    The file may be for another node as well, one that is started elsewhere.
    """
    if not (launched := scope.launched).is_whole:
        return
    for file, block, readers in misnamed_blocks(launched):
        names = sorted({each.known_name or "" for each in readers})
        is_named = len(names) == 1 and all(each.name or each.in_code for each in readers)
        same, may = scope.lost_nothing(block, readers), scope.why_not_sure(file, block, readers)
        is_sure = is_named and not same and not may
        level = None if is_sure and any(map(scope.readers.is_met, readers)) else Severity.INFO
        where = tuple(Related(each.launch.path, each.node.span, "the node") for each in readers)
        fix = renaming(file, block, names[0]) if len(names) == 1 and not may else None
        message = f"{shown_block(block, may)}: {shown_readers(readers[0], names)}{may or same}"
        yield Hit(file.path, block.key.span, message, level, where, fix)
    for file, block, given in displaced.displaced_blocks(launched):
        same, may = scope.lost_nothing(block, [given]), displaced.why_not(launched, file, block)
        where = (Related(given.launch.path, given.node.span, "the node"),)
        level = None if scope.readers.is_met(given) and not (may or same) else Severity.INFO
        yield Hit(file.path, block.key.span, displaced.displaced_message(block, given) + (may or same), level, where)
    for path, fault in (*spawn_faults(launched), *costmap_faults(scope.readers)):
        yield from hits(path, [fault])
    for file, wrong in mistyped_blocks_of(launched):
        same = scope.lost_nothing_of(file, wrong)
        message = f"no node is called `{wrong.block.key.text}`: {wrong.owner} and runs with its defaults{same}"
        level = Severity.INFO if same or scope.readers.is_unopened(file) else None
        yield Hit(file.path, wrong.block.key.span, message, level, fix=renaming(file, wrong.block, wrong.intended))
    for file, block, name in scope.unread():
        message = f"no node is called `{block.key.text}`: this package's is `{name}`, and never reads the block"
        yield Hit(file.path, block.key.span, message, Severity.INFO, fix=renaming(file, block, name))
