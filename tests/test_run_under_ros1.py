"""Files that need ROS 1, and that nobody runs under ROS 2 (DEP101)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, existing_files, manifest
from rospkg_cli.testing import lint_files

INSTALL = "install(PROGRAMS scripts/record.py scripts/other.py DESTINATION lib/${PROJECT_NAME})\nament_package()"
OLD = "#!/usr/bin/env python3\nimport rospy\n\nrospy.init_node('record')\n"
BUILT = {
    "package.xml": manifest("", "ament_cmake"),
    "CMakeLists.txt": CMAKE.replace("ament_package()", INSTALL),
    "scripts/record.py": OLD,
    "scripts/other.py": "#!/usr/bin/env python3\n",
}
DOCKER = "docker run -v $PWD/scripts/record.py:/tools/record.py img bash -lc '\n{}python3 /tools/record.py\n'\n"
PLAIN = existing_files(BACKDROPS["ament_python"])


def levels(files: dict[str, str]) -> list[str]:
    found = lint_files(files, ["DEP101"]).findings
    return [each.severity.value for each in found if each.message.startswith("`rospy`")]


@pytest.mark.parametrize(
    ("path", "text", "expected"),
    [
        ("scripts/run.sh", DOCKER.format("source /opt/ros/noetic/setup.bash\n"), "info"),
        ("scripts/run.sh", DOCKER.format("roscore &\n"), "info"),
        ("run.py", "IMAGE = 'ros:melodic'\nCOMMAND = 'python3 /ws/scripts/record.py'\n", "info"),
        ("docker/Dockerfile", "FROM ros:noetic-ros-base\nCOPY scripts/record.py /record.py\n", "info"),
        (
            "compose.yaml",
            "services:\n  a:\n    image: ros:noetic\n    command: python3 /ws/scripts/record.py\n",
            "info",
        ),
        ("README.md", "# Old\n```\n# it\nsource /opt/ros/noetic/setup.bash\npython3 scripts/record.py\n```\n", "info"),
        ("README.md", "# ROS 1\nsource /opt/ros/noetic/setup.bash\n# Now\npython3 scripts/record.py\n", "warning"),
        ("README.md", "# Run\n`roscore`, then `python3 scripts/record.py`\n", "warning"),
        ("run.sh", "source /opt/ros/noetic/setup.bash\nrosrun my_pkg record.py\n", "warning"),
        ("run.sh", "source /opt/ros/noetic/setup.bash\npython3 scripts/other.py\n", "warning"),
        ("run.sh", "source /opt/ros/humble/setup.bash\npython3 scripts/record.py\n", "warning"),
        ("run.sh", "# source /opt/ros/noetic/setup.bash\npython3 scripts/record.py\n", "warning"),
    ],
)
def test_what_runs_a_script_under_ros_1(path: str, text: str, expected: str) -> None:
    assert levels({**BUILT, path: text}) == [expected]


def test_each_file_has_its_own_reason() -> None:
    text = DOCKER.format("source /opt/ros/noetic/setup.bash\n")
    assert sorted(levels({**BUILT, "scripts/other.py": OLD, "run.sh": text})) == ["info", "warning"]
    assert levels({**BUILT, "scripts/other.py": OLD}) == ["warning"]


@pytest.mark.parametrize(
    ("more", "expected"),
    [
        ({"my_pkg/__init__.py": "from .core import run\n"}, "info"),
        ({"my_pkg/__init__.py": "from .core import run\nfrom .old import talk\n"}, "warning"),
        ({"my_pkg/__init__.py": "from .core import run\n", "README.md": "See `my_pkg/old.py`.\n"}, "warning"),
        ({}, "warning"),
    ],
)
def test_a_module_of_ros_1_beside_those_that_are_imported(more: dict[str, str], expected: str) -> None:
    own = {
        **PLAIN,
        "my_pkg/core.py": "def run():\n    pass\n",
        "my_pkg/old.py": "import rospy\n\ntalk = rospy.loginfo\n",
    }
    assert levels({**own, **more}) == [expected]


@pytest.mark.parametrize(("name", "expected"), [("core", "info"), ("old", "warning")])
def test_another_package_imports_a_module(name: str, expected: str) -> None:
    own = {
        **PLAIN,
        "my_pkg/core.py": "def run():\n    pass\n",
        "my_pkg/old.py": "import rospy\n\nrun = rospy.loginfo\n",
    }
    user = {
        **{f"user/{path.replace('my_pkg', 'user')}": text.replace("my_pkg", "user") for path, text in PLAIN.items()},
        "user/package.xml": manifest("  <exec_depend>my_pkg</exec_depend>\n", "ament_python", "user"),
        "user/user/a.py": f"from my_pkg.{name} import run\n",
    }
    assert levels({**{f"my_pkg/{path}": text for path, text in own.items()}, **user}) == [expected]
