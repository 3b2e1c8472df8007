"""PRM006 parameter-type-mismatch."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.params.declaring_packages import ParameterContext, given_type
from ...example import Example
from ...finding import Edit, Fix, Hit, Safety, Severity
from ...languages.yaml.nodes import ScalarNode, SequenceNode
from ...lazy_regex import regex
from ...package.params.parameter_file import Parameter
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


def example(bad: str, good: str, fix: Safety | None = None) -> Example:
    files = {"include/my_pkg/talker.hpp": NODE, "config/robot.yaml": GOOD.replace(good, bad)}
    return Example(on="config", bad=files, good={"config/robot.yaml": GOOD}, fix=fix)


@rule(
    "PRM006",
    "parameter-type-mismatch",
    over=ParameterContext,
    severity=Severity.WARNING,
    examples=(
        example("rate: «50»", "rate: 50.0", Safety.SAFE),
        example("frames: «odom»", "frames: [odom]"),
    ),
)
def parameter_type_mismatch(scope: ParameterContext) -> Iterator[Hit]:
    """
    ## What it does
    Finds values in a parameter file whose type differs from the declared type.
    Types are declared by `declare_parameter` and its like in C++ and Python, and by definitions for
    generate_parameter_library.

    ## Why is this bad?
    A parameter never changes its type. `50` is an integer, and a node that declared a double stops when it starts:
    "parameter 'rate' has invalid type".

    ## When it is quiet
    A block belongs to a package that declares most of its names: to this one, to one that it depends on, or by at least
    three names. Where declarations differ, a type is not known, or a launch file fills the value in, nothing is said.
    """
    for group in scope.groups():
        for parameter in group.parameters:
            given, wanted = given_type(parameter.value), group.wanted_type(parameter)
            if wanted is not None and given and given != wanted[0]:
                message = f"`{parameter.name}` is declared as {wanted[0]} in `{wanted[1].path}`"
                fix = as_double(group.file.path, parameter) if (given, wanted[0]) in INTEGERS else None
                what = f"{message}: {article(given)} stops the node when it starts; write {article(wanted[0])}"
                yield Hit(group.file.path, parameter.value.span, what, fix=fix)


def article(kind: str) -> str:
    """Return a type with its article: "a list of double", "an int"."""
    one = kind.removesuffix("[]")
    return f"a list of {one}" if one != kind else f"an {one}" if one == "int" else f"a {one}"


INTEGERS = (("int", "double"), ("int[]", "double[]"))
DECIMAL = regex(r"[+-]?(?:0|[1-9][0-9]*)")


def as_double(path: str, parameter: Parameter) -> Fix | None:
    """Put `.0` behind whole numbers that are written in decimal."""
    value = parameter.value
    items = value.items if isinstance(value, SequenceNode) else [value]
    numbers = [item for item in items if isinstance(item, ScalarNode) and DECIMAL.fullmatch(item.text)]
    if len(numbers) != len(items):
        return None
    edits = tuple(Edit(path, number.span, f"{number.text}.0") for number in numbers)
    return Fix("write it with `.0`", edits)
