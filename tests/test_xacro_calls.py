"""What is wrong in xacro only counts where xacro evaluates it: in macros that are called, properties that are read."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest
from rospkg_cli.testing import lint_files

HEAD = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="r">'
BAD = '<joint name="j" type="revolute"><parent link="a"/><child link="b"/></joint>'
FACED = '<joint name="j"><command_interface name="position"/></joint>'
MACRO = '<xacro:macro name="{}" params="p">{}</xacro:macro>'


def said(**bodies: str) -> list[tuple[str, str]]:
    """Lint robots, each by the name of its file, and return level and message of each finding; `b` has no name.

    A launch file opens all of them.
    """
    heads = {name: HEAD.replace(' name="r"', "") if name == "b" else HEAD for name in bodies}
    files = {f"urdf/{name}.xacro": f"{heads[name]}{body}</robot>\n" for name, body in bodies.items()}
    files["launch/all.launch.py"] = "".join(
        f"{name.upper()} = '{path}'\n" for name, path in zip(bodies, files, strict=True)
    )
    files["launch/control.sh"] = "ros2 run controller_manager ros2_control_node\n"
    found = lint_files({"package.xml": manifest(), **files}, ["URD001"]).findings
    return [(finding.severity.value, finding.message) for finding in found]


@pytest.mark.parametrize(
    "body",
    [
        MACRO.format("wheel", FACED),
        MACRO.format("wheel", '<joint name="${p}_j"/>'),
        MACRO.format("drive", '<xacro:if value="${p}">' + FACED + "</xacro:if>"),
        FACED,
        FACED * 2,
        '<link name="a"/><ros2_control name="c"><joint name="elsewhere"/></ros2_control>',
    ],
)
def test_joints_for_ros2_control_may_lie_in_a_file_of_their_own(body: str) -> None:
    include = '<link name="a"/><xacro:include filename="$(find elsewhere)/part.xacro"/>'
    assert said(robot=f'{include}<ros2_control name="c"><xacro:wheel p="l"/></ros2_control>', part=body) == []


def test_a_robot_that_nothing_includes_has_all_its_joints() -> None:
    body = '<link name="a"/><ros2_control name="c"><joint name="elsewhere"/></ros2_control>'
    ((level, message),) = said(robot=body)
    assert (level, "`elsewhere`" in message) == ("info", True)
    joint = '<link name="b"/><joint name="elsewhere" type="fixed"><parent link="a"/><child link="b"/></joint>'
    assert said(piece=body, robot=f'{joint}<xacro:include filename="piece.xacro"/>') == []
    told = said(piece=body, robot='<link name="b"/><xacro:include filename="piece.xacro"/>')
    assert told == [("info", "no joint of the robot is called `elsewhere`: ros2_control looks for it in vain")]


def test_joints_that_a_file_gives_to_ros2_control_in_vain_are_one_fault() -> None:
    body = '<link name="a"/><ros2_control name="c"><joint name="elsewhere"/><joint name="nowhere"/></ros2_control>'
    ((_, message),) = said(robot=body)
    assert message.endswith(": ros2_control looks for it in vain; 1 more is not there either")


@pytest.mark.parametrize("missing", [' type="revolute"', '<parent link="a"/>', '<child link="b"/>'])
def test_a_joint_with_one_part_of_urdf_is_one_of_urdf(missing: str) -> None:
    """Without its type a joint is refused; what else is missing is told where the robot is whole."""
    assert bool(said(robot=BAD.replace(missing, ""))) is True


@pytest.mark.parametrize(
    "bodies, level, when",
    [
        ({"a": BAD}, "error", ""),
        ({"a": MACRO.format("wheel", BAD)}, "info", ", as soon as something calls the macro `wheel`"),
        ({"a": MACRO.format("xacro:wheel", BAD), "b": "<xacro:wheel/>"}, "error", ""),
        ({"a": MACRO.format("wheel", BAD), "b": "<xacro:wheel/>"}, "error", ""),
        ({"a": MACRO.format("wheel", BAD), "b": "<xacro:parts.wheel p='1'/>"}, "error", ""),
        ({"a": MACRO.format("wheel", BAD), "b": "<xacro:wheel_left/>"}, "info", "the macro `wheel`"),
        ({"a": f'<xacro:if value="$(arg x)">{BAD}</xacro:if>'}, "info", ", where the condition around it holds"),
        ({"a": f'<xacro:unless value="$(arg x)">{BAD}</xacro:unless>'}, "info", "around it holds"),
        ({"a": '<xacro:if value="${x"><link name="a"/></xacro:if>'}, "error", "xacro stops here"),
        ({"a": '<xacro:property name="x" value="${y"/>'}, "info", ", as soon as something reads `x`"),
        ({"a": '<xacro:property name="x" value="${y" lazy_eval="false"/>'}, "error", "xacro stops here"),
        ({"a": '<xacro:property name="x" value="${y"/><link name="${x}"/>'}, "error", "xacro stops here"),
        ({"a": '<xacro:property name="x" value="${y"/>', "b": "<link name='${2 * x}'/>"}, "error", ""),
        ({"a": '<xacro:property name="x" value="${arg x}"/>'}, "info", ", as soon as something reads `x`"),
        ({"a": '<xacro:property name="x" value="${arg x}"/><link name="${x}"/>'}, "error", "xacro stops here"),
        ({"a": '<xacro:property name="x"><a b="${arg x}"/></xacro:property>'}, "info", "reads `x`"),
        ({"a": '<xacro:property name="x"><a>${arg x}</a></xacro:property>'}, "info", "reads `x`"),
        ({"a": '<xacro:property name="x"><a b="${y"/></xacro:property>'}, "info", "reads `x`"),
        (
            {"a": '<xacro:property name="x"><a b="${y"/></xacro:property>', "b": '<xacro:insert_block name="x"/>'},
            "error",
            "xacro stops here",
        ),
    ],
)
def test_the_level_is_that_of_the_place(bodies: dict[str, str], level: str, when: str) -> None:
    ((found, message),) = said(**bodies)
    assert found == level
    assert message.endswith(when)
    assert ("as soon as" in message or "the condition" in message) is (level != "error")


def test_only_what_xacro_reads_is_read_as_xacro() -> None:
    """Something else may fill `$(…)` of a plain URDF in."""
    text = '<robot name="r"><link name="a"><p>$(COMMAND)</p></link></robot>\n'
    files = {"package.xml": manifest(), "urdf/a.urdf": text}
    assert lint_files(files, ["URD001"]).findings == ()
    marked = text.replace(' name="r">', ' xmlns:xacro="http://www.ros.org/wiki/xacro" name="r"><xacro:arg name="a"/>')
    assert lint_files({**files, "urdf/a.urdf": marked}, ["URD001"]).findings


def test_a_file_that_cannot_be_read_hides_no_other() -> None:
    files = {"package.xml": manifest(), "urdf/a.xacro": f"{HEAD}{BAD}</robot>\n", "urdf/b.xacro": "<robot"}
    found = lint_files(files, ["URD001"]).findings
    assert [finding.location.path for finding in found] == ["urdf/a.xacro"]


@pytest.mark.parametrize(
    ("include", "launch", "expected"),
    [
        ('<xacro:include filename="arms/$(arg arm).xacro"/>', "", []),
        ('<xacro:include filename="${place}"/>', "", []),
        ('<xacro:include filename="arms/other_$(arg arm).xacro"/>', "", ["info"]),
        ('<xacro:include filename="arms/$(arg arm).xacro"/>', "ROBOT = 'arm.xacro'\n", ["error"]),
    ],
)
def test_what_may_be_included_under_a_computed_name_has_what_its_includer_sets(
    include: str, launch: str, expected: list[str]
) -> None:
    files = {
        "package.xml": manifest(),
        "urdf/robot.xacro": f'{HEAD}<xacro:property name="offset" value="1"/><link name="a"/>{include}</robot>\n',
        "urdf/arms/arm.xacro": f'{HEAD}<link name="l_${{offset_}}"/></robot>\n'.replace("offset_", "offset"),
        "launch/a.launch.py": launch,
    }
    found = [each for each in lint_files(files, ["URD001"]).findings if "offset" in each.message]
    assert [each.severity.value for each in found] == expected


@pytest.mark.parametrize(
    "body, level",
    [
        ('<gazebo reference="somewhere"/>', "info"),
        ('<xacro:if value="$(arg x)"><gazebo reference="somewhere"/></xacro:if>', "info"),
        ('<gazebo reference="base_lnk"/>', "info"),
        ('<xacro:if value="$(arg x)"><gazebo reference="base_lnk"/></xacro:if>', "info"),
    ],
)
def test_a_condition_makes_what_gazebo_leaves_out_no_worse(body: str, level: str) -> None:
    (found,) = said(a=f'<xacro:arg name="x" default=""/><link name="base_link"/>{body}')
    assert found[0] == level
    assert found[1].endswith(", where the condition around it holds") is ("xacro:if" in body)


@pytest.mark.parametrize("prefix, expected", [("", ["error"]), ("xacro:", [])])
def test_what_is_defined_without_its_prefix(prefix: str, expected: list[str]) -> None:
    defined = f'<{prefix}property name="w" value="1"/><{prefix}property name="h" value="1"/>'
    found = said(robot=f'{defined}<link name="a${{w}}"/><link name="b${{h}}"/>' + "<joint name='j' type='fixed'>"
                 "<parent link='a${w}'/><child link='b${h}'/></joint>")  # fmt: skip
    assert [level for level, _ in found] == expected
    assert all("the `<property>` that defines this lacks its `xacro:`" in message for _, message in found)
    macro = f'<{prefix}macro name="wheel"><link name="a"/></{prefix}macro><xacro:wheel/>'
    assert [level for level, _ in said(robot=macro)] == expected


def test_calls_without_one_parameter_are_one_fault() -> None:
    head = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="r">'
    macros = "".join(
        f'<xacro:macro name="{name}" params="side {more}"/>' for name, more in (("a", ""), ("b", ""), ("c", "d"))
    )
    calls = "\n".join(["<xacro:a/>", "<xacro:b/>", "<xacro:a/>", "<xacro:b/>", '<xacro:c side="1"/>'])
    files = {"package.xml": manifest(), "urdf/r.xacro": f'{head}\n<link name="l"/>{macros}\n{calls}\n</robot>\n'}
    found = {each.message: len(each.related) for each in lint_files(files, ["URD001"]).findings}
    idle = ", as soon as something opens this robot"
    assert found == {
        f"the macros `a` and `b` need their parameter `side`: xacro stops here{idle}": 3,
        f"the macro `c` needs its parameter `d`: xacro stops here{idle}": 0,
    }
