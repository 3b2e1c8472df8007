"""What a page has people leave out of a build on purpose need not be declared for a launch: an info."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, manifest
from rospkg_cli.testing import lint_files

PYTHON = existing_files(BACKDROPS["ament_python"])
SINGLE = "colcon build --packages-up-to my_pkg"
FENCED = f"```bash\ncd ~/ws\nsource /opt/ros/humble/setup.bash\n{SINGLE}\n```\n"
WHOLE = "## Build\n```bash\ncolcon build\n```\n"


def level(page: str, launch: str = "simulator", path: str = "README.md") -> str:
    """Return the level of the one finding, and hold that it says why it is mild."""
    tree = {f"src/planner/my_pkg/{each}": text for each, text in PYTHON.items()}
    tree["src/planner/my_pkg/package.xml"] = manifest("  <exec_depend>ros2launch</exec_depend>\n")
    tree[f"src/planner/my_pkg/launch/{launch}.launch.xml"] = '<launch><node pkg="maze_maps" exec="a"/></launch>\n'
    tree |= {f"src/maze_maps/{each}": text.replace("my_pkg", "maze_maps") for each, text in PYTHON.items()}
    (found,) = (each for each in lint_files({**tree, path: page}, ["DEP103"]).findings if "`maze_maps`" in each.message)
    assert ("a page here has people build" in found.message) is (found.severity.value == "info")
    return found.severity.value


@pytest.mark.parametrize(
    ("page", "wanted"),
    [
        (f"{WHOLE}## The planner alone (without the simulator)\n{FENCED}", "info"),
        (f"### 1.2 只编核心规划器（不含仿真器）\n{FENCED}", "info"),
        (f"The core, no simulation:\n{FENCED}", "info"),
        (f"    {SINGLE}   # w/o simulator\n", "info"),
        (
            "```\ncolcon build --symlink-install \\\n  --packages-select msgs my_pkg # excluding simulators\n```\n",
            "info",
        ),
        (f"On the robot type `{SINGLE}`, which skips the simulator.\n", "info"),
        (f"## Nur der Planer, ohne Simulator\n{FENCED}", "info"),
        ("", "warning"),
        (f"## Build\n{FENCED}", "warning"),
        (f"## The planner alone\n{FENCED}", "warning"),
        (f"## Without the simulator\n{WHOLE}{FENCED}", "warning"),
        (f"## Without the driver\n{FENCED}", "warning"),
        ("## Without the simulator\n    colcon build --packages-up-to other_pkg\n", "warning"),
        ("Without the simulator:\n    colcon build --packages-up-to my_pkg maze_maps\n", "warning"),
        (f"The simulator needs no GPU.\n## Build\n{FENCED}", "warning"),
    ],
)
def test_what_a_page_says_of_a_build(page: str, wanted: str) -> None:
    assert level(page) == wanted


@pytest.mark.parametrize(
    ("launch", "wanted"),
    [
        ("simulator", "info"),
        ("sim", "info"),
        ("arm_gazebo", "info"),
        ("sim/arm", "info"),
        ("run", "warning"),
        ("simple", "warning"),
    ],
)
def test_which_launch_files_are_of_a_part(launch: str, wanted: str) -> None:
    assert level(f"## Core (without simulation)\n{FENCED}", launch, "docs/build.md") == wanted


def test_other_parts_than_simulators() -> None:
    assert level(f"## Without the calibration tools\n{FENCED}", "calibration_tool") == "info"
    assert level(f"## Without errors in the launch files\n{FENCED}", "run") == "warning"
