"""What a plain `ros2 launch` never visits is no error: actions that nothing adds, or whose condition is off."""

from __future__ import annotations

import pytest

from rospkg_cli.checks.launch.idle_actions import CONDITIONAL, IN_BRANCH, NEVER_ADDED, OFF
from rospkg_cli.example import manifest
from rospkg_cli.testing import lint_files

IMPORTS = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.conditions import IfCondition, UnlessCondition
from launch.substitutions import EnvironmentVariable, LaunchConfiguration, PythonExpression
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


"""
PYTHON = (
    IMPORTS
    + """\
def generate_launch_description():
    sim = LaunchConfiguration('sim')
    node = Node(package='my_pkg', executable='missing'{condition})
    return LaunchDescription([
        DeclareLaunchArgument('sim', default_value='{default}'),
        {added}
    ])
"""
)
XML = """\
<launch>
  <arg name="sim" default="{default}"/>
  <node pkg="my_pkg" exec="missing" {condition}/>
</launch>
"""
HINT = "; it installs no executable at all; `rospkg add node missing` writes one"


def levels(text: str, path: str = "launch/a.launch.py", code: str = "LCH002") -> list[tuple[str, str]]:
    files = {"package.xml": manifest(), "setup.py": SETUP, "my_pkg/__init__.py": "", path: text}
    files["start.sh"] = f"ros2 launch {path}\n"
    return [(each.severity.value, each.message) for each in lint_files(files, [code]).findings]


START = "ros2 launch launch/a.launch.py\n"
SETUP = "from setuptools import setup\n\nsetup(name='my_pkg', version='0.1.0', packages=['my_pkg'])\n"


@pytest.mark.parametrize(
    "condition, default, level",
    [
        ("", "true", "error"),
        (", condition=IfCondition(sim)", "true", "error"),
        (", condition=IfCondition(sim)", "True", "error"),
        (", condition=IfCondition(sim)", "false", "info"),
        (", condition=IfCondition(sim)", "0", "info"),
        (", condition=IfCondition(sim)", "1", "error"),
        (", condition=UnlessCondition(sim)", "1", "info"),
        (", condition=UnlessCondition(sim)", "false", "error"),
        (", condition=IfCondition('false')", "true", "info"),
        (", condition=None", "false", "error"),
        (""", condition=IfCondition(PythonExpression(["'", sim, "' == 'gz'"]))""", "gz", "error"),
        (""", condition=IfCondition(PythonExpression(["'", sim, "' == 'gz'"]))""", "real", "info"),
        (""", condition=IfCondition(PythonExpression(["'", sim, "' != 'gz'"]))""", "gz", "info"),
        (""", condition=IfCondition(PythonExpression(["'", sim, "' != 'gz'"]))""", "real", "error"),
        (""", condition=UnlessCondition(PythonExpression(["'", sim, "' == 'gz'"]))""", "gz", "info"),
        (""", condition=IfCondition(PythonExpression(["'", sim, "' in ('gz', 'ign')"]))""", "real", "info"),
        (", condition=IfCondition(PythonExpression(['not ', sim]))", "false", "error"),
        (", condition=IfCondition(PythonExpression(['not ', sim]))", "true", "info"),
    ],
)
def test_a_condition_counts_with_the_defaults(condition: str, default: str, level: str) -> None:
    ((found, message),) = levels(PYTHON.format(condition=condition, default=default, added="node,"))
    assert found == level
    assert message.endswith(HINT)
    assert (f", {OFF}; it" in message) is (level == "info")
    assert ("the launch stops with" in message) is (level == "error")


@pytest.mark.parametrize(
    "condition",
    [
        "IfCondition(LaunchConfiguration('other'))",
        """IfCondition(PythonExpression(["'", sim, "'.split('g')[0] == 'gz'"]))""",
        """IfCondition(PythonExpression(["'", sim, EnvironmentVariable('X'), "' == 'gz'"]))""",
        "LaunchConfigurationEquals('sim', 'real')",
        "condition_of(sim)",
        "sys.argv",
    ],
)
def test_a_condition_that_is_not_known_is_one(condition: str) -> None:
    text = PYTHON.format(condition=f", condition={condition}", default="real", added="node,")
    ((found, message),) = levels(f"import sys\n\nfrom launch.conditions import LaunchConfigurationEquals\n{text}")
    assert found == "warning"
    assert f", {CONDITIONAL}; it" in message


@pytest.mark.parametrize(
    ("condition", "added", "level"),
    [
        ("IfCondition(LaunchConfiguration('nav', default=False))", "", "info"),
        ("IfCondition(LaunchConfiguration('nav', default='false'))", "", "info"),
        ("IfCondition(LaunchConfiguration('nav', default=sim))", "", "info"),
        ("UnlessCondition(LaunchConfiguration('nav', default='true'))", "", "info"),
        ("""IfCondition(PythonExpression(["'", LaunchConfiguration('nav', default='a'), "' == 'b'"]))""", "", "info"),
        ("IfCondition(LaunchConfiguration('sim', default='true'))", "", "info"),  # what is declared counts first
        ("IfCondition(LaunchConfiguration('nav', default='true'))", "", "warning"),
        ("IfCondition(LaunchConfiguration('nav', default=None))", "", "warning"),
        ("IfCondition(LaunchConfiguration('nav', default=unknown()))", "", "warning"),
        ("IfCondition(LaunchConfiguration('nav', default='false'))", "DeclareLaunchArgument('nav'),", "warning"),
        ("IfCondition(LaunchConfiguration('nav', default='false'))", "DeclareLaunchArgument(unknown()),", "warning"),
        ("IfCondition(LaunchConfiguration('nav', default='0'))", "SetLaunchConfiguration('nav', '1'),", "warning"),
        (
            "IfCondition(LaunchConfiguration('nav', default='false'))",
            "IncludeLaunchDescription('b.launch.py', launch_arguments={'nav': 'true'}.items()),",
            "warning",
        ),
    ],
)
def test_a_default_counts_where_the_argument_is_read(condition: str, added: str, level: str) -> None:
    text = PYTHON.format(condition=f", condition={condition}", default="false", added=f"{added} node,")
    text = f"from launch.actions import SetLaunchConfiguration\n{text}"
    ((found, message),) = levels(text)
    assert found == level
    assert f", {OFF if level == 'info' else CONDITIONAL}; it" in message


@pytest.mark.parametrize(("sim", "level"), [("true", "error"), ("false", "info")])
def test_the_condition_of_a_group_is_one_of_its_actions(sim: str, level: str) -> None:
    group = "GroupAction([node], condition=IfCondition(sim)),"
    text = PYTHON.format(condition="", default=sim, added=group).replace("DeclareLaunchArgument, ", "GroupAction, ", 1)
    assert [found for found, _ in levels(f"from launch.actions import DeclareLaunchArgument\n{text}")] == [level]


@pytest.mark.parametrize(
    "condition, default, level",
    [
        ("", "true", "error"),
        ('if="$(var sim)"', "false", "info"),
        ('if="$(var sim)"', "true", "error"),
        ('unless="$(var sim)"', "true", "info"),
        ('unless=" $(var sim) "', "false", "error"),
        ('if="false"', "true", "info"),
        ('if="$(var sim) and more"', "false", "warning"),
        ('if="$(var other)"', "false", "warning"),
    ],
)
def test_a_condition_in_xml_counts_too(condition: str, default: str, level: str) -> None:
    ((found, _),) = levels(XML.format(condition=condition, default=default), "launch/a.launch.xml")
    assert found == level


def test_what_is_never_added_is_an_info() -> None:
    ((level, message),) = levels(PYTHON.format(condition="", default="true", added=""))
    assert level == "info"
    assert message.endswith(f"`missing`, {NEVER_ADDED}{HINT}")


@pytest.mark.parametrize(
    "more",
    ["check(node)", "locals()", "other = [node]\n    check(other)", "def later(): return [node]"],
)
def test_a_node_that_anything_reads_may_be_added(more: str) -> None:
    text = PYTHON.format(condition="", default="true", added="").replace("    return", f"    {more}\n    return")
    assert [level for level, _ in levels(text)] == ["error"]


@pytest.mark.parametrize("more", ["other = [node]", "other = [node]\n    more = [other]"])
def test_what_only_unread_values_read_is_not_read(more: str) -> None:
    text = PYTHON.format(condition="", default="true", added="").replace("    return", f"    {more}\n    return")
    assert [level for level, _ in levels(text)] == ["info"]


def test_a_node_in_a_branch_of_python_is_a_warning() -> None:
    text = PYTHON.format(condition="", default="true", added="node,").replace(
        "    node =", "    node = None\n    if unknown():\n        node ="
    )
    ((level, message),) = levels(text)
    assert (level, IN_BRANCH in message) == ("warning", True)
    assert [level for level, _ in levels(text.replace("unknown()", "True"))] == ["error"]


def test_a_node_of_the_module_may_be_added_by_who_imports_it() -> None:
    text = PYTHON.format(condition="", default="true", added="")
    node = "node = Node(package='my_pkg', executable='missing')\n"
    text = text.replace(f"    {node}", "").replace("def generate", f"{node}\n\ndef generate")
    assert [level for level, _ in levels(text, "my_pkg/a.py")] == ["error"]
    assert [level for level, _ in levels(text)] == ["info"]  # in a folder for launch files nothing imports it


def test_a_node_bound_to_two_names_of_which_one_is_read() -> None:
    text = PYTHON.format(condition="", default="true", added="again,").replace("node = ", "node = again = ")
    assert [level for level, _ in levels(text)] == ["error"]


FILE = "[FindPackageShare('my_pkg'), '/launch/{}']"
INCLUDE = PYTHON.replace("Node(package='my_pkg', executable='missing'{condition})", "{include}")


@pytest.mark.parametrize(
    "include, added, name, installed, level",
    [
        ("IncludeLaunchDescription({})", "node,", "b.launch.py", ["launch/a.launch.py"], "error"),
        ("IncludeLaunchDescription({})", "node,", "b.launch.py", [], "warning"),
        ("IncludeLaunchDescription({}, condition=IfCondition(sim))", "node,", "b.launch.py", [], "info"),
        ("IncludeLaunchDescription({})", "", "b.launch.py", [], "info"),
        ("Node(package='rviz2', arguments=['-d', {}])", "node,", "b.rviz", ["launch/a.launch.py"], "warning"),
    ],
)
def test_a_missing_file_counts_where_it_is_opened(
    include: str, added: str, name: str, installed: list[str], level: str
) -> None:
    text = INCLUDE.format(include=include.format(FILE.format(name)), default="false", added=added)
    setup = SETUP.replace(")\n", f", data_files=[('share/my_pkg', {['package.xml', *installed]})])\n")
    files = {"package.xml": manifest(), "setup.py": setup, "my_pkg/__init__.py": "", "launch/a.launch.py": text}
    (finding,) = lint_files(files, ["LCH003"]).findings
    assert finding.severity.value == level
    assert ("RViz starts with its default view; add it" in finding.message) is (name == "b.rviz")
    assert (f", {OFF}; " in finding.message) is ("IfCondition" in include)
    assert (", where it is started from the source" in finding.message) is (
        level == "warning" and not installed and "IfCondition" not in include
    )


def test_a_sister_package_that_has_the_program_is_named() -> None:
    text = PYTHON.format(condition="", default="true", added="node,").replace("missing", "camera")
    files = {}
    for name in ("my_pkg", "sister"):
        scripts = "entry_points={'console_scripts': ['camera = sister.camera:main']}" if name == "sister" else ""
        files[f"{name}/package.xml"] = manifest("", "ament_python", name)
        files[f"{name}/setup.py"] = SETUP.replace("my_pkg", name).replace(")\n", f", {scripts})\n")
        files[f"{name}/setup.cfg"] = (
            f"[develop]\nscript_dir=$base/lib/{name}\n[install]\ninstall_scripts=$base/lib/{name}\n"
        )
        files[f"{name}/{name}/__init__.py"] = ""
    (finding,) = lint_files({**files, "my_pkg/launch/a.launch.py": text, "my_pkg/start.sh": START}, ["LCH002"]).findings
    assert finding.message.endswith("; `sister` has one")


@pytest.mark.parametrize(
    "more",
    [{".gitignore": "launch/made/\n"}, {".gitmodules": '[submodule "m"]\n\tpath = launch/made\n\turl = u\n'}],
)
def test_what_git_ignores_or_a_submodule_holds_is_not_missing(more: dict[str, str]) -> None:
    text = INCLUDE.format(include=f"IncludeLaunchDescription({FILE.format('made/b.launch.py')})", default="", added="")
    setup = SETUP.replace(")\n", ", data_files=[('share/my_pkg', ['package.xml'])])\n")
    robot = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:include filename="{}"/></robot>\n'
    files = {
        "package.xml": manifest(),
        "setup.py": setup,
        "my_pkg/__init__.py": "",
        "launch/a.launch.py": text,
        "urdf/a.xacro": robot.format("$(find my_pkg)/launch/made/b.xacro"),
        "launch/b.xacro": robot.format("made/c.xacro"),
        "launch/c.launch.xml": '<launch><include file="$(dirname)/made/b.launch.py"/></launch>\n',
    }
    assert len(lint_files(files, ["LCH003", "URD002"]).findings) == 4
    assert lint_files({**files, **more}, ["LCH003", "URD002"]).findings == ()


BOUND = """\
    share = FindPackageShare('my_pkg')
    path = [share, '/launch/b.launch.py']
    again = [share, '/launch/b.launch.py']
    return LaunchDescription([
        DeclareLaunchArgument('sim', default_value='{default}'),
        {added}
    ])
"""
OFF_ACTION = "IncludeLaunchDescription({}, condition=IfCondition(LaunchConfiguration('sim'))),"
ON_ACTION = "IncludeLaunchDescription({}),"


@pytest.mark.parametrize(
    ("added", "default", "level"),
    [
        (OFF_ACTION.format("path"), "false", "info"),
        (OFF_ACTION.format("path"), "true", "error"),
        (OFF_ACTION.format("path") + ON_ACTION.format("path"), "false", "error"),
        (OFF_ACTION.format("path") + OFF_ACTION.format("again"), "false", "info"),
        (OFF_ACTION.format("path") + ON_ACTION.format("again"), "false", "error"),
        (OFF_ACTION.format("path").replace("'sim')", "'other')"), "false", "warning"),
        ("Node(package='my_pkg', executable='a', arguments=[path], condition=IfCondition('false')),", "false", "info"),
        (f"load(path), {OFF_ACTION.format('path')}", "false", "error"),
    ],
)
def test_a_path_that_is_bound_above_is_met_where_it_is_read(added: str, default: str, level: str) -> None:
    text = f"{IMPORTS}def generate_launch_description():\n{BOUND.format(added=added, default=default)}"
    setup = SETUP.replace(")\n", ", data_files=[('share/my_pkg', ['package.xml', 'launch/a.launch.py'])])\n")
    files = {"package.xml": manifest(), "setup.py": setup, "my_pkg/__init__.py": "", "launch/a.launch.py": text}
    (finding,) = lint_files(files, ["LCH003"]).findings
    assert finding.severity.value == level


@pytest.mark.parametrize(
    ("opens", "level"), [("xacro.process_file(path)", "error"), ("Command(['xacro ', path])", "info")]
)
def test_what_python_opens_itself_is_opened_whoever_reads_it(opens: str, level: str) -> None:
    body = f"""\
    path = join(get_package_share_directory('my_pkg'), 'urdf', 'b.urdf.xacro')
    robot = {opens}
    sim = IfCondition(LaunchConfiguration('sim'))
    return LaunchDescription([
        DeclareLaunchArgument('sim', default_value='false'),
        Node(package='a', executable='b', parameters=[{{'c': robot}}], condition=sim),
    ])
"""
    more = (
        "import xacro\nfrom os.path import join\n"
        "from ament_index_python.packages import get_package_share_directory\n"
        "from launch.substitutions import Command\n"
    )
    setup = SETUP.replace(")\n", ", data_files=[('share/my_pkg', ['package.xml', 'launch/a.launch.py'])])\n")
    text = f"{more}{IMPORTS}def generate_launch_description():\n{body}"
    files = {"package.xml": manifest(), "setup.py": setup, "my_pkg/__init__.py": "", "launch/a.launch.py": text}
    (finding,) = lint_files(files, ["LCH003"]).findings
    assert finding.severity.value == level
