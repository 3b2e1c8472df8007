"""PRM007 unknown-parameter."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.params.idle_nodes import hardest
from ...checks.params.launched_names import unknown_to_known
from ...checks.params.unchanged_values import declared_defaults, same_as_default, value_text
from ...checks.params.unknown_parameters import UnknownParameters, unread
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
        Severity.INFO: "older releases had it, the value is the default, or probably is, nothing uses the meant one, "
        "names the file, adds the action or reads block or variable, nothing leads to the code, only the block's name "
        "tells the node, no list has the plugin, or the repository is for Crystal",
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
    it; or a name is longer by a word of its block, as `segmentation.min_points_segment`. Names in launch files are
    compared with what the node's package declares. Well-known packages are known without their sources, and
    `use_sim_time` is of every node; so are the names in `joint_limits.yaml`. So is the one name in which two files of
    one name differ, where the code declares the other one's. Slashes of ROS 1 stand for dots, and no name ends with the
    `:=` of the command line. In code `get_parameter` is checked likewise: the file declares a similar name without
    getting it, or it makes its node, and the name stands nowhere else in the package's code. A name that is got twice
    is found at the place of a second one, which is declared there, and whose name stands nowhere else.

    ## Why is this bad?
    The value is dropped, and the node runs with its default; or it stops, or a variable is never set.

    ## When it is quiet
    A block belongs to a package that declares most of its names: to this one, to one that it depends on, or by at least
    three names; files that only code opens have none. Code is left alone where nodes allow undeclared parameters, or
    names of them are computed; where it asks a client or another object, other packages may choose the options of a
    node, or what gets the node may declare them. Where its base class elsewhere may, or it asks first, it is an info.
    One that is got into a variable, has an alternative, is like no other, or whose exception may be caught, or under a
    condition, is a warning; one that nothing reads is an info, and so is what stands in code that nothing leads to; a
    value in a block that no started (and, in nav2, configured) node reads, or that the package's code may read
    otherwise: its name stands there, is made, or differs by a number; and one that changes nothing: it is the default
    of the parameter that is meant, as the code or a table has it (where none is known, false, 0, an empty text and
    list), the code never uses that one, its switch is off, launch files give it, or a comment calls the value unused.
    So is a limit of a joint in a file that nothing names, and what a plugin gets that no list has. Like all that two
    packages must agree on, it is one where a page says that faults are planted on purpose.

    ## Fix safety
    The similar name may not be right; tests of the package that have the other one leave none. A value of another type
    stays, a single one for a list is put into brackets.
    """
    for group in scope.given.groups():
        for parameter, meant in group.unknown():
            yield dropped_in_file(scope, group, parameter, meant)
    for file, parameter, meant, other in scope.unlike_variants():
        same = same_as_default(value_text(parameter.value), meant, declared_defaults([scope.given.package], meant))
        message = f"`{scope.given.package.name}` declares no parameter `{parameter.name}`: the value is dropped{same}"
        level = Severity.INFO if same or scope.readers.is_idle(file.path, parameter.key.span) else None
        yield Hit(file.path, parameter.key.span, f"{message}; `{other}` has `{meant}` in its place", level)
    names = (*scope.launched.unknown(), *unknown_to_known(scope.known))
    yield from (
        dropped_value(scope, each) for each in hardest(((each.path, each.span, each.meant), each) for each in names)
    )
    for path, fault in (*scope.strange_names(), *scope.repeated_reads()):
        yield from hits(path, [fault])
    for limit in scope.joints.mistyped():
        others = tuple(Related(limit.path, span, "and here") for span in limit.others)
        yield Hit(limit.path, limit.span, unread(limit), None if limit.is_met else Severity.INFO, others)
    for read in scope.unknown_reads():
        softer, what = scope.told_of(read)
        yield Hit(read.path, read.span, what, Severity(softer), also(read.path, (span for _, span in read.more)))
