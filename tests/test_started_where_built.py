"""Programs that no rule installs, and that pages or scripts start where the build puts them (CMK103)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

LINKED = "target_link_libraries(talker rclcpp::rclcpp)\n"
BUILT = f"find_package(rclcpp REQUIRED)\nadd_executable(talker src/talker.cpp)\n{LINKED}"
NODE = "#include <rclcpp/rclcpp.hpp>\nint main(int c, char ** v) {rclcpp::init(c, v); rclcpp::spin(nullptr);}\n"


def level(text: str, path: str = "README.md") -> str:
    files = {
        "package.xml": manifest("  <depend>rclcpp</depend>\n", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace("ament_package", f"{BUILT}ament_package"),
        "src/talker.cpp": NODE,
    }
    (found,) = lint_files(
        {f"src/my_pkg/{each}": text for each, text in files.items()} | {path: text}, ["CMK103"]
    ).findings
    return found.severity.value


@pytest.mark.parametrize(
    "text",
    [
        "`./talker`\n",
        "    ./bin/talker --rate 5\n",
        "    bin/talker\n",
        "src/my_pkg/bin/talker\n",
        "~/ws/build/my_pkg/src/talker\n",
        "cd build && ./my_pkg/talker\n",
    ],
)
def test_a_program_that_is_started_where_it_is_built(text: str) -> None:
    assert level(text) == "info"
    assert level(text, "run_talker.sh") == "info"


@pytest.mark.parametrize(
    "text",
    [
        "ros2 run my_pkg talker\n",
        "./install/my_pkg/lib/my_pkg/talker\n",
        "/usr/bin/talker\n",
        "./talker.sh\n",
        "talker\n",
    ],
)
def test_a_program_that_is_started_once_it_is_installed(text: str) -> None:
    assert level(text) == "warning"


def test_a_program_that_is_started_in_both_ways() -> None:
    assert level("`./build/my_pkg/talker`, or `ros2 run my_pkg talker`\n") == "warning"
