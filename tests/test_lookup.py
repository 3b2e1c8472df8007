"""What a place of a file names, where that is defined, what is told of it, and what may be written there."""

from __future__ import annotations

import pytest
from looked_up import FILES

from rospkg_cli.files import PackageFiles
from rospkg_cli.lookup.completion import completions
from rospkg_cli.lookup.declared_default import default_behind
from rospkg_cli.lookup.definition import definitions
from rospkg_cli.lookup.hover import hover
from rospkg_cli.lookup.mention import mention_at
from rospkg_cli.lookup.world import LookupWorld
from rospkg_cli.package.collect_facts import collect_facts
from rospkg_cli.package.package import Package
from rospkg_cli.package.workspace import Workspace
from rospkg_cli.ros.distros import Targets
from rospkg_cli.tree import MemoryTree

DISTROS = ("humble", "jazzy", "kilted", "lyrical", "rolling")


@pytest.fixture(scope="module")
def world() -> LookupWorld:
    tree = MemoryTree.of(FILES)
    facts = [
        collect_facts(Package(PackageFiles(tree.sub(each), each, tree)), Targets(), each, each)
        for each in ("my_cpp", "my_pkg")
    ]
    return LookupWorld(tree, Workspace(tuple(facts)))


def split(path: str) -> tuple[str, str]:
    folder, _, inner = path.partition("/")
    return folder, inner


def shown(world: LookupWorld, path: str, at: str, how: int = 0) -> list[str]:
    """Return what defines the text at a place: `path:line:text`."""
    folder, inner = split(path)
    mention = mention_at(world.package(folder), inner, offset_of(path, at, how))
    assert mention is not None
    found = definitions(world, folder, mention)
    texts = [(each, world.source(each.path)) for each in found]
    return [f"{each.path}:{text.position(each.span.start)[0]}:{text.slice(each.span)}" for each, text in texts]


def offset_of(path: str, text: str, number: int = 0) -> int:
    """Return the place within an occurrence of a text; a `|` in it is the cursor."""
    before = text.partition("|")[0] if "|" in text else text[:1]
    found = -1
    for _ in range(number + 1):
        found = FILES[path].index(text.replace("|", ""), found + 1)
    return found + len(before)


@pytest.mark.parametrize(
    "path, at, leads_to",
    [
        ("my_pkg/package.xml", "my_|cpp</depend>", ["my_cpp/package.xml:4:my_cpp"]),
        ("my_pkg/package.xml", "rcl|py</depend>", []),
        ("my_pkg/setup.py", "my_pkg.tal|ker:main", ["my_pkg/my_pkg/talker.py:4:main"]),
        ("my_pkg/launch/a.launch.xml", 'pkg="my_|cpp" exec', ["my_cpp/package.xml:4:my_cpp"]),
        ("my_pkg/launch/a.launch.xml", 'exec="tal|ker"', ["my_pkg/my_pkg/talker.py:4:main"]),
        ("my_pkg/launch/a.launch.xml", 'exec="dri|ver"', ["my_cpp/src/driver.cpp:1:"]),
        ("my_pkg/launch/a.launch.xml", "/config/p.|yaml", ["my_cpp/config/p.yaml:1:"]),
        ("my_pkg/launch/a.launch.xml", "find-pkg-share my_|cpp", ["my_cpp/package.xml:4:my_cpp"]),
        ("my_pkg/launch/a.launch.xml", "mine::Dri|ver", ["my_cpp/src/parts.cpp:1:Driver"]),
        ("my_cpp/msg/Robot.msg", "Sta|tus", ["my_cpp/msg/Status.msg:1:"]),
        ("my_cpp/msg/Robot.msg", "std_msgs/Hea|der", []),
        ("my_cpp/config/p.yaml", "spe|ed", ["my_cpp/src/parts.cpp:2:speed"]),
        ("my_cpp/urdf/r.urdf", "config/p|.yaml", ["my_cpp/config/p.yaml:1:"]),
    ],
)
def test_where_it_is_defined(world: LookupWorld, path: str, at: str, leads_to: list[str]) -> None:
    assert shown(world, path, at) == leads_to


@pytest.mark.parametrize(
    "path, at",
    [("my_pkg/package.xml", "Drives"), ("my_pkg/my_pkg/talker.py", "import"), ("my_cpp/msg/Status.msg", "fl")],
)
def test_what_leads_nowhere_is_no_mention(world: LookupWorld, path: str, at: str) -> None:
    folder, inner = split(path)
    assert mention_at(world.package(folder), inner, offset_of(path, at)) is None


@pytest.mark.parametrize(
    "path, at, told",
    [
        ("my_pkg/package.xml", "my_|cpp</depend>", "**my_cpp** 1.0.0, in this workspace: `my_cpp`\n\nDrives my robot"),
        (
            "my_pkg/package.xml",
            "rcl|py</depend>",
            f"**rclpy**, a ROS package of {', '.join(DISTROS)}\n\n`apt install ros-$ROS_DISTRO-rclpy`",
        ),
        ("my_pkg/package.xml", "libopen|cv-dev", "**libopencv-dev**, a rosdep key: apt on"),
        (
            "my_pkg/launch/a.launch.xml",
            'exec="tal|ker"',
            "**talker**, executable of `my_pkg`: `my_pkg/my_pkg/talker.py`",
        ),
        (
            "my_pkg/launch/a.launch.xml",
            "component_|container",
            "executable of **rclcpp_components**, which is not in this workspace",
        ),
        ("my_cpp/config/p.yaml", "spe|ed", "**speed**: double, default `1.0`; declared in `my_cpp`, `src/parts.cpp`"),
        ("my_cpp/msg/Robot.msg", "Sta|tus", "**my_cpp/msg/Status**\n\n```\nfloat32 battery\n```"),
        ("my_cpp/msg/Robot.msg", "IDL|004", "# IDL004 unknown-type"),
    ],
)
def test_what_is_told(world: LookupWorld, path: str, at: str, told: str) -> None:
    folder, inner = split(path)
    mention = mention_at(world.package(folder), inner, offset_of(path, at))
    assert mention is not None
    assert hover(world, folder, mention).startswith(told)


@pytest.mark.parametrize(
    "path, text, typed, offered",
    [
        ("my_pkg/package.xml", "<depend>my_", 3, ["my_cpp", "my_pkg"]),
        ("my_pkg/package.xml", '<exec_depend condition="$ROS_VERSION == 2">rclcpp_l', 8, ["rclcpp_lifecycle"]),
        ("my_pkg/package.xml", "<name>my_", 0, []),
        ("my_pkg/launch/b.launch.py", "Node(package='my_c", 4, ["my_cpp"]),
        ("my_pkg/launch/b.launch.py", "Node(package='my_cpp', executable='d", 1, ["driver"]),
        ("my_pkg/launch/b.launch.xml", '<node exec="t', 1, []),
        ("my_pkg/launch/b.launch.xml", '<node pkg="my_pkg" exec="talker"/><node pkg="my_cpp" exec="', 0, ["driver"]),
        (
            "my_pkg/launch/b.launch.xml",
            '<include file="c.launch.xml"><arg name="rate" value="1"/><arg name="ra',
            2,
            ["radius", "rate"],
        ),
        ("my_pkg/launch/b.launch.xml", '<include file="c.launch.xml"/><arg name="ra', 0, []),
        ("my_pkg/launch/b.launch.xml", '<include file="c.launch.xml"></include><arg name="ra', 0, []),
        ("my_pkg/launch/b.launch.xml", '<include file="other.launch.xml"><arg name="ra', 2, []),
        ("my_pkg/launch/b.launch.py", "include('c.launch.xml', launch_arguments={'rate': '1', 'rad", 3, ["radius"]),
        ("my_pkg/launch/b.launch.py", "DeclareLaunchArgument(name='one')\nLaunchConfiguration('o", 1, ["one"]),
        (
            "my_pkg/launch/c.launch.yaml",
            "- arg:\n    name: one\n- let: {name: other}\n- node:\n    exec: $(var o",
            1,
            ["one", "other"],
        ),
        ("my_pkg/launch/a.launch.xml", '<node name="$(var s', 1, ["speed"]),
        ("my_cpp/msg/New.msg", "float32 x\nStat", 4, ["Status"]),
        ("my_pkg/msg/New.msg", "my_cpp/S", 8, ["my_cpp/Status"]),
        ("my_pkg/msg/New.msg", "std_msgs/Hea", 12, ["std_msgs/Header"]),
        ("my_pkg/msg/New.msg", "uint6", 5, ["uint64"]),
        ("my_cpp/config/q.yaml", "driver:\n  ros__parameters:\n    sp", 2, ["speed"]),
        ("my_pkg/README.md", "<depend>my_", 0, []),
    ],
)
def test_what_may_be_written(world: LookupWorld, path: str, text: str, typed: int, offered: list[str]) -> None:
    folder, inner = split(path)
    assert completions(world, folder, inner, text, len(text)) == (typed, offered)


def test_the_package_of_an_executable_may_come_after_it(world: LookupWorld) -> None:
    text = '<node exec="" pkg="my_cpp"/>'
    assert completions(world, "my_pkg", "launch/b.launch.xml", text, 12) == (0, ["driver"])


@pytest.mark.parametrize(
    "text, default",
    [
        ('declare_parameter("speed", 1.0);', "1.0"),
        ('declare_parameter<std::vector<double>>("speed", {1.0, 2.0}, described);', "{1.0, 2.0}"),
        ('declare_or_get(\n  node, "speed",\n  rclcpp::ParameterValue(0.5));', "rclcpp::ParameterValue(0.5)"),
        ('declare_parameter(name + ".speed", std::string("a, b"));', 'std::string("a, b")'),
        ("self.declare_parameters('', [('speed', 'fast'), ('x', 1)])", "'fast'"),
        ("self.declare_parameter('speed')", ""),
        ("self.declare_parameter('speed', ", ""),
        ("get_parameter('speed', 1.0)", ""),
        (f"declare_parameter('speed', '{'x' * 100}')", ""),
    ],
)
def test_the_default_of_a_declaration(text: str, default: str) -> None:
    start = text.index("speed") - (text[text.index("speed") - 1] == ".")
    assert default_behind(text, start, text.index("speed") + 5) == default
