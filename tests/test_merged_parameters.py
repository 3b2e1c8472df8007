"""Aliases in a parameter file that launch reads with PyYAML and writes out before rcl sees it (PRM004)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS
from rospkg_cli.testing import lint_files

YAML = """\
amcl:
  ros__parameters: &common
    VALUES
controller_server:
  ros__parameters:
    <<: *common
    controller_frequency: 20.0
"""
START = """\
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription


def generate_launch_description():
    file = os.path.join(get_package_share_directory('my_pkg'), 'config', 'nav.yaml')
    LINE
"""
REWRITTEN = (
    "return LaunchDescription([Node(package='a', executable='b', parameters=[RewrittenYaml(source_file=file)])])"
)
INCLUDED = (
    "start = os.path.join(get_package_share_directory('nav2_bringup'), 'launch', 'bringup_launch.py')\n"
    "    return LaunchDescription([IncludeLaunchDescription(start, launch_arguments={'params_file': file}.items())])"
)
HANDED = "return LaunchDescription([Node(package='a', executable='b', parameters=[file])])"


def told(line: str, values: str = "use_sim_time: true") -> bool:
    files = {"config/nav.yaml": YAML.replace("VALUES", values), "launch/a.launch.py": START.replace("LINE", line)}
    return bool(lint_files({**BACKDROPS["config"], **files}, ["PRM004"]).findings)


@pytest.mark.parametrize("line", [REWRITTEN, INCLUDED])
def test_what_pyyaml_merges_and_writes_out_is_left_alone(line: str) -> None:
    assert not told(line)
    assert told(line, "plugins: [a, b]")  # PyYAML writes a shared list as an alias again


def test_rcl_refuses_it_where_a_node_gets_the_file() -> None:
    assert told(HANDED)
