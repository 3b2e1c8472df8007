"""`rospkg rename node`: the executable, what makes it, and what starts it."""

from __future__ import annotations

from pathlib import Path

import pytest
from in_process import run_here
from renaming import CMAKE, below, named, python_package, texts
from writing import Write

from rospkg_cli.change import ChangeError
from rospkg_cli.renaming.node_plan import plan_rename_node
from rospkg_cli.renaming.plan import RenamePlan
from rospkg_cli.tree import MemoryTree

PYTHON = below("robot", python_package("robot")) | {"other/package.xml": named("other")}
CPP = {
    "robot/package.xml": named("robot", CMAKE, "ament_cmake"),
    "robot/CMakeLists.txt": """\
project(robot)
add_executable(drive src/drive.cpp)
target_link_libraries(drive rclcpp::rclcpp)
add_custom_command(OUTPUT a COMMAND $<TARGET_FILE:drive>)
install(TARGETS drive DESTINATION lib/${PROJECT_NAME})
install(PROGRAMS scripts/turn.py DESTINATION lib/${PROJECT_NAME})
""",
    "robot/src/drive.cpp": "int main() {}\n",
    "robot/scripts/turn.py": "#!/usr/bin/env python3\n",
    "other/package.xml": named("other"),
}


def renamed(files: dict[str, str], old: str, new: str) -> RenamePlan:
    """Rename in memory, and check that renaming back brings back every file."""
    plan = plan_rename_node(MemoryTree.of(files), "robot", old, new)
    assert texts(plan_rename_node(plan.draft.tree, "robot", new, old).draft.tree) == files
    return plan


def test_an_entry_point() -> None:
    done = texts(renamed(PYTHON, "drive", "steer").draft.tree)
    before = PYTHON["robot/setup.py"]
    assert done == PYTHON | {"robot/setup.py": before.replace("drive = robot.drive:main", "steer = robot.drive:main")}


def test_an_entry_point_whose_module_is_computed() -> None:
    before = PYTHON["robot/setup.py"]
    setup = before.replace("'drive = robot.drive:main'", "'drive = ' + package_name + '.drive:main'")
    done = texts(renamed(PYTHON | {"robot/setup.py": setup}, "drive", "steer").draft.tree)
    assert done["robot/setup.py"] == setup.replace("'drive = '", "'steer = '")


def test_a_target() -> None:
    done = texts(renamed(CPP, "drive", "steer").draft.tree)
    cmake = (
        CPP["robot/CMakeLists.txt"]
        .replace("drive", "steer")
        .replace("drive.cpp", "x")
        .replace("src/steer", "src/drive")
    )
    assert done == CPP | {"robot/CMakeLists.txt": cmake}


def test_a_script() -> None:
    done = texts(renamed(CPP, "turn.py", "swing.py").draft.tree)
    assert done["robot/scripts/swing.py"] == CPP["robot/scripts/turn.py"]
    assert "scripts/swing.py DESTINATION" in done["robot/CMakeLists.txt"]


@pytest.mark.parametrize(
    ("path", "line"),
    [
        (
            "launch/a.launch.py",
            "Node(package='robot', executable='«»', name='drive')\nNode(package='b', executable='drive')",
        ),
        (
            "test/test_a.py",
            "owner = 'robot'\nNode(package=owner, executable='«»')\ncmd = ['ros2', 'run', 'robot', '«»']",
        ),
        ("launch/a.launch.xml", '<node pkg="robot" exec="«»" name="drive"/><node pkg="b" exec="drive"/>'),
        ("launch/a.launch.yaml", "launch:\n- node:\n    pkg: robot\n    exec: «»\n    name: drive"),
        ("urdf/a.xml", '<a cmd="$(exec-in-pkg «» robot) drive"/>'),
        ("a.sh", "ros2 run robot «» --ros-args -r __node:=drive\nros2 run b drive"),
        ("README.md", "ros2 run robot drive"),
    ],
)
def test_what_starts_it(path: str, line: str) -> None:
    """`«»` stands for the name where it means the executable."""
    files = PYTHON | {f"other/{path}": line.replace("«»", "drive") + "\n"}
    done = texts(renamed(files, "drive", "steer").draft.tree)
    assert done[f"other/{path}"] == line.replace("«»", "steer") + "\n"


@pytest.mark.parametrize(
    ("files", "old", "new", "said"),
    [
        (PYTHON, "drivr", "steer", "installs no executable `drivr` .did you mean `drive`"),
        (CPP, "drive", "turn.py", "has an executable `turn.py` already"),
        (
            PYTHON | {"robot/setup.py": PYTHON["robot/setup.py"].replace("'drive =", "'dri' 've =")},
            "drive",
            "steer",
            "what makes the executable `drive` is not understood",
        ),
    ],
)
def test_what_can_not_be(files: dict[str, str], old: str, new: str, said: str) -> None:
    with pytest.raises(ChangeError, match=said):
        plan_rename_node(MemoryTree.of(files), "robot", old, new)


def test_the_command(tmp_path: Path, write: Write) -> None:
    root = write(tmp_path / "ws", below("src", PYTHON))
    done = run_here("rename", "node", "drive", "steer", "--package", "src/robot", "--allow-dirty", cwd=root)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith("edit   src/robot/setup.py\n")
    assert "'steer = robot.drive:main'" in (root / "src/robot/setup.py").read_text()
    wrong = run_here("rename", "node", "steer", "New", cwd=root / "src/robot")
    assert (wrong.returncode, "`New` can't be the name of a node" in wrong.stderr) == (2, True)


def test_a_node_called_like_its_package_is_refused_without_an_option_of_another_command(
    tmp_path: Path, write: Write
) -> None:
    write(tmp_path, PYTHON)
    done = run_here("rename", "node", "drive", "robot", "--package", "robot", cwd=tmp_path)
    assert (done.returncode, "--node" in done.stderr, "; try `robot_node`" in done.stderr) == (2, False, True)
