"""Paths of which a part is known only when launch runs: reported where no file fits."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

HEAD = """\
import os
from ament_index_python.packages import get_package_share_directory as share
from launch import LaunchDescription
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare

ROBOT = os.environ['ROBOT']
"""
FILES = {
    "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n", "ament_cmake"),
    "CMakeLists.txt": CMAKE.replace(
        "ament_package", "install(DIRECTORY launch config DESTINATION share/${PROJECT_NAME})\nament_package"
    ),
    "config/small/mapping.yaml": "/**:\n  ros__parameters:\n    rate: 2.0\n",
}


def told(path: str, **files: str) -> list[str]:
    node = f"Node(package='p', executable='e', arguments=['-f', {path}])"
    text = f"{HEAD}\n\ndef generate_launch_description():\n    return LaunchDescription([{node}])\n"
    named = {name.replace("__", "/").replace("_DOT_", "."): content for name, content in files.items()}
    files = {**FILES, "launch/a.launch.py": text, **named}
    return [f"{each.severity.value}: {each.message}" for each in lint_files(files, ["LCH003"]).findings]


@pytest.mark.parametrize(
    "path, names",
    [
        ("os.path.join(share('my_pkg'), 'config/' + ROBOT, ROBOT + '_mapping.yaml')", "config/…/…_mapping.yaml"),
        ("os.path.join(share('my_pkg'), 'config', f'{ROBOT}/{ROBOT}_slam.yaml')", "config/…/…_slam.yaml"),
        ("[FindPackageShare('my_pkg'), '/config/', LaunchConfiguration('x'), '/map.yaml']", "config/…/map.yaml"),
        (
            "PathJoinSubstitution([FindPackageShare('my_pkg'), 'config', LaunchConfiguration('x'), 'map.yaml'])",
            "config/…/map.yaml",
        ),
        ("os.path.join(share('my_pkg'), 'config', ROBOT + '.yaml')", ""),
        ("os.path.join(share('my_pkg'), 'config', ROBOT, ROBOT + '.yaml')", ""),
        ("os.path.join(share('my_pkg'), 'config', ROBOT, 'mapping.yaml')", ""),
        ("os.path.join(share('my_pkg'), 'config', f'{ROBOT}/mapping.yaml')", ""),
        ("os.path.join(share('my_pkg'), 'maps', ROBOT + '.yaml')", ""),
        ("os.path.join(share('my_pkg'), 'config', ROBOT + '_out/saved.yaml')", ""),
        ("os.path.join(share('other'), 'config/' + ROBOT, 'map.yaml')", ""),
        ("os.path.join(share('my_pkg') + ROBOT, 'config', 'map.yaml')", ""),
        ("os.path.join(share(ROBOT), 'config', 'map.yaml')", ""),
    ],
)
def test_paths_that_no_file_fits(path: str, names: str) -> None:
    assert [text.split("`")[3] for text in told(path)] == [names] * bool(names)


def test_the_name_without_what_stands_before_it_is_meant() -> None:
    (text,) = told("os.path.join(share('my_pkg'), f'config/{ROBOT}/{ROBOT}_mapping.yaml')")
    assert text.startswith("warning: ")
    assert text.endswith("did you mean `config/…/mapping.yaml`?")


def test_files_that_git_ignores_may_be_there() -> None:
    path = "os.path.join(share('my_pkg'), 'config', f'{ROBOT}/{ROBOT}_slam.yaml')"
    assert told(path, _DOT_gitignore="*_slam.yaml\n") == []
    assert told(path, config__small__a_slam_DOT_yaml="a: 1\n") == []
