"""docs/exercises.md: the exercises of a textbook's chapter on packages, each in one command."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest
from in_process import Done, run_here
from planned import ADA

WHO = ["--maintainer", ADA["maintainer"], "--email", ADA["email"], "--distro", "jazzy"]
TABLE = (Path(__file__).parents[1] / "docs/exercises.md").read_text(encoding="utf-8")
COMMANDS = dict(re.findall(r"^\| ([^|]*) \| `rospkg ([^|]*)` \|$", TABLE, re.MULTILINE))


@pytest.fixture(scope="module")
def done(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Done]:
    """What each command said, one after the other in a workspace."""
    return run_all(tmp_path_factory.getbasetemp() / "exercises")


def run_all(workspace: Path) -> dict[str, Done]:
    (workspace / "src").mkdir(parents=True)
    typed = {title: shlex.split(command) for title, command in COMMANDS.items()}
    return {
        title: run_here(*words, *(WHO if words[0] == "new" else ()), cwd=workspace) for title, words in typed.items()
    }


@pytest.fixture
def src(done: dict[str, Done], tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.getbasetemp() / "exercises/src"


def test_each_command_of_the_page_runs(done: dict[str, Done]) -> None:
    assert len(COMMANDS) == TABLE.count("| `rospkg ") == 9
    assert {title: (each.returncode, each.stderr) for title, each in done.items()} == dict.fromkeys(COMMANDS, (0, ""))
    assert done["Is everything right?"].stdout.startswith("No problems found (12 packages, ")


def test_topics_have_the_names_that_were_asked_for(src: Path) -> None:
    nodes = src / "my_robot_examples/my_robot_examples"
    assert re.search(r"create_publisher\(\s*String, '/chatter'", (nodes / "simple_talker.py").read_text())
    assert re.search(r"create_subscription\(\s*String, '/chatter'", (nodes / "simple_listener.py").read_text())
    laser = (nodes / "sensor_processor.py").read_text()
    assert re.search(r"create_subscription\(\s*LaserScan,\s*'/scan',\s*[\w.]+,\s*qos_profile_sensor_data", laser)


def test_a_package_for_simple_navigation(src: Path) -> None:
    package = src / "my_robot_nav"
    for path in ("package.xml", "setup.py", "my_robot_nav/nav_node.py", "launch/my_robot_nav.launch.py"):
        assert (package / path).is_file()
    manifest = (package / "package.xml").read_text()
    for key in ("geometry_msgs", "nav_msgs", "rclpy", "tf2_ros"):
        assert f"<exec_depend>{key}</exec_depend>" in manifest


def test_a_message_of_ones_own_used_in_a_node(src: Path) -> None:
    assert "float32 battery_level\n" in (src / "my_robot_interfaces/msg/RobotStatus.msg").read_text()
    node = (src / "my_robot/my_robot/my_robot_node.py").read_text()
    assert "from my_robot_interfaces.msg import RobotStatus\n" in node
    assert "message.current_task = ''\n" in node


def test_a_service_of_ones_own_that_a_node_answers(src: Path) -> None:
    node = (src / "my_goals/my_goals/goal.py").read_text()
    assert "from my_goals_interfaces.srv import SetGoal\n" in node
    assert re.search(r"create_service\(\s*SetGoal,", node)


def test_several_executables(src: Path) -> None:
    setup = (src / "my_tools/setup.py").read_text()
    for name in ("nav_node", "path_planner", "nav_cli"):
        assert f"'{name} = my_tools.{name}:main',\n" in setup


def test_a_library_from_outside_by_its_rosdep_key(src: Path, tmp_path: Path) -> None:
    assert "<exec_depend>python3-numpy</exec_depend>" in (src / "my_vision/package.xml").read_text()
    refused = run_here("new", "other_pkg", "--depends", "opencv-python,python3-yaml", *WHO, cwd=tmp_path)
    assert refused.returncode == 2
    assert "write `--depends python3-opencv,python3-yaml`" in refused.stderr


def test_what_colcon_will_do_is_shown(done: dict[str, Done]) -> None:
    assert "my_robot_interfaces" in done["In which order does colcon build?"].stdout
    assert "simple_talker" in done["What does a build install, and where?"].stdout
