"""One view over launch files in Python, XML and YAML."""

from __future__ import annotations

import pytest

from rospkg_cli.checks.launch.entity_schema import entity_faults
from rospkg_cli.checks.launch.package_references import package_references
from rospkg_cli.checks.read_sentences import what_is_wrong
from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.files import PackageFiles
from rospkg_cli.package.launch.launch_file import LaunchFile
from rospkg_cli.package.launch.text import LaunchText
from rospkg_cli.package.package import Package
from rospkg_cli.testing import lint_files
from rospkg_cli.tree import MemoryTree

XML = """\
<launch>
  <arg name="config" default="$(find-pkg-share demo)/config/a.yaml" description="d"/>
  <arg name="needed"/>
  <let name="twice" value="$(var config)"/>
  <group if="$(var needed)">
    <node pkg="demo" exec="talker" name="talker" namespace="ns" args="--x 1">
      <param from="$(var config)"/>
      <param name="rate" value="10"/>
      <param name="nested"><param name="deep" value="1"/></param>
      <remap from="a" to="b"/>
    </node>
  </group>
  <include file="$(find-pkg-share other)/launch/x.launch.xml">
    <arg name="speed" value="$(var twice)"/>
  </include>
  <node_container pkg="rclcpp_components" exec="component_container" name="c" namespace="">
    <composable_node pkg="demo" plugin="demo::Talker" name="t"/>
  </node_container>
  <executable cmd="xacro $(var config)"/>
</launch>
"""

YAML = """\
launch:
- arg:
    name: config
    default: $(find-pkg-share demo)/config/a.yaml
    description: d
- arg: {name: needed}
- let: {name: twice, value: $(var config)}
- group:
    if: $(var needed)
    children:
    - node:
        pkg: demo
        exec: talker
        name: talker
        namespace: ns
        args: --x 1
        param:
        - from: $(var config)
        - name: rate
          value: 10
        - name: nested
          param:
          - {name: deep, value: 1}
        remap:
        - {from: a, to: b}
- include:
    file: "$(find-pkg-share other)/launch/x.launch.xml"
    arg:
    - {name: speed, value: $(var twice)}
- node_container:
    pkg: rclcpp_components
    exec: component_container
    name: c
    namespace: ''
    composable_node:
    - pkg: demo
      plugin: demo::Talker
      name: t
- executable:
    cmd: xacro $(var config)
"""

PYTHON = """\
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import (DeclareLaunchArgument, ExecuteProcess, GroupAction, IncludeLaunchDescription,
                            SetLaunchConfiguration)
from launch.conditions import IfCondition
from launch.launch_description_sources import AnyLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import ComposableNodeContainer, Node
from launch_ros.descriptions import ComposableNode
from launch_ros.substitutions import FindPackageShare

SHARE = get_package_share_directory('demo')


def generate_launch_description():
    config = LaunchConfiguration('config')
    talker = Node(
        package='demo', executable='talker', name='talker', namespace='ns', arguments=['--x', '1'],
        parameters=[config, {'rate': '10', 'nested.deep': '1'}], remappings=[('a', 'b')],
        condition=IfCondition(LaunchConfiguration('needed')))
    return LaunchDescription([
        DeclareLaunchArgument('config', default_value=os.path.join(SHARE, 'config', 'a.yaml'), description='d'),
        DeclareLaunchArgument(name='needed'),
        SetLaunchConfiguration('twice', config),
        GroupAction([talker]),
        IncludeLaunchDescription(
            AnyLaunchDescriptionSource(PathJoinSubstitution([FindPackageShare('other'), 'launch', 'x.launch.xml'])),
            launch_arguments={'speed': LaunchConfiguration('twice')}.items()),
        ComposableNodeContainer(
            package='rclcpp_components', executable='component_container', name='c', namespace='',
            composable_node_descriptions=[ComposableNode(package='demo', plugin='demo::Talker', name='t')]),
        ExecuteProcess(cmd=['xacro', config]),
    ])
"""

SAME = {"launch/a.launch.xml": XML, "launch/a.launch.yaml": YAML, "launch/a.launch.py": PYTHON}


def read(path: str, text: str, **others: str) -> LaunchFile:
    package = Package(PackageFiles(MemoryTree.of({path: text, **others})))
    found = [file for file in package.parts(LaunchFile).good if file.path == path]
    assert len(found) == 1
    return found[0]


def python(body: str) -> LaunchFile:
    """Read a launch file whose function has a body of some lines."""
    head = PYTHON[: PYTHON.index("SHARE =")] + "from launch.actions import OpaqueFunction\n\n\n"
    lines = "".join(f"    {line}\n" for line in body.splitlines())
    return read("launch/b.launch.py", f"{head}def generate_launch_description():\n{lines}")


def shown(text: LaunchText | None) -> str | None:
    return None if text is None else text.literal


@pytest.mark.parametrize("path", SAME)
def test_the_three_frontends_say_the_same(path: str) -> None:
    file = read(path, SAME[path])
    assert not any(entity_faults(file))
    assert file.is_complete
    nodes = {(n.kind, shown(n.package), shown(n.executable), shown(n.plugin), shown(n.name)) for n in file.nodes}
    assert nodes == {
        ("node", "demo", "talker", None, "talker"),
        ("node_container", "rclcpp_components", "component_container", None, "c"),
        ("composable_node", "demo", None, "demo::Talker", "t"),
    }
    talker = next(n for n in file.nodes if shown(n.executable) == "talker")
    assert not talker.is_certain
    assert shown(talker.namespace) == "ns"
    assert [(shown(a), shown(b)) for a, b in talker.remappings] == [("a", "b")]
    given, *values = talker.parameters
    assert given.file is not None
    assert [s.name for s in given.file.substitutions()] == ["var"]
    pairs = {(shown(name), shown(value)) for each in values for name, value in each.values}
    assert pairs == {("rate", "10"), ("nested.deep", "1")}
    assert [(shown(a.name), a.default is None) for a in file.arguments] == [("config", False), ("needed", True)]
    default = file.arguments[0].default
    assert default is not None
    share = default.in_share()
    assert share is not None
    assert (share[0].literal, share[1]) == ("demo", "config/a.yaml")
    (include,) = file.includes
    target = include.file.in_share()
    assert target is not None
    assert (target[0].literal, target[1]) == ("other", "launch/x.launch.xml")
    assert [shown(name) for name, _ in include.arguments] == ["speed"]
    assert [shown(name) for name in file.assigned] == ["twice"]
    assert {use.name for use in package_references(file)} == {"demo", "other", "rclcpp_components", "xacro"}
    used = sorted(s.arguments[0].literal or "?" for s in file.configurations())
    assert set(used) == {"config", "needed", "twice"}


@pytest.mark.parametrize("path", SAME)
def test_names_stand_where_they_say(path: str) -> None:
    file = read(path, SAME[path])
    for use in package_references(file):
        assert file.source.slice(use.span) == use.name
    for node in file.nodes:
        for text in (node.package, node.executable, node.plugin, node.name):
            if text is not None:
                assert file.source.slice(text.span) == text.literal


@pytest.mark.parametrize(
    "body, packages",
    [
        ("for name in ['a', 'b']:\n    Node(package=name, executable='x')", {"a", "b"}),
        ("def make(name):\n    return Node(package=name, executable='x')\nreturn [make('a'), make('b')]", {"a", "b"}),
        (
            "def late(context):\n    return Node(package='a')\nreturn OpaqueFunction(function=late)",
            {"a"},
        ),
        ("args = {'package': 'a', 'executable': 'x'}\nreturn Node(**args)", {"a"}),
        ("prefix = 'a'\nreturn Node(package=f'{prefix}_b', executable='x')", {"a_b"}),
        ("return Node(package=LaunchConfiguration('p'), executable='x')", set()),
        ("import random\nreturn Node(package=random.choice(['a']), executable='x')", set()),
        ("if os.environ.get('X'):\n    return Node(package='a', executable='x')\nreturn []", {"a"}),
        ("try:\n    get_package_share_directory('a')\nexcept Exception:\n    pass", set()),
        ("return os.path.join(FindPackageShare('a').find('b'), 'c')", {"b"}),
        ("from other.launch import Node\nreturn Node(package='a')", set()),
        ("return ExecuteProcess(cmd=['ros2', 'run', 'a', 'x'])", {"a"}),
        ("from launch.substitutions import Command\nreturn Command(['xacro ', 'x'])", {"xacro"}),
        ("from launch.substitutions import FindExecutable as F\nreturn F(name='xacro')", {"xacro"}),
    ],
)
def test_python_is_evaluated(body: str, packages: set[str]) -> None:
    assert {use.name for use in package_references(python(body))} == packages


def test_a_function_that_nothing_calls_is_read_as_well() -> None:
    file = python("return []\n")
    assert file.nodes == ()
    text = PYTHON + "\n\ndef spare():\n    return Node(package='spare', executable='x')\n"
    assert "spare" in {use.name for use in package_references(read("launch/a.launch.py", text))}


def test_a_function_that_calls_itself_comes_to_an_end() -> None:
    text = (
        "def f(d, k):\n    for v in d:\n        if v == k:\n            f(v, k)\n        else:\n            f(k, v)\n"
    )
    assert python(text + "f(x, y)").is_complete


@pytest.mark.parametrize(
    "path, is_launch",
    [
        ("launch/a.xml", True), ("launch/deep/a.yaml", True), ("a.launch", True), ("launch/a_launch.xml", True),
        ("config/a.xml", False), ("package.xml", False), ("docs/a.launch.xml", False),
    ],
)  # fmt: skip
def test_which_files_are_launch_files(path: str, is_launch: bool) -> None:
    text = "launch: []" if path.endswith("yaml") else "<launch/>"
    package = Package(PackageFiles(MemoryTree.of({path: text})))
    assert bool(package.parts(LaunchFile).good) is is_launch


def test_other_xml_and_yaml_among_launch_files_is_left_alone() -> None:
    files = {"launch/a.xml": "<robot/>", "launch/b.yaml": "a: 1", "launch/c.yaml": "", "launch/d.yaml": "- 1"}
    parts = Package(PackageFiles(MemoryTree.of(files))).parts(LaunchFile)
    assert parts.good == ()
    assert parts.broken == ()


@pytest.mark.parametrize("path, text", [("launch/a.launch.xml", "<launch>"), ("launch/a.launch.yaml", "a: [")])
def test_broken_files_are_told(path: str, text: str) -> None:
    (broken,) = Package(PackageFiles(MemoryTree.of({path: text}))).parts(LaunchFile).broken
    assert broken.path == path


def test_files_for_ros_1_are_seen_and_left_alone() -> None:
    file = read("launch/a.launch", '<launch><node pkg="a" type="b" name="c" foo="x"/></launch>')
    assert file.is_ros1
    assert not any(entity_faults(file))
    assert not list(package_references(file))


FAULTS = [
    ('<node pkg="a" exec="b" nam="c"/>', "nam"),
    ('<node pkg="a"/>', "node"),
    ('<node pkg="a" exec="b"><parm name="x" value="1"/></node>', "parm"),
    ('<node pkg="a" exec="b"><param nme="x"/></node>', "nme"),
    ('<include/>', "include"),
    ('<include file="a"><arg name="b"/></include>', "arg"),
    ('<groop/>', "groop"),
    ('<arg name="a" default="$(var b"/>', "$"),
    ('<arg name="a" default="$(find-pkg-shar b)"/>', "$(find-pkg-shar b)"),
    ('<arg name="a" default="$(dirname b)"/>', "$(dirname b)"),
    ('<group if="a" unless="b"/>', "unless"),
]  # fmt: skip


@pytest.mark.parametrize("inside, place", FAULTS)
def test_what_launch_refuses(inside: str, place: str) -> None:
    file = read("launch/a.launch.xml", f"<launch>\n  {inside}\n</launch>\n")
    assert [file.source.slice(fault.span) for fault in entity_faults(file)] == [place]


@pytest.mark.parametrize(
    "inside",
    [
        '<my_own_action anything="goes"><inside/></my_own_action>',
        '<arg name="a" default="$(my-own b c d e)"/>',
        '<node pkg="a" exec="b"><param name="l" value="1,2" value-sep=","/></node>',
        '<set_parameter name="a" value="b" if="c"/>',
        '<log message="it\'s $5"/>',
        '<timer period="1"><node pkg="a" exec="b"/></timer>',
    ],
)
def test_what_launch_takes(inside: str) -> None:
    assert not any(entity_faults(read("launch/a.launch.xml", f"<launch>\n  {inside}\n</launch>\n")))


@pytest.mark.parametrize(
    "text, place",
    [
        ("launch:\n- node: {pkg: a, exec: b}\n  arg: {name: c}\n", "arg"),
        ("launch:\n- node\n", "node"),
        ("launch: []\nother: 1\n", "other"),
        ("launch:\n- node: {pkg: a, exce: b}\n", "exce"),
    ],
)
def test_what_the_yaml_frontend_refuses(text: str, place: str) -> None:
    file = read("launch/a.launch.yaml", text)
    assert [file.source.slice(fault.span) for fault in entity_faults(file)] == [place]


def test_yaml_that_unfolds_without_end_is_refused() -> None:
    laughs = "a: &a [x, x, x, x, x, x, x, x]\n" + "".join(
        f"{chr(98 + i)}: &{chr(98 + i)} [{', '.join(['*' + chr(97 + i)] * 9)}]\n" for i in range(8)
    )
    (broken,) = Package(PackageFiles(MemoryTree.of({"launch/a.yaml": laughs}))).parts(LaunchFile).broken
    assert "too" in what_is_wrong(broken)


def test_each_round_of_a_loop_makes_its_own() -> None:
    file = python(
        "from launch.actions import IncludeLaunchDescription\n"
        "return [IncludeLaunchDescription('a.launch.py', launch_arguments={'namespace': name}.items())\n"
        "    for name in ['a', 'b']] + [Node(package='p', executable='e', arguments=['-n', n]) for n in ['a', 'b']]"
    )
    assert [value.literal for include in file.includes for _, value in include.arguments] == ["a", "b"]
    assert len(file.nodes) == 2


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ('<node pkg="a" executable="b"/>', ["`node` has no attribute `executable` (did you mean `exec`?)"]),
        ('<node package="a" exec="b"/>', ["`node` has no attribute `package` (did you mean `pkg`?)"]),
        ('<arg name="a" default_value="b"/>', ["`arg` has no attribute `default_value` (did you mean `default`?)"]),
        ('<node pkg="a"/>', ["`node` lacks its attribute `exec`"]),
    ],
)
def test_attributes_that_are_called_as_in_python(line: str, said: list[str]) -> None:
    file = read("launch/a.launch.xml", f"<launch>\n  {line}\n</launch>\n")
    assert [fault.message.partition(":")[0] for fault in entity_faults(file)] == said


@pytest.mark.parametrize(("line", "found"), [("", "info"), ('<let name="a" value="b"/>', "error")])
def test_roslaunch_knows_the_folder_of_a_file(line: str, found: str) -> None:
    text = f'<launch>\n  <include file="$(dirname)/b.launch"/>\n  <node pkg="a" type="b" name="c"/>{line}\n</launch>\n'
    install = CMAKE.replace(
        "ament_package", "install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})\nament_package"
    )
    files = {"package.xml": manifest(build_type="ament_cmake"), "CMakeLists.txt": install, "launch/a.launch": text}
    told = lint_files(files, ["LCH005", "LCH006"]).findings
    assert [each.severity.value for each in told] == [found]


def test_launch_loads_python_of_another_suffix() -> None:
    def told(text: str) -> list[str]:
        files = {"package.xml": manifest(), "launch/a.launch": text}
        return [each.code for each in lint_files(files, ["RPK001"]).findings]

    assert told("import os\n\n\ndef generate_launch_description():\n    pass\n") == []
    assert told("import os\n") == ["RPK001"]


@pytest.mark.parametrize(("node", "found"), [('name="a"', 0), ('name="a" pkg="b"', 1), ('exec="b"', 1)])
def test_a_list_of_nodes_for_another_program(node: str, found: int) -> None:
    files = {"package.xml": manifest(), "config/launch.xml": f'<launch>\n  <node {node} start="both"/>\n</launch>\n'}
    codes = {each.code for each in lint_files(files, ["LCH007"]).findings}
    assert len(codes) == found


@pytest.mark.parametrize(
    ("items", "found"), [("'a.yaml'", 0), ("path", 0), ("1", 1), ("'rate', 1", 1), ("'a', 'b'", 1)]
)
def test_a_set_of_one_path_is_that_path(items: str, found: int) -> None:
    head = "from launch import LaunchDescription\nfrom launch.substitutions import LaunchConfiguration\n"
    text = (
        f"{head}from launch_ros.actions import Node\n\n\ndef generate_launch_description():\n"
        "    path = LaunchConfiguration('a')\n"
        f"    return LaunchDescription([Node(package='a', executable='b', parameters=[{{{items}}}])])\n"
    )
    files = {"package.xml": manifest(), "launch/a.launch.py": text}
    assert len(lint_files(files, ["LCH014"]).findings) == found
