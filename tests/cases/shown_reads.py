"""What Python code may get of the parameters that it declares, and when PRM007 is quiet."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example
from rospkg_cli.rules.params import prm007_unknown_parameter as prm007

GETS = "self.get_parameter({})"
DECLARES = "self.declare_parameter('rate', 10.0)"


def node(gets: str, declares: str = DECLARES, before: str = "") -> Example:
    text = prm007.PYTHON.replace(GETS, gets).replace(DECLARES, declares)
    return Example(bad={"package.xml": prm007.NEEDED, "my_pkg/talker.py": before + text}, good={})


def declares(name: str) -> str:
    return f"\n        self.declare_parameter('{name}', 1.0)"


def gets(name: str, target: str = "") -> str:
    return f"\n        self.{target or name} = self.get_parameter('{name}').value"


PAIRS = f"{DECLARES}{gets('rate')}{declares('gain')}{{}}"
ROW = f"{DECLARES}{declares('gain')}{gets('rate')}{{}}"
LATER = "\n\n    def tick(self):"
AGAIN = gets("rate", "gain")


def paired(after: str, form: str = PAIRS, before: str = "") -> Example:
    return node("1.0", form.format(after), before)


CPP = """\
#include "rclcpp/rclcpp.hpp"

Talker::Talker() : Node("talker")
{
  this->declare_parameter("rate", 10.0);
  this->get_parameter("rate", rate_);
  %sdeclare_parameter("gain", 1.0);
  %s
}
"""


def paired_cpp(gets: str, before: str = "this->", more: str = "") -> Example:
    build = CMAKE.replace("ament_package", "add_library(talker src/talker.cpp)\nament_package")
    code = CPP % (before, gets) + more
    return Example(bad={"CMakeLists.txt": build, "src/talker.cpp": code}, good={}, on="ament_cmake")


TRIES = "try:\n    import yaml\nexcept {}:\n    yaml = None\n"

CASES = {
    "PRM007": (
        node("self.get_parameter_or('rat', 1)"),
        *(node("self.get_parameter('rat')", before=TRIES.format(caught))
          for caught in ("ImportError", "Exception", "(KeyError, ParameterNotDeclaredException)")),
        node("self.get_parameter('rat')", before="import yaml\n\nhas_parameter = True\n"),
        node("self.get_parameter('rat')", DECLARES + "\n        self.get_parameter('rate')"),
        node("self.get_parameter('frame_id')"),
        node("self.get_parameter('rate')", f"{DECLARES}\n        self.declare_parameter('rates', [10.0])"),
        node("self.get_parameter(name)"),
        node("self.get_parameter('rat')", "self.declare_parameters('', [('rate', 1.0), ('frame_id', 'map')])"),
        node("self.get_parameter('rat')", "self.declare_parameters('', [('rate', 1.0), (other, 'map')])"),
        node("self.get_parameter('rat')", f"{DECLARES}\n        self.declare_parameters('', names)"),
        node("self.get_parameter('rat')", f"{DECLARES}\n        self.declare_parameter(name, 1)"),
        node("self.get_parameter('rat')", before="OPTIONS = 'allow_undeclared_parameters'\n"),
        paired(AGAIN),
        paired(AGAIN, ROW),
        paired(gets("gain")),
        paired(gets("rate")),
        paired(AGAIN + gets("gain", "other")),
        *(paired(LATER + AGAIN, form) for form in (PAIRS, ROW)),
        paired(AGAIN, before="GAIN = 'gain'\n"),
        paired(AGAIN + gets("rates")),
        paired(AGAIN + "\n        self.get_parameters(names)"),
        paired(AGAIN, PAIRS.replace("self.declare_parameter('gain'", "self.gain = self.declare_parameter('gain'")),
        paired(AGAIN + "\n        self.more = self.get_parameter(name)"),
        paired_cpp('this->get_parameter("rate", gain_);'),
        paired_cpp('gain_ = get_parameter("rate").as_double();'),
        paired_cpp('get_parameter("rate", rate_);'),
        paired_cpp('get_parameter("rate", gain_);', "gain_ = "),
        paired_cpp('}\nvoid Talker::tick()\n{\n  get_parameter("rate", gain_);'),
        paired_cpp('get_parameter("rate", gain_);', more='const char * GAIN = "gain";\n'),
        node("self.get_parameter('a_b')", "self.declare_parameters('a', [('b', 1.0)])"),
    ),
}  # fmt: skip
