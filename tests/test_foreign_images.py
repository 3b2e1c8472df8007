"""What an image of others, or a library that is put there by hand, may bring is no error (CMK117, DEP110, DEP112)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, existing_files, manifest, scripts, setup_py
from rospkg_cli.testing import lint_files

PACKAGE = {
    **{f"src/my_pkg/{path}": text for path, text in existing_files(BACKDROPS["ament_python"]).items()},
    "src/my_pkg/setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
    "src/my_pkg/my_pkg/arm_lib.py": "class Arm:\n    pass\n",
}
TALKER = "{}\n\ndef main():\n    print(1)\n"
NEIGHBOUR = "from arm_lib import Arm\n"
FOREIGN = (
    ("Containerfile", "FROM docker.io/acme/ros-humble:0.1.0\n"),
    ("docker/Dockerfile.robot", "ARG BASE=acme/ros-jazzy:2\nFROM --platform=linux/arm64 ${BASE} AS base\nFROM base\n"),
    ("compose.yaml", "services:\n  arm:\n    image: acme/arm:latest\n    command: ros2 launch my_pkg a.launch.py\n"),
    (".devcontainer/devcontainer.json", '{\n  "image": "acme/ros:jazzy"\n}\n'),
    (".github/workflows/ci.yml", "jobs:\n  build:\n    container: ghcr.io/acme/ros:jazzy\n"),
)
PLAIN = (
    ("Dockerfile", "FROM ros:jazzy AS base\nFROM base\n"),
    ("Dockerfile", "ARG ROS_DISTRO=jazzy\nFROM docker.io/library/ros:${ROS_DISTRO}-ros-base\n"),
    ("Dockerfile", "FROM osrf/ros:humble-desktop\n"),
    ("Dockerfile", "FROM nvcr.io/nvidia/l4t-base:r35\nRUN apt install ros-humble-desktop\n"),
    ("Dockerfile", "ARG BASE\nFROM ${BASE}\nRUN apt install ros-humble-desktop\n"),
    ("web/Dockerfile", "FROM acme/pages:1\nCOPY index.html /srv\n"),
    ("compose.yaml", "services:\n  arm:\n    image: me/arm\n    build: .\n    command: ros2 run a b\n"),
    ("compose.yaml", "services:\n  arm:\n    build: .\n    command: ros2 run a b\n  base:\n    image: influxdb:2\n"),
    (".github/workflows/ci.yml", "jobs:\n  build:\n    container:\n      image: rostooling/setup-ros-docker:ubuntu\n"),
)


def found(files: dict[str, str], code: str = "DEP110") -> tuple[str, str]:
    (only,) = lint_files({**PACKAGE, "src/my_pkg/my_pkg/talker.py": TALKER.format(NEIGHBOUR), **files}, [code]).findings
    return only.severity.value, only.message


@pytest.mark.parametrize(("path", "text"), FOREIGN)
def test_an_image_that_may_bring_anything(path: str, text: str) -> None:
    level, message = found({path: text})
    assert level == "warning"
    assert message.endswith(", which may bring it")
    assert "acme/" in message
    lookup = "from ament_index_python import get_package_share_path\n\nA = get_package_share_path('my_pgk')\n"
    level, message = found({path: text, "src/my_pkg/my_pkg/talker.py": TALKER.format(lookup)}, "DEP112")
    assert level == "warning"
    assert message.endswith(", which may bring it")


@pytest.mark.parametrize(
    ("base", "level"), [("acme/ros:humble", "warning"), ("ros:humble", "error"), ("osrf/ros:humble-desktop", "error")]
)
def test_a_package_that_cmake_looks_for(base: str, level: str) -> None:
    lines = "find_package(rclpcp REQUIRED)\nament_package"
    cmake = {
        "package.xml": manifest("  <depend>rclcpp</depend>\n", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace("ament_package", lines),
        "Dockerfile": f"FROM {base}\nRUN colcon build\n",
    }
    (only,) = lint_files(cmake, ["CMK117"]).findings
    assert only.severity.value == level


@pytest.mark.parametrize(("path", "text"), PLAIN)
def test_plain_images_and_those_of_the_repository(path: str, text: str) -> None:
    level, message = found({path: text})
    assert level == "error"
    assert message.endswith("; write `my_pkg.arm_lib`")


def test_an_image_that_the_repository_makes() -> None:
    made = {"docker/build.sh": "docker build -t me/ros_base .\n", "docker/base/Dockerfile": "FROM ros:jazzy\n"}
    uses = {"docker/robot/Dockerfile": "FROM me/ros_base:latest\nRUN colcon build\n"}
    assert found({**made, **uses})[0] == "error"
    assert found(uses)[0] == "warning"


@pytest.mark.parametrize(
    ("text", "level"),
    [
        ("pip install dist/arm_lib-0.1-py3-none-any.whl", "warning"),
        ("pip3 install -e ./vendor/arm_lib", "warning"),
        ("pip install git+https://example.org/acme/arm-lib.git@main", "warning"),
        ("cd vendor/arm_lib\nsudo python3 setup.py install", "warning"),
        ("cd vendor/arm_lib && python3 setup.py install", "warning"),
        ("sudo cp vendor/arm_lib.py /usr/lib/python3/dist-packages", "warning"),
        ("Copy `arm_lib` to your site-packages.", "warning"),
        ("pip install other_lib", "error"),
        ("cd my_pkg && colcon build", "error"),
        ("The site-packages have arm_lib.", "error"),
    ],
)
def test_a_library_by_hand(text: str, level: str) -> None:
    assert found({"README.md": f"{text}\n"})[0] == level


@pytest.mark.parametrize(
    ("text", "is_told"),
    [
        ("import arm_lib\n\nprint(arm_lib.Arm)\n", True),
        ("import arm_lib\n\nprint(arm_lib.Leg)\n", False),
        ("import arm_lib as lib\n\nprint(lib.Leg())\n", False),
        ("from arm_lib import Leg\n", False),
        ("from arm_lib import Arm\n\nprint(Arm.Leg)\n", True),
    ],
)
def test_another_library_of_the_name(text: str, is_told: bool) -> None:
    files = {**PACKAGE, "src/my_pkg/my_pkg/talker.py": TALKER.format(text)}
    assert bool(lint_files(files, ["DEP110"]).findings) is is_told


def test_a_module_that_imports_its_own_name() -> None:
    files = {"src/my_pkg/my_pkg/talker.py": TALKER.format("from talker import main as run\n")}
    assert not lint_files({**PACKAGE, **files}, ["DEP110"]).findings


@pytest.mark.parametrize(("head", "level"), [("import smbus\n", "warning"), ("import numpy\n", "error")])
def test_a_module_that_drives_a_device_may_be_its_makers_library(head: str, level: str) -> None:
    found_level, message = found({"src/my_pkg/my_pkg/arm_lib.py": f"{head}\n\nclass Arm:\n    pass\n"})
    assert found_level == level
    assert ("it drives a device" in message) == (level == "warning")
