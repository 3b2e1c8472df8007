"""URD001: a robot with blanks that an exercise or a template leaves is still to be filled in."""

from __future__ import annotations

import pytest

from rospkg_cli.checks.python.blank_names import is_blank
from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

INSTALLS = "install(DIRECTORY launch urdf DESTINATION share/${PROJECT_NAME})\nament_package"
FILES = {
    "package.xml": manifest("", "ament_cmake"),
    "CMakeLists.txt": CMAKE.replace("ament_package", INSTALLS),
    "launch/a.launch.xml": '<launch>\n  <let name="a" value="$(find-pkg-share my_pkg)/urdf/r.urdf"/>\n</launch>\n',
}
ROBOT = """\
<robot name="r">
  <link name="base"/>
  <link name="wheel"/>
  <joint name="axle" type="continuous">
    <parent link="{}"/>
    <child link="wheel"/>
    <axis xyz="{}"/>
  </joint>
</robot>
"""


@pytest.mark.parametrize(
    ("parent", "axis", "level"),
    [
        ("bse", "0 1 0", "error"),
        ("___TODO___", "0 1 0", "info"),
        ("FILL_ME", "0 1 0", "info"),
        ("bse", "XXX", "info"),
        ("todo_list", "0 1 0", "error"),
    ],
)
def test_a_link_that_is_not_there(parent: str, axis: str, level: str) -> None:
    found = lint_files({**FILES, "urdf/r.urdf": ROBOT.format(parent, axis)}, ["URD001"]).findings
    (finding,) = [each for each in found if each.message.startswith("no link is called")]
    assert finding.severity.value == level
    assert finding.message.endswith("; it is still to be filled in") == (level == "info")


@pytest.mark.parametrize("text", ["TODO", "<TODO>", "todo", "XXX", "___", "??", "FILL_ME_IN", "your_value_here", "tbd"])
def test_a_blank(text: str) -> None:
    assert is_blank(text)


@pytest.mark.parametrize("text", ["", "xxx", "XX", "_", "todos", "fill", "x", "tbd_link"])
def test_a_name(text: str) -> None:
    assert not is_blank(text)
