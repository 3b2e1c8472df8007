"""Uses that are optional on purpose, that never run, or that an argument must turn on."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, manifest
from rospkg_cli.testing import lint_files

PYTHON = existing_files(BACKDROPS["ament_python"])
DECLARED = manifest("  <exec_depend>ros2launch</exec_depend>\n")
HEAD = """\
from ament_index_python.packages import get_package_share_directory, get_packages_with_prefixes
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction, IncludeLaunchDescription
from launch.conditions import IfCondition, LaunchConfigurationEquals, UnlessCondition
from launch.substitutions import LaunchConfiguration, PythonExpression
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


"""


def imports(text: str) -> list[str]:
    found = lint_files({**PYTHON, "package.xml": DECLARED, "my_pkg/a.py": text}, ["DEP101"]).findings
    return [finding.message.split("`")[1] for finding in found]


def launch(text: str, name: str = "launch/a.launch.py") -> list[tuple[str, str]]:
    found = lint_files({**PYTHON, "package.xml": DECLARED, name: text}, ["DEP103"]).findings
    return [(finding.severity.value, finding.message) for finding in found]


@pytest.mark.parametrize(
    "text",
    [
        "if False:\n    import cv2\n",
        "if 0:\n    import cv2\n",
        "if not True:\n    import cv2\n",
        "if True:\n    pass\nelse:\n    import cv2\n",
        "while False:\n    import cv2\n",
        "if False and ready():\n    import cv2\n",
        "if True or ready():\n    pass\nelse:\n    import cv2\n",
        "if 'cv2' in installed():\n    import cv2\n",
        "if has_module('cv2'):\n    import cv2\n",
        "if not has_module('cv2'):\n    pass\nelse:\n    import cv2\n",
    ],
)
def test_imports_that_need_not_happen(text: str) -> None:
    assert imports(text) == []


@pytest.mark.parametrize(
    "text",
    [
        "if True:\n    import cv2\n",
        "if ready():\n    import cv2\n",
        "if False or ready():\n    import cv2\n",
        "if True and ready():\n    import cv2\n",
        "if 'yaml' in installed():\n    import cv2\n",
        "if 'cv2':\n    import cv2\n",
        "if not False:\n    import cv2\n",
        "if False:\n    pass\nelse:\n    import cv2\n",
    ],
)
def test_imports_that_may_happen(text: str) -> None:
    assert imports(text) == ["python3-opencv"]


def described(*lines: str) -> str:
    return HEAD + "def generate_launch_description():\n" + "".join(f"    {line}\n" for line in lines)


NODE = "Node(package='joy', executable='joy_node')"


@pytest.mark.parametrize(
    "lines",
    [
        ["if 'joy' in get_packages_with_prefixes():", f"    return LaunchDescription([{NODE}])"],
        ["if 'joy' not in get_packages_with_prefixes():", "    return []", f"return LaunchDescription([{NODE}])"],
        ["there = 'joy' in get_packages_with_prefixes()", "if there:", f"    return LaunchDescription([{NODE}])"],
        [f"return LaunchDescription([{NODE}] if 'joy' in get_packages_with_prefixes() else [])"],
        ["if False:", f"    return LaunchDescription([{NODE}])"],
    ],
)  # fmt: skip
def test_launch_files_that_ask_first(lines: list[str]) -> None:
    assert launch(described(*lines)) == []


@pytest.mark.parametrize(
    "lines",
    [
        ["if 'teleop' in get_packages_with_prefixes():", f"    return LaunchDescription([{NODE}])"],
        ["if 'joy' not in get_packages_with_prefixes():", "    print('no joy')", f"return LaunchDescription([{NODE}])"],
        ["there = 'joy'", "if there:", f"    return LaunchDescription([{NODE}])"],
    ],
)
def test_launch_files_that_ask_for_something_else(lines: list[str]) -> None:
    assert [level for level, _ in launch(described(*lines))] == ["warning"]


def test_the_place_that_is_not_guarded_is_named() -> None:
    text = described(
        "nodes = []",
        "if 'joy' in get_packages_with_prefixes():",
        f"    nodes.append({NODE})",
        f"return LaunchDescription([*nodes, {NODE}])",
    )
    (finding,) = lint_files({**PYTHON, "package.xml": DECLARED, "launch/a.launch.py": text}, ["DEP103"]).findings
    assert finding.location.line == text.count("\n")


SIM = "DeclareLaunchArgument('sim', default_value='{}')"


def conditional(condition: str, default: str = "false") -> str:
    node = NODE.replace(")", f", condition={condition})")
    return described("sim = LaunchConfiguration('sim')", f"return LaunchDescription([{SIM.format(default)}, {node}])")


@pytest.mark.parametrize(
    "condition, default, argument",
    [
        ("IfCondition(sim)", "false", "sim:=true"),
        ("IfCondition(sim)", "False", "sim:=true"),
        ("IfCondition(sim)", "0", "sim:=true"),
        ("UnlessCondition(sim)", "true", "sim:=false"),
        ("LaunchConfigurationEquals('sim', 'gazebo')", "none", "sim:=gazebo"),
        ("IfCondition(PythonExpression([\"'\", sim, \"' == 'gazebo'\"]))", "none", "sim:=gazebo"),
        ("IfCondition(PythonExpression([\"'\", sim, \"' != 'none'\"]))", "none", "sim:=…"),
        ("IfCondition(PythonExpression(['not ', sim]))", "True", "sim:=false"),
        ("UnlessCondition(PythonExpression([\"'\", sim, \"' == 'none'\"]))", "none", "sim:=…"),
    ],
)
def test_what_an_argument_must_turn_on_is_an_info(condition: str, default: str, argument: str) -> None:
    ((level, message),) = launch(conditional(condition, default))
    assert (level, f"with `{argument}` it must be there" in message) == ("info", True), message


@pytest.mark.parametrize(
    "condition, default",
    [
        ("IfCondition(sim)", "true"),
        ("IfCondition(sim)", "maybe"),
        ("UnlessCondition(sim)", "false"),
        ("IfCondition(LaunchConfiguration('other'))", "false"),
        ("LaunchConfigurationEquals('sim', 'gazebo')", "gazebo"),
        ("LaunchConfigurationEquals('other', 'gazebo')", "none"),
        ("IfCondition(PythonExpression([\"'\", sim, \"' == 'gazebo'\"]))", "gazebo"),
        ('IfCondition(PythonExpression(["\'", sim, "\' in known()"]))', "none"),
        ('IfCondition(PythonExpression(["\'", sim, "\' == "]))', "none"),
    ],
)
def test_what_runs_by_default_is_a_warning(condition: str, default: str) -> None:
    assert [level for level, _ in launch(conditional(condition, default))] == ["warning"]


def test_a_group_turns_all_of_its_actions_off() -> None:
    group = f"GroupAction([{NODE}], condition=IfCondition(LaunchConfiguration('sim')))"
    ((level, _),) = launch(described(f"return LaunchDescription([{SIM.format('false')}, {group}])"))
    assert level == "info"


@pytest.mark.parametrize("find, level", [("FindPackageShare", "info"), ("get_package_share_directory", "warning")])
def test_a_function_runs_whatever_the_condition_is(find: str, level: str) -> None:
    condition = "IfCondition(LaunchConfiguration('sim'))"
    include = f"IncludeLaunchDescription([{find}('joy'), '/x.py'], condition={condition})"
    assert [each for each, _ in launch(described(f"return LaunchDescription([{SIM.format('false')}, {include}])"))] == [
        level
    ]


@pytest.mark.parametrize(
    "default, condition, level",
    [
        ("false", 'if="$(var sim)"', "info"),
        ("true", 'unless="$(var sim)"', "info"),
        ("none", "if=\"$(eval &quot;'$(var sim)' == 'gazebo'&quot;)\"", "info"),
        ("true", 'if="$(var sim)"', "warning"),
        ("false", 'unless="$(var sim)"', "warning"),
        ("false", "", "warning"),
    ],
)
@pytest.mark.parametrize("is_grouped", [False, True])
def test_conditions_of_xml(default: str, condition: str, level: str, is_grouped: bool) -> None:
    node = '<node pkg="joy" exec="joy_node" {}/>'
    inside = f"<group {condition}>{node.format('')}</group>" if is_grouped else node.format(condition)
    text = f'<launch><arg name="sim" default="{default}"/>{inside}</launch>\n'
    assert [each for each, _ in launch(text, "launch/a.launch.xml")] == [level]


def test_a_use_by_default_is_named_before_one_that_an_argument_turns_on() -> None:
    node = '<node pkg="joy" exec="joy_node" {}/>\n'
    nodes = node.format('if="$(var sim)"') + node.format("")
    text = f'<launch><arg name="sim" default="false"/>\n{nodes}</launch>\n'
    (finding,) = lint_files({**PYTHON, "package.xml": DECLARED, "launch/a.launch.xml": text}, ["DEP103"]).findings
    assert (finding.severity.value, finding.location.line) == ("warning", 3)


NEVER = f"joy = {NODE}"


@pytest.mark.parametrize(
    "lines, level",
    [
        ((NEVER, "return LaunchDescription([])"), None),
        ((NEVER, "nodes = [", "    # joy,", "]", "return LaunchDescription(nodes)"), None),
        ((NEVER, "return LaunchDescription([joy])"), "warning"),
        ((NEVER, f"return LaunchDescription([{NODE}])"), "warning"),
        (("share = FindPackageShare('joy')", "return LaunchDescription([])"), None),
        (("share = get_package_share_directory('joy')", "return LaunchDescription([])"), "warning"),
    ],
)
def test_what_is_never_added_is_no_use(lines: tuple[str, ...], level: str | None) -> None:
    assert [found for found, _ in launch(described(*lines))] == ([level] if level else [])
