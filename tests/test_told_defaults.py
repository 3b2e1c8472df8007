"""DEP118: defaults of variables of the environment and of options that pages, scripts and launch files give anew."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, SETUP_PY_FOR_ALL, existing_files, scripts, setup_py
from rospkg_cli.testing import lint_files

PLACE = "/home/ada/ws/src/my_pkg/data/a.txt"
PACKAGE = {**existing_files(BACKDROPS["ament_python"]), "data/a.txt": "Ada\n"}
NODE = "import argparse\nimport os\n\n\ndef main():\n{}\n"
VARIABLE = f"    return open(os.environ.get('DATA', '{PLACE}')).read()"
OTHER = f"    return open(os.getenv('DATA', default='{PLACE}')).read()"
OPTION = (
    f"    parser = argparse.ArgumentParser()\n    parser.add_argument('-d', '--data', type=str, default='{PLACE}')\n"
    "    print(open(parser.parse_args().data).read())"
)


def level(code: str, others: dict[str, str]) -> str:
    own = {"setup.py": setup_py(scripts("talker = my_pkg.talker:main")), "my_pkg/talker.py": NODE.format(code)}
    (found,) = lint_files({**PACKAGE, **own, **others}, ["DEP118"]).findings
    return found.severity.value


@pytest.mark.parametrize("code", [VARIABLE, OTHER])
@pytest.mark.parametrize(
    ("others", "expected"),
    [
        ({}, "warning"),
        ({"README.md": "    export DATA=~/a.txt\n    ros2 run my_pkg talker\n"}, "info"),
        ({"run.sh": "DATA=~/a.txt ros2 run my_pkg talker\n"}, "info"),
        ({"Dockerfile": "ENV DATA=/a.txt\n"}, "info"),
        ({"README.md": "The DATA is in `data`. METADATA: none\n"}, "warning"),
        ({"launch/a.launch.xml": '<launch>\n  <set_env name="DATA" value="a"/>\n</launch>\n'}, "info"),
    ],
)
def test_a_variable_of_the_environment(code: str, others: dict[str, str], expected: str) -> None:
    assert level(code, others) == expected


@pytest.mark.parametrize(
    ("page", "expected"),
    [
        ("", "warning"),
        ("    ros2 run my_pkg talker --data a.txt\n", "info"),
        ("    ros2 run my_pkg talker\n", "warning"),
        ("    ros2 run my_pkg talker --data a.txt\n    ros2 run my_pkg talker\n", "warning"),
        ("    ros2 run my_pkg talker --database a.txt\n", "warning"),
    ],
)
def test_an_option(page: str, expected: str) -> None:
    assert level(OPTION, {"README.md": page}) == expected


def test_a_variable_in_a_launch_file() -> None:
    launch = (
        "import os\nfrom launch import LaunchDescription\nfrom launch_ros.actions import Node\n\n\n"
        f"def generate_launch_description():\n    data = os.environ.get('DATA', '{PLACE}')\n"
        "    return LaunchDescription([Node(package='my_pkg', executable='talker', parameters=[data])])\n"
    )
    files = {**PACKAGE, "setup.py": SETUP_PY_FOR_ALL, "launch/a.launch.py": launch}
    for page, expected in (("", "warning"), ("Set it:\n\n    export DATA=a\n", "info")):
        (found,) = lint_files({**files, "README.md": page}, ["DEP118"]).findings
        assert found.severity.value == expected
