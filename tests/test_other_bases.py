"""Data that setup.py leaves out and that code opens in another place than the share directory (SET206)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, setup_py
from rospkg_cli.testing import lint_files

LAUNCH = """\
from launch import LaunchDescription
from launch_ros.substitutions import FindPackageShare
from launch.substitutions import PathJoinSubstitution


def generate_launch_description():
    pkg = FindPackageShare('my_pkg')
    robot = PathJoinSubstitution([pkg, 'urdf', 'robot.urdf'])
    params = {}
    return LaunchDescription([robot, params])
"""
ENTRY = "        ('share/' + package_name, ['package.xml']),\n"
INSTALLED = "".join(
    f"        ('share/' + package_name + '/{each}', glob('{each}/*')),\n" for each in ("urdf", "launch")
)
PACKAGE = {
    **existing_files(BACKDROPS["ament_python"]),
    "setup.py": "from glob import glob\n" + setup_py().replace(ENTRY, ENTRY + INSTALLED),
    "urdf/robot.urdf": "<robot name='a'/>\n",
    "config/slam.yaml": "slam:\n  ros__parameters:\n    rate: 1.0\n",
}


def level(params: str) -> str:
    (found,) = lint_files({**PACKAGE, "launch/slam.launch.py": LAUNCH.format(params)}, ["SET206"]).findings
    return found.severity.value


@pytest.mark.parametrize(
    "params",
    [
        "'/home/ada/ws/src/my_pkg/config/slam.yaml'",
        "'/home/ada/my_pkg/config/slam.yaml'",
        "os.path.join('/home/ada/ws/src/my_pkg', 'config', 'slam.yaml')",
        "os.path.expanduser('~/ws/src/my_pkg/config/slam.yaml')",
        "os.path.join(os.path.expanduser('~'), 'ws', 'config', 'slam.yaml')",
        "os.path.join(os.environ['HOME'], 'ws', 'config', 'slam.yaml')",
        "'src/my_pkg/config/slam.yaml'",
        "str(Path.home() / 'ws' / 'config' / 'slam.yaml')",
        "os.path.join(os.getcwd(), 'config', 'slam.yaml')",
        "0\n    base = '/home/ada/ws/src/my_pkg'\n    params = os.path.join(base, 'config', 'slam.yaml')",
        "LaunchConfiguration('config')",
        "DeclareLaunchArgument(name='config', default_value='')",
        "{'config': robot}.items()",
    ],
)
def test_what_is_opened_elsewhere(params: str) -> None:
    assert level(params) == "info"


@pytest.mark.parametrize(
    "params",
    [
        "PathJoinSubstitution([pkg, 'config', 'slam.yaml'])",
        "[pkg, '/config/slam.yaml']",
        "LaunchConfiguration('config', default=[pkg, '/config/slam.yaml'])",
        "{'config': [pkg, '/config/slam.yaml']}.items()",
        "0\n    base = '/home/ada/ws/src/my_pkg'\n    params = os.path.join(pkg, 'config', 'slam.yaml')",
        "0\n    base = '/home/ada/ws/install/my_pkg/share/my_pkg'\n    params = [pkg, base, 'config', 'slam.yaml']",
        "'/home/ada/ws/install/my_pkg/share/my_pkg/config/slam.yaml'",
        "PathJoinSubstitution([pkg, folder]) if (folder := 'config') else 1",
    ],
)
def test_what_is_opened_in_the_share_directory(params: str) -> None:
    assert level(params) == "error"


def started(*texts: tuple[str, str]) -> str:
    own = {f"src/my_pkg/{path}": text for path, text in PACKAGE.items() if not path.startswith("config")}
    own["src/my_pkg/setup.py"] = setup_py()
    own["src/my_pkg/launch/arm.launch.py"] = LAUNCH.format("''")
    found = lint_files({**own, **dict(texts)}, ["SET206"]).findings
    return next(each.severity.value for each in found if "`launch/`" in each.message)


BY_PATH = ("arm_start.sh", "#!/bin/bash\nros2 launch src/my_pkg/launch/arm.launch.py\n")


@pytest.mark.parametrize(
    "text",
    [
        BY_PATH,
        ("tools/start.sh", 'ros2 launch -d "$WS/src/my_pkg/launch/arm.launch.py" sim:=true\n'),
        ("robot.service", "ExecStart=/bin/bash -c 'cd /ws && ros2 launch ./src/my_pkg/launch/arm.launch.py'\n"),
        ("README.md", "`cd src/my_pkg/launch && ros2 launch arm.launch.py`\n"),
        ("README.md", "    python3 src/my_pkg/launch/arm.launch.py\n"),
    ],
)
def test_a_launch_file_that_is_started_where_it_lies(text: tuple[str, str]) -> None:
    assert started(text) == "info"


@pytest.mark.parametrize(
    "texts",
    [
        (),
        (BY_PATH, ("README.md", "`ros2 launch my_pkg arm.launch.py`\n")),
        (("start.sh", "ros2 launch src/other/launch/arm.launch.py\n"),),
        (("start.sh", "ros2 launch src/my_pkg/launch/other.launch.py\n"),),
        (("other/package.xml", "<package/>"), ("other/start.sh", BY_PATH[1])),
        (("a/b/start.sh", BY_PATH[1]),),
    ],
)
def test_a_launch_file_that_is_looked_up(texts: tuple[tuple[str, str], ...]) -> None:
    assert started(*texts) == "warning"
