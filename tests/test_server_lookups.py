"""`rospkg server` asked about places, over the protocol: what is there, where it is defined, what may be written."""

from __future__ import annotations

import os
from collections.abc import Iterator

import pytest
from editor import Editor
from looked_up import FILES


@pytest.fixture(scope="module")
def editor(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Editor]:
    """One server, with two packages, all of whose files are open; nothing is changed in them."""
    folder = tmp_path_factory.mktemp("lookups")
    for path, text in FILES.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text(text)
    kept = {name: os.environ[name] for name in ("PATH", "HOME", "LANG") if name in os.environ}
    found = Editor(folder, **kept, XDG_CACHE_HOME=os.devnull, XDG_CONFIG_HOME=os.devnull)
    for path in FILES:
        found.open(folder / path)
    yield found
    found.quit()


@pytest.mark.parametrize(
    "path, at, told",
    [
        ("my_pkg/package.xml", "my_|cpp</depend>", "**my_cpp** 1.0.0, in this workspace: `my_cpp`"),
        ("my_pkg/package.xml", "rcl|py</depend>", "**rclpy**, a ROS package of humble, jazzy"),
        ("my_pkg/package.xml", "rcl|py</depend>", "`apt install ros-$ROS_DISTRO-rclpy`"),
        ("my_pkg/package.xml", "libopencv|-dev</depend>", "**libopencv-dev**, a rosdep key: apt on 22.04"),
        ("my_pkg/launch/a.launch.xml", 'exec="tal|ker"', "**talker**, executable of `my_pkg`: `my_pkg/my_pkg/t"),
        ("my_pkg/launch/a.launch.xml", 'pkg="my_|cpp" exec', "**my_cpp** 1.0.0, in this workspace"),
        ("my_pkg/launch/b.launch.py", "executable='dri|ver'", "**driver**, executable of `my_cpp`: `my_cpp/src/driver"),
        ("my_pkg/launch/b.launch.py", "Node(package='my_|cpp'", "**my_cpp** 1.0.0, in this workspace"),
        ("my_cpp/config/p.yaml", "spe|ed", "**speed**: double, default `1.0`; declared in `my_cpp`, `src/parts.cpp`"),
        ("my_cpp/msg/Robot.msg", "IDL|004", "# IDL004 unknown-type"),
        ("my_cpp/msg/Robot.msg", "Sta|tus status", "float32 battery"),
        ("my_pkg/package.xml", "Dri|ves", ""),
    ],
)  # fmt: skip
def test_hover(editor: Editor, path: str, at: str, told: str) -> None:
    found = editor.hover(editor.folder / path, at)
    assert told in found
    assert bool(told) == bool(found)


@pytest.mark.parametrize(
    "path, at, leads_to",
    [
        ("my_pkg/package.xml", "my_|cpp</depend>", "my_cpp/package.xml:4:8"),
        ("my_pkg/setup.py", "talker:ma|in", "my_pkg/my_pkg/talker.py:4:10"),
        ("my_pkg/launch/a.launch.xml", 'exec="tal|ker"', "my_pkg/my_pkg/talker.py:4:10"),
        ("my_pkg/launch/a.launch.xml", "/config/p.|yaml", "my_cpp/config/p.yaml:1:0"),
        ("my_pkg/launch/a.launch.xml", "mine::Dri|ver", "my_cpp/src/parts.cpp:1:23"),
        ("my_pkg/launch/b.launch.py", "executable='dri|ver'", "my_cpp/src/driver.cpp:1:0"),
        ("my_pkg/launch/b.launch.py", "c.laun|ch.xml", "my_cpp/launch/c.launch.xml:1:0"),
        ("my_cpp/urdf/r.urdf", "config/p|.yaml", "my_cpp/config/p.yaml:1:0"),
        ("my_cpp/msg/Robot.msg", "Sta|tus status", "my_cpp/msg/Status.msg:1:0"),
        ("my_cpp/config/p.yaml", "spe|ed", "my_cpp/src/parts.cpp:2:40"),
        ("my_pkg/package.xml", "rcl|py</depend>", ""),
    ],
)
def test_definition(editor: Editor, path: str, at: str, leads_to: str) -> None:
    found = editor.definition(editor.folder / path, at)
    assert found == ([f"{editor.folder.as_uri()}/{leads_to}"] if leads_to else [])


@pytest.mark.parametrize(
    "path, old, new, offered",
    [
        ("my_pkg/package.xml", "<export>", "<depend>rclcpp_l|\n  <export>", ["rclcpp_lifecycle"]),
        ("my_pkg/launch/a.launch.xml", "</launch>", '<node pkg="my_c|', ["my_cpp"]),
        ("my_pkg/launch/a.launch.xml", "</launch>", '<node pkg="my_cpp" exec="|', ["driver"]),
        ("my_pkg/launch/a.launch.xml", "</launch>", '<node name="$(var s|', ["speed"]),
        (
            "my_pkg/launch/a.launch.xml", "</launch>",
            '<include file="$(find-pkg-share my_cpp)/launch/c.launch.xml"><arg name="ra|', ["radius", "rate"],
        ),
        ("my_pkg/launch/b.launch.py", "    ])\n", "        Node(package='my_c|", ["my_cpp"]),
        ("my_pkg/launch/b.launch.py", "    ])\n", "        Node(package='my_cpp', executable='d|", ["driver"]),
        ("my_pkg/launch/b.launch.py", "    ])\n", "        LaunchConfiguration('m|", ["mode"]),
        ("my_pkg/launch/b.launch.py", "{'rate': ", "{'ra|': ", ["radius", "rate"]),
        ("my_cpp/msg/Robot.msg", "Status status", "Sta|", ["Status"]),
        ("my_cpp/msg/Robot.msg", "Status status", "geometry_msgs/PoseW|", [
            "geometry_msgs/PoseWithCovariance", "geometry_msgs/PoseWithCovarianceStamped",
        ]),
        ("my_cpp/config/p.yaml", "    speed: 2.0", "    sp|", ["speed"]),
    ],
)  # fmt: skip
def test_completion_while_it_is_typed(editor: Editor, path: str, old: str, new: str, offered: list[str]) -> None:
    """The file is broken, as files are while they are written."""
    file = editor.folder / path
    assert old in FILES[path]
    editor.type(file, FILES[path].replace(old, new.replace("|", "")))
    assert editor.completion(file, new.partition("\n")[0]) == offered
    editor.type(file, FILES[path])
