"""PRM007 unknown-parameter."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.params.declaring_packages import ParameterContext
from ...edits.plain_names import only_plain_names
from ...example import Example
from ...finding import Edit, Fix, Hit, Safety, Severity
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
    over=ParameterContext,
    severity=Severity.WARNING,
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
    ),
)
def unknown_parameter(scope: ParameterContext) -> Iterator[Hit]:
    """
    ## What it does
    Finds values for parameters that no code declares, where a similar name is declared.
    The package that declares the other parameters of the block declares the similar one, and the block does not give
    it. In C++ `get_parameter` is checked likewise: a name that is not declared, in a file that declares a similar one
    without getting it.

    ## Why is this bad?
    There is no warning: the value is dropped, and the node runs with its default; or it stops with a
    ParameterNotDeclaredException, or goes on with a variable that was never set.

    ## Fix safety
    The similar name may not be the right one.
    """
    for group in scope.groups():
        for parameter, meant in group.unknown():
            whose = group.owners[0].name
            last = meant.rpartition(".")[2]
            message = (
                f"`{whose}` declares no parameter `{parameter.name}`: the value is dropped (did you mean `{last}`?)"
            )
            fix = None
            if parameter.key.text == parameter.name.rpartition(".")[2]:
                edit = Edit(group.file.path, parameter.key.span, last)
                fix = Fix(f"write `{last}`", (edit,), Safety.UNSAFE)
            yield Hit(group.file.path, parameter.key.span, message, fix=only_plain_names(fix, last))
    for read in scope.unknown_reads():
        other = f"this file declares `{read.suggestion}` and never gets it"
        message = f"nothing declares the parameter `{read.name}`; {other}"
        yield Hit(read.path, read.span, message)
