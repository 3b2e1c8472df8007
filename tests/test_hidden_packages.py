"""Unknown packages that lie in the repository where colcon does not look, or that a script clones (DEP103, DEP106)."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from in_process import run_here

from rospkg_cli.example import BACKDROPS, existing_files, manifest

PYTHON = existing_files(BACKDROPS["ament_python"])
STARTED = '<launch><node pkg="tof_driver" exec="tof_node"/></launch>\n'
ROBOT = (
    '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="r">\n'
    '  <xacro:include filename="$(find tof_driver)/urdf/tof.xacro"/>\n</robot>\n'
)
BODY = manifest("  <exec_depend>ros2launch</exec_depend>\n  <exec_depend>xacro</exec_depend>\n")
PACKAGE = {**PYTHON, "package.xml": BODY}
HIDDEN = {
    "drivers/COLCON_IGNORE": "",
    "drivers/tof/package.xml": manifest(name="tof_driver"),
    "drivers/tof/setup.py": PYTHON["setup.py"],
}
IMAGE = "FROM ros:jazzy\nCOPY {} /underlay/src/\nRUN cd /underlay && colcon build\n"


def told(root: Path, code: str, files: dict[str, str]) -> list[tuple[str, str]]:
    own = {"launch/a.launch.xml": STARTED} if code == "DEP103" else {"urdf/r.urdf.xacro": ROBOT}
    own |= {"README.md": "    xacro urdf/r.urdf.xacro\n"}
    for path, text in ({f"src/my_pkg/{path}": text for path, text in {**PACKAGE, **own}.items()} | files).items():
        (root / path).parent.mkdir(parents=True, exist_ok=True)
        (root / path).write_text(text)
    report = json.loads(run_here("lint", "--select", code, "--format", "json", "--no-cache", cwd=root).stdout)
    return [(each["severity"], each["message"]) for each in report["findings"]]


@pytest.mark.parametrize("code", ["DEP103", "DEP106"])
@pytest.mark.parametrize(
    ("path", "text", "level"),
    [
        ("docker/Dockerfile", IMAGE.format("drivers/tof"), "info"),
        ("docker/Dockerfile", IMAGE.format("./drivers"), "info"),
        ("docker/Dockerfile", IMAGE.format("other"), "warning"),
        ("README.md", "    cd drivers/tof && colcon build\n", "info"),
        ("README.md", "The drivers are old.\n", "warning"),
        ("build.sh", "rm -f drivers/COLCON_IGNORE\ncolcon build\n", "info"),
    ],
)
def test_what_colcon_passes_by(tmp_path: Path, code: str, path: str, text: str, level: str) -> None:
    """Who builds it apart has it; nobody is told to correct its name or to list its repository."""
    (found,) = told(tmp_path, code, {**HIDDEN, path: text})
    assert found[0] == level
    assert "its sources lie in `drivers/tof`" in found[1]
    assert ("which a script or a page of this repository builds" in found[1]) == (level == "info")


def test_a_package_inside_of_another_one(tmp_path: Path) -> None:
    (found,) = told(tmp_path, "DEP103", {"src/my_pkg/extern/tof/package.xml": manifest(name="tof_driver")})
    assert "`src/my_pkg/extern/tof`" in found[1]


@pytest.mark.parametrize("code", ["DEP103", "DEP106"])
@pytest.mark.parametrize(
    ("path", "text", "level"),
    [
        ("docker/Dockerfile", "RUN git clone -b main https://github.com/ada/tof-driver.git /ws/src/tof\n", "info"),
        ("docker/Dockerfile", "RUN git clone --depth 1 --branch v2 https://git.ada.org/ada/tof_driver_ros2\n", "info"),
        ("docker/Dockerfile", "RUN git clone https://git.ada.org/ada/tof && colcon build\n", "info"),
        ("setup.sh", "git -C src clone git@gitlab.com:ada/tof_driver.git\n", "info"),
        ("setup.sh", "# see https://github.com/ada/tof_driver\n", "warning"),
        (".github/workflows/ci.yml", "      - run: git clone https://github.com/ada/tof_driver\n", "info"),
        ("docs/install.md", "    git clone https://github.com/ada/lidar_driver\n", "warning"),
        ("docs/install.md", "Clone https://github.com/ada/tof_setup into `src`.\n", "info"),
        ("docs/install.md", "See https://github.com/ada/tof_setup for more.\n", "warning"),
        ("src/my_pkg/README.md", "Needs https://github.com/ada/tof-ros2-driver\n    xacro urdf/r.urdf.xacro\n", "info"),
        ("get.sh", "for r in tof_driver other; do\n  git clone $BASE/$r\ndone\n", "info"),
        ("get.sh", "for r in other; do\n  git clone $BASE/$r\ndone\n", "warning"),
        (
            ".github/workflows/ci.yml",
            "      - uses: actions/checkout@v4\n        with:\n          repository: ada/tof\n",
            "info",
        ),
        (".github/workflows/ci.yml", "          vcs-repo-file-url: https://example.org/ada/deps.repos\n", "info"),
    ],
)
def test_what_a_script_clones(tmp_path: Path, code: str, path: str, text: str, level: str) -> None:
    assert [each[0] for each in told(tmp_path, code, {path: text})] == [level]


def test_a_repository_that_may_be_this_one(tmp_path: Path) -> None:
    """A page has people clone the repository that it lies in: this says nothing of an unknown package."""
    inner = {
        "src/tof_msgs/package.xml": manifest(name="tof_msgs"),
        "README.md": "git clone git@g.org:a/tof_robot.git\n",
    }
    assert [each[0] for each in told(tmp_path, "DEP103", inner)] == ["warning"]


def test_a_repository_that_lies_here(tmp_path: Path) -> None:
    inner = {"TOF-SDK/main.c": "int main() {}\n", "TOF-SDK/README.md": "git clone https://g.org/ada/TOF-SDK.git\n"}
    assert [each[0] for each in told(tmp_path, "DEP103", inner)] == ["warning"]
