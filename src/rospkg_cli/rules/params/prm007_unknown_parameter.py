"""PRM007 unknown-parameter."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.params.idle_nodes import hardest
from ...checks.params.known_names import unknown_to_known
from ...checks.params.unchanged_values import declared_defaults, same_as_default, value_text
from ...checks.params.unknown_parameter_texts import unread
from ...checks.params.unknown_parameters import UnknownParameters
from ...edits.dropped_values import also, dropped_in_file, dropped_value
from ...edits.fault_hits import hits
from ...example import Example, manifest
from ...finding import Hit, Related, Safety, Severity
from ...rule import rule

NODE = """\
class Talker : public rclcpp::Node
{
public:
  Talker() : Node("talker")
  {
    declare_parameter("rate", 10.0);
    declare_parameter("global_frame", "map");
    declare_parameter("verbose", false);
  }
};
"""
NEEDED = manifest("  <exec_depend>rclpy</exec_depend>\n")
PYTHON = """\
import rclpy.node


class Talker(rclpy.node.Node):
    def __init__(self):
        super().__init__('talker')
        self.declare_parameter('rate', 10.0)
        self.rate = self.get_parameter({}).value
"""
GOOD = """\
talker:
  ros__parameters:
    rate: 50.0
    global_frame: odom
    verbose: true
"""


@rule(
    "PRM007",
    "unknown-parameter",
    over=UnknownParameters,
    severity=Severity.WARNING,
    levels={
        Severity.ERROR: "code gets a parameter that is not declared, and nothing may catch what it throws",
        Severity.INFO: "older releases had it, the value is the default, or probably is, nothing uses the other one, "
        "names the file, adds the action or reads block or variable, nothing leads to the code, only the block's name "
        "shows the node, no list has the plugin, or the repository is for Crystal",
    },
    examples=(
        Example(
            on="config",
            bad={
                "include/my_pkg/talker.hpp": NODE,
                "config/robot.yaml": GOOD.replace("global_frame", "«global_flame»"),
            },
            good={"config/robot.yaml": GOOD},
            fix=Safety.UNSAFE,
        ),
        Example(
            on="ament_cmake",
            bad={"include/my_pkg/talker.hpp": NODE.replace("  }\n", '    get_parameter(«"verbos"», verbose_);\n  }\n')},
            good={"include/my_pkg/talker.hpp": NODE.replace("  }\n", '    get_parameter("verbose", verbose_);\n  }\n')},
        ),
        Example(
            bad={"package.xml": NEEDED, "my_pkg/talker.py": PYTHON.format("«'rat'»")},
            good={"my_pkg/talker.py": PYTHON.format("'rate'")},
        ),
    ),
)
def unknown_parameter(scope: UnknownParameters) -> Iterator[Hit]:
    """
    ## What it does
    Finds values for parameters that no code declares, where a similar name is declared.
    The package that declares the other parameters of the block declares the similar one, and the block does not give
    it; or the name repeats a word of its block, as `segmentation.min_points_segment`. Names in launch files are
    compared with what the node's package declares. Known without their sources are well-known packages, `use_sim_time`,
    which every node has, and the names in `joint_limits.yaml`. It also finds the one name in which two files of one
    name differ, where the code declares the other one's; slashes of ROS 1 where names have dots; and names that end
    with the `:=` of the command line. In code it checks `get_parameter`: the file declares a similar name that it does
    not get, or it makes its node, and the name occurs nowhere else in the package's code; or a name is got twice, the
    second time where another one is declared, whose name occurs nowhere else.

    ## Why is this bad?
    The value is dropped, and the node runs with its default; or it stops, or a variable is never set.

    ## When it is quiet
    A block belongs to the package that declares most of its names: this one, one that it depends on, or any by at least
    three names. Left alone are files that only code opens, and code where nodes allow undeclared parameters, names are
    computed, a client or another object is asked, other packages may choose the options of a node, or what gets the
    node may declare them. What code gets into a variable or with an alternative, what is like no other name, is under
    a condition or may be caught, is a warning.

    It is an info

    - where a base class elsewhere may declare it, the code asks first, nothing reads the variable, or nothing leads to
      the code;
    - for a value in a block that no started (and, in nav2, configured) node reads, or that the package's code may read
      otherwise: its name occurs there, is computed, or differs by a number;
    - for a value that changes nothing: it is the default of the intended parameter (where none is known: false, 0, an
      empty text or list), the code never uses that one, its switch is off, launch files give it, or it is unused;
    - for a joint limit in a file that nothing names, a plugin that no list has, and faults planted as a page says.

    ## Fix safety
    The similar name may not be right; tests of the package that have the other one leave none. A value of another type
    stays, a single one for a list is put into brackets.
    """
    for group in scope.given.groups():
        for parameter, intended in group.unknown():
            yield dropped_in_file(scope, group, parameter, intended)
    for file, parameter, intended, other in scope.unlike_variants():
        same = same_as_default(
            value_text(parameter.value), intended, declared_defaults([scope.given.package], intended)
        )
        message = f"`{scope.given.package.name}` declares no parameter `{parameter.name}`: the value is dropped{same}"
        level = Severity.INFO if same or scope.readers.is_idle(file.path, parameter.key.span) else None
        yield Hit(file.path, parameter.key.span, f"{message}; `{other}` has `{intended}` in its place", level)
    names = (*scope.launched.unknown(), *unknown_to_known(scope.known))
    yield from (
        dropped_value(scope, each) for each in hardest(((each.path, each.span, each.intended), each) for each in names)
    )
    for path, fault in (*scope.strange_names(), *scope.repeated_reads()):
        yield from hits(path, [fault])
    for limit in scope.joints.mistyped():
        others = tuple(Related(limit.path, span, "and here") for span in limit.others)
        yield Hit(limit.path, limit.span, unread(limit), None if limit.is_met else Severity.INFO, others)
    for read in scope.unknown_reads():
        softer, what = scope.level_and_message(read)
        yield Hit(read.path, read.span, what, Severity(softer), also(read.path, (span for _, span in read.more)))
