"""What fails only in a build with a switch that nothing turns on is an info."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

HEADER = {"include/my_pkg/words.hpp": "inline int words() {return 0;}\n"}
SOURCE = {"src/talker.cpp": "#include <my_pkg/words.hpp>\nint main() {return words();}\n"}
TARGET = "add_executable(talker src/talker.cpp)\ninstall(TARGETS talker DESTINATION lib/${PROJECT_NAME})\n"
MIXED = "target_link_libraries(talker PUBLIC m)\ntarget_link_libraries(talker dl)\n"


def levels(lines: str, option: str, page: str, code: str) -> list[str]:
    switched = f'option(WITH_TOOLS "tools" {option})\nif(WITH_TOOLS)\n{lines}endif()\n' if option else lines
    files = {
        **HEADER,
        **SOURCE,
        "package.xml": manifest("", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace("ament_package", f"{switched}ament_package"),
        "README.md": page,
    }
    return [each.severity.value for each in lint_files(files, [code]).findings]


@pytest.mark.parametrize(
    "lines, code, without", [(TARGET, "CMK201", "warning"), (f"{TARGET}{MIXED}", "CMK122", "error")]
)
def test_a_fault_behind_a_switch(lines: str, code: str, without: str) -> None:
    assert levels(lines, "", "", code) == [without]
    assert levels(lines, "OFF", "", code) == ["info"]
    assert levels(lines, "OFF", "colcon build --cmake-args -DWITH_TOOLS=ON", code) == ["warning"]
