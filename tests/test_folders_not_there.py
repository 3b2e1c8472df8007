"""Sub-folders that are not here, as of submodules, have a scope of their own: what the package does itself is known."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

FETCH = "include(FetchContent)\nFetchContent_Declare(sdk URL sdk.zip)\nFetchContent_MakeAvailable(sdk)\n"
APART = ["add_subdirectory(sdk)\n", "add_subdirectory(sdk EXCLUDE_FROM_ALL)\n", FETCH]
AMONG = ["include(sdk/all.cmake)\n", "add_subdirectory(${WHERE})\n"]
LINES = """\
find_package(rclcpp REQUIRED)
find_package(sensor_msgs REQUIRED)
add_executable(node src/node.cpp)
target_link_libraries(node rclcpp::rclcpp {})
install(TARGETS node DESTINATION lib/${{PROJECT_NAME}})
"""
NEEDS = "  <depend>rclcpp</depend>\n  <depend>sensor_msgs</depend>\n"
NODE = "#include <sensor_msgs/msg/image.hpp>\nint main() {}\n"
SPARE = "int main() {\n  rclcpp::init(0, nullptr);\n}\n"


def told(first: str, link: str = "") -> list[str]:
    """Return code and level of what is said of a package with a folder, a program and a source left out."""
    files = {
        "CMakeLists.txt": CMAKE.replace("ament_package()", f"{first}{LINES.format(link)}ament_package()"),
        "package.xml": manifest(NEEDS, "ament_cmake"),
        "src/node.cpp": NODE,
        "src/spare.cpp": SPARE,
        "config/node.yaml": "/**:\n  ros__parameters:\n    rate: 2.0\n",
    }
    found = lint_files(files, ["CMK101", "CMK121", "CMK202"]).findings
    return [f"{each.code} {each.severity.value}" for each in found]


@pytest.mark.parametrize("first", ["", *APART])
def test_what_the_package_does_itself_is_known(first: str) -> None:
    assert told(first) == ["CMK101 info", "CMK121 warning", "CMK202 info"]


@pytest.mark.parametrize("first", APART)
def test_a_library_of_the_folder_may_bring_headers(first: str) -> None:
    assert told(first, "sdk") == ["CMK101 info", "CMK121 info", "CMK202 info"]
    assert told(first, "usb-1.0") == ["CMK101 info", "CMK121 warning", "CMK202 info"]
    assert told(first, "sdk::sdk") == ["CMK101 info", "CMK202 info"]


@pytest.mark.parametrize("first", AMONG)
def test_what_is_read_in_the_same_scope_may_do_all(first: str) -> None:
    assert told(first) == []


INSTALLS = "install(DIRECTORY launch DESTINATION share/my_pkg)"


@pytest.mark.parametrize(
    ("ignored", "lines", "level"),
    [
        ("launch", INSTALLS, ["info"]),
        ("/launch/", "install(DIRECTORY launch/ DESTINATION share/my_pkg)", ["info"]),
        ("build", INSTALLS, ["error"]),
        ("models", "install(DIRECTORY models DESTINATION share/my_pkg)", []),
        ("launch", INSTALLS.replace(")", " OPTIONAL)"), []),
        ("launch", f"if(X)\n  {INSTALLS}\nendif()", []),
        ("launch", f"if(EXISTS launch)\n  {INSTALLS}\nendif()", []),
        ("launch", f"file(MAKE_DIRECTORY launch)\n{INSTALLS}", []),
        (
            "launch",
            f"execute_process(COMMAND ./a WORKING_DIRECTORY ${{PROJECT_SOURCE_DIR}})\n{INSTALLS}",
            [],
        ),
    ],
)
def test_installed_folders_that_git_ignores(ignored: str, lines: str, level: list[str]) -> None:
    files = {
        "CMakeLists.txt": CMAKE.replace("ament_package()", f"{lines}\nament_package()"),
        "package.xml": manifest("", "ament_cmake"),
        ".gitignore": f"{ignored}\n",
    }
    assert [each.severity.value for each in lint_files(files, ["CMK102"]).findings] == level
