"""What a launch file chooses only where an argument or a variable has another value is an info (DEP103)."""

from __future__ import annotations

import pytest
from test_off_by_default import HEAD, told, with_argument

NODE = "Node(package='joy', executable='joy_node')"
FILE = """

def setup(context):
    kind = LaunchConfiguration('cam').perform(context)
    {}


def generate_launch_description():
    return LaunchDescription([DeclareLaunchArgument('cam', default_value='none'), OpaqueFunction(function=setup)])
"""
HEAD = HEAD.replace("JOY = Node(package='joy', executable='joy_node')\n", "")
MATCH = f"match kind:\n        case {{}}:\n            return [{NODE}]\n        case {{}}:\n            return []"
TABLE = "table = {{'usb': {}, {}: None}}\n    " + "return [table{}]"


@pytest.mark.parametrize(
    ("lines", "argument"),
    [
        (MATCH.format("'usb'", "'none'"), "cam:=usb"),
        (MATCH.format("'usb' | 'csi'", "_"), "cam:=usb"),
        (MATCH.format("'none'", "_"), ""),
        (MATCH.format("str()", "'none'"), ""),
        (MATCH.format("'usb' if wanted", "'none'"), ""),
        (TABLE.format(NODE, "'none'", "[kind]"), "cam:=usb"),
        (TABLE.format(NODE, "'none'", ".get(kind)"), "cam:=usb"),
        (TABLE.format(NODE, "'none'", "['usb']"), ""),
        (TABLE.format(NODE, "'none'", "[kind], *table.values()"), ""),
        (TABLE.format(NODE, "'none'", "[other]"), ""),
        (f"return [{NODE} if kind == 'usb' else None]", "cam:=usb"),
        (f"return [{NODE} if kind == 'none' else None]", ""),
        (f"return [None if kind == 'none' else {NODE}]", "cam:=…"),
        (f"return [{NODE} if os.environ.get('SIM', '0') == '1' else None]", "SIM=1"),
    ],
)
def test_choices(lines: str, argument: str) -> None:
    level, message = told(HEAD + FILE.format(lines), "launch/a.launch.py")
    assert (level, with_argument(message)) == ("info" if argument else "warning", argument)
