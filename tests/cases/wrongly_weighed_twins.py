"""What has one cause in several launch files of a package: one finding, where it is worst, with the other places."""

from __future__ import annotations

from rospkg_cli.example import Example, manifest
from rospkg_cli.rules.launch import lch002_unknown_executable as lch002
from rospkg_cli.rules.launch import lch011_unknown_component as lch011
from rospkg_cli.rules.launch import lch015_include_argument_mismatch as lch015

FILES = ("launch/a.launch.xml", "launch/b.launch.xml", "launch/c.launch.xml")
ARGUMENT = '<launch>\n  <arg name="sim" default="false"/>'
START = """\
<launch>
  <node pkg="{0}" exec="{1}" name="first"/>
  <node pkg="{0}" exec="{1}" name="second"/>
</launch>
"""
PYTHON = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    node = Node(package='my_pkg', {})
    return LaunchDescription([{}])
"""
COMMAND = '<launch>\n  <executable cmd="ros2 control load_controller --set-state start {}"/>\n</launch>\n'


def plain(text: str) -> str:
    return text.replace("«", "").replace("»", "")


def off(text: str) -> str:
    """Return a launch file whose nodes start under a condition that is false by default."""
    return (
        text.replace("<launch>", ARGUMENT)
        .replace(' name="', ' if="$(var sim)" name="')
        .replace('<arg if="$(var sim)"', "<arg")
    )


def launched(*texts: str, more: dict[str, str] | None = None) -> Example:
    named = dict(zip(FILES, texts, strict=False))
    return Example(good={}, bad={"package.xml": manifest(), **named, **(more or {})})


def python(*texts: str) -> Example:
    named = {f"launch/{name}.launch.py": text for name, text in zip("abc", texts, strict=False)}
    return Example(good={}, bad={"package.xml": manifest(), **named})


SETUP = {path: lch002.FILES[path] for path in ("setup.py", "my_pkg/talker.py")}
TAKER, SPAWNER = START.format("my_pkg", "taker"), START.format("controller_manager", "spawner.py")
SLIP = START.format("controller_manager", "spawnr")
CONTAINER = plain(lch011.BAD)
TYPED = TAKER.replace("exec", "type").replace("</launch>", '  <let name="a" value="$(var b)"/>\n</launch>')
GIVEN = plain(lch015.GIVEN)

CASES = {
    "LCH002": (
        launched(TAKER, TAKER, more=lch002.FILES | {FILES[0]: TAKER}),
        launched(SPAWNER, SPAWNER),
        launched(off(SLIP), SLIP),
        Example(
            on="",
            good={},
            bad={"package.xml": manifest(), "launch/old/a.launch.xml": TAKER, "launch/z.launch.xml": TAKER, **SETUP},
        ),
    ),
    "LCH005": (
        python(
            PYTHON.format("node_executable='a'", "node"),
            PYTHON.format("node_executable='a', node_name='b'", "node"),
            PYTHON.format("type='a'", "node"),
        ),
        python(PYTHON.format("node_name='a', executable='a'", ""), PYTHON.format("node_executable='a'", "node")),
        launched(TYPED, TYPED),
        launched(COMMAND.format("arm"), COMMAND.format("gripper"), COMMAND.replace("start", "stop").format("arm")),
    ),
    "LCH011": (
        Example(
            on="ament_cmake",
            good={},
            bad={**lch011.FILES, FILES[0]: off(CONTAINER), FILES[1]: CONTAINER},
        ),
    ),
    "LCH015": (
        Example(
            good={},
            bad={
                **lch015.FILES,
                FILES[1]: GIVEN,
                FILES[2]: GIVEN.replace("ratee", "wheels"),
                "launch/d.launch.xml": GIVEN,
            },
        ),
        Example(good={}, bad={**lch015.FILES, FILES[1]: plain(lch015.LACKS), FILES[2]: plain(lch015.LACKS)}),
        Example(
            good={},
            bad={**lch015.FILES, FILES[1]: GIVEN.replace("speed", "sped"), FILES[2]: GIVEN.replace("speed", "sped")},
        ),
    ),
}
