"""What Python code may get of the parameters that it declares, and when PRM007 is quiet."""

from __future__ import annotations

from rospkg_cli.example import Example
from rospkg_cli.rules.params import prm007_unknown_parameter as prm007

GETS = "self.get_parameter({})"
DECLARES = "self.declare_parameter('rate', 10.0)"


def node(gets: str, declares: str = DECLARES, before: str = "") -> Example:
    text = prm007.PYTHON.replace(GETS, gets).replace(DECLARES, declares)
    return Example(bad={"package.xml": prm007.NEEDED, "my_pkg/talker.py": before + text}, good={})


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
        node("self.get_parameter('a_b')", "self.declare_parameters('a', [('b', 1.0)])"),
    ),
}  # fmt: skip
