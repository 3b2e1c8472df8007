"""What CMake takes for another thing than is meant: variables without a dollar sign, classes of another library."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

CORE = "add_library(core SHARED src/core.cpp)\ninstall(TARGETS core DESTINATION lib)\n"
CPP = "int core() {return 1;}\n"


def told(code: str, lines: str, files: dict[str, str] | None = None, depends: str = "") -> list[tuple[str, str]]:
    given = {
        "CMakeLists.txt": CMAKE.replace("ament_package()", f"{CORE}{lines}\nament_package()"),
        "package.xml": manifest(depends, "ament_cmake"),
        "src/core.cpp": CPP,
        "launch/a.launch.xml": "<launch/>\n",
        **(files or {}),
    }
    return [(each.severity.value, each.message) for each in lint_files(given, [code]).findings]


@pytest.mark.parametrize(
    "line, text",
    [
        ("install(DIRECTORY launch DESTINATION share/{PROJECT_NAME})", "{PROJECT_NAME}"),
        ("install(DIRECTORY launch DESTINATION share/{$PROJECT_NAME})", "{$PROJECT_NAME}"),
        ("install(DIRECTORY launch DESTINATION share/$(PROJECT_NAME))", "$(PROJECT_NAME)"),
        ("install(DIRECTORY launch DESTINATION share/$PROJECT_NAME)", "$PROJECT_NAME"),
        ('make_parameters("{CMAKE_CURRENT_SOURCE_DIR}/params.yaml")', "{CMAKE_CURRENT_SOURCE_DIR}"),
        ("set(NEEDS rclcpp)\nament_target_dependencies(core {NEEDS})", "{NEEDS}"),
        ("ament_target_dependencies(core {NEEDS})", ""),
        ("set(ENV{PROJECT_NAME} $ENV{PROJECT_NAME})", ""),
        (r"set(TEXT \${PROJECT_NAME} @PROJECT_NAME@ {{PROJECT_NAME}} ${PROJECT_NAME} [[{PROJECT_NAME}]])", ""),
        ('message(STATUS "{PROJECT_NAME}")', ""),
        ("add_custom_target(all_of_it COMMAND make -C $(CMAKE_SOURCE_DIR) $PROJECT_NAME)", ""),
        ('install(CODE "execute_process(COMMAND {PROJECT_NAME})")', ""),
    ],
)
def test_variables_without_their_dollar_sign(line: str, text: str) -> None:
    found = told("CMK126", line)
    assert [message.partition(" is ")[0] for _, message in found] == ([f"`{text}`"] if text else [])


@pytest.mark.parametrize(
    ("line", "level"),
    [
        ("add_executable(a a.cpp)\ninstall(TARGETS a DESTINATION lib/$(PROJECT_NAME))", "warning"),
        ("install(TARGETS DESTINATION lib/$(PROJECT_NAME))", "info"),
        ("add_executable(a a.cpp)\ninstall(TARGETS a DESTINATION lib/$(PROJECT_NAME))\nament_auto_package()", "info"),
    ],
)
def test_targets_that_are_installed_all_the_same(line: str, level: str) -> None:
    assert [severity for severity, _ in told("CMK126", line)] == [level]


TWO = """\
find_package(rclcpp_components REQUIRED)
add_library(talker SHARED src/talker.cpp)
add_library(listener SHARED src/listener.cpp)
install(TARGETS talker listener DESTINATION lib)
"""
CLASSES = {
    f"src/{each.lower()}.cpp": f"RCLCPP_COMPONENTS_REGISTER_NODE(my::{each})\n" for each in ("Talker", "Listener")
}
REGISTER = 'rclcpp_components_register_nodes({} "my::{}")\n'
RIGHT = REGISTER.format("talker", "Talker")


@pytest.mark.parametrize(
    "lines, levels",
    [
        (RIGHT + REGISTER.format("listener", "Listener"), []),
        (RIGHT + REGISTER.format("talker", "Listener"), ["error"]),
        (RIGHT + REGISTER.format("listener", "Talker") + REGISTER.format("listener", "Listener"), ["warning"]),
        (RIGHT + "target_link_libraries(talker listener)\n" + REGISTER.format("talker", "Listener"), []),
        (RIGHT + "target_link_libraries(talker ${PCL_LIBRARIES})\n" + REGISTER.format("talker", "Listener"), ["error"]),
        (RIGHT + "target_sources(talker PRIVATE src/listener.cpp)\n" + REGISTER.format("talker", "Listener"), []),
    ],
)
def test_components_of_another_library(lines: str, levels: list[str]) -> None:
    found = [level for level, message in told("CMK108", TWO + lines, CLASSES) if "is not made of" in message]
    assert found == levels


def test_packages_of_one_word() -> None:
    """One that ament is handed and whose headers are included is no library of the system."""
    lines = "find_package(keisan REQUIRED)\nament_target_dependencies(core keisan)"
    header = {"src/core.cpp": f'#include "keisan/angle.hpp"\n{CPP}'}
    assert [level for level, message in told("DEP104", lines, header) if "`keisan`" in message] == ["info"]
    assert told("DEP104", lines) == []
    assert told("DEP104", lines, header, "  <depend>keisan</depend>\n") == []


PLAIN = "cmake_minimum_required(VERSION 3.20)\nproject(my_pkg)\n" + CORE


@pytest.mark.parametrize(
    "lines, count",
    [
        ("", 1),
        ("install(FILES package.xml DESTINATION share/my_pkg)\n", 0),
        ("include(${SOMETHING})\n", 0),
        ("find_package(ament_cmake REQUIRED)\nament_package()\n", 0),
        ("install_all_of_it(my_pkg)\n", 0),
    ],
)
def test_manifests_of_plain_cmake(lines: str, count: int) -> None:
    package = manifest("  <buildtool_depend>cmake</buildtool_depend>\n", "cmake")
    files = {"CMakeLists.txt": PLAIN + lines, "package.xml": package, "src/core.cpp": CPP}
    assert len(lint_files(files, ["CMK127"]).findings) == count


TWIN = {
    "include/my_pkg/joint.hpp": "class Joint\n{\npublic:\n  static const int count;\n  void move();\n};\n",
    "src/joint.cpp": '#include "my_pkg/joint.hpp"\nconst int Joint::count = 3;\nvoid Joint::move() {}\n',
    "src/core.cpp": f'#include "my_pkg/joint.hpp"\n{CPP}',
}


@pytest.mark.parametrize(
    "lines, files, levels",
    [
        ("", {}, ["info"]),
        ("", {"src/core.cpp": '#include "my_pkg/joint.hpp"\nint core() {return Joint::count;}\n'}, ["warning"]),
        ("", {"src/core.cpp": CPP}, []),
        ("# src/joint.cpp is built elsewhere", {}, []),
        ("target_sources(core PRIVATE src/joint.cpp)", {}, []),
        ("", {"include/my_pkg/joint.hpp": "class Joint\n{\n  static const int count = 3;\n  void move() {}\n};\n"}, []),
        ("", {"src/core.cpp": '#include "my_pkg/joint.hpp"\n#include "joint.cpp"\n'}, []),
    ],
)
def test_sources_that_belong_to_a_header(lines: str, files: dict[str, str], levels: list[str]) -> None:
    found = told("CMK202", f"target_include_directories(core PRIVATE include)\n{lines}", {**TWIN, **files})
    assert [level for level, _ in found] == levels
    assert all("`src/joint.cpp`, which has `Joint::" in message for _, message in found)


SIGNS_HEADER = '#include "my_pkg/signs.hpp"\n'
SIGNS = {
    "include/my_pkg/signs.hpp": "namespace signs\n{\nint sign_of(double value);\nint size();\n}\n",
    "src/signs.cpp": '#include "my_pkg/signs.hpp"\nnamespace signs\n{\n'
    "int sign_of(double value) {return value < 0 ? -1 : 1;}\nint size() {return 2;}\n}\n",
    "src/core.cpp": '#include "my_pkg/signs.hpp"\nint core() {if (signs::sign_of(2)) {return 1;} return 0;}\n',
}


@pytest.mark.parametrize(
    "lines, files, count",
    [
        ("", {}, 1),
        (
            "",
            {"src/core.cpp": SIGNS_HEADER + "using namespace signs;\nint core() {return sign_of(2);}\n"},
            1,
        ),
        ("", {"src/core.cpp": SIGNS_HEADER + "int core() {return 0;}\n"}, 0),  # no one calls it
        ("", {"src/core.cpp": SIGNS_HEADER + "int core() {return std::sign_of(a) + b.size();}\n"}, 0),
        ("", {"src/core.cpp": "int sign_of(double a);\nint core() {return sign_of(2);}\n"}, 0),  # without its header
        (
            "",
            {"src/core.cpp": SIGNS_HEADER + "#if 0\nint core() {return signs::sign_of(2);}\n#endif\n"},
            0,
        ),
        ("", {"include/my_pkg/signs.hpp": "inline int sign_of(double value) {return value < 0 ? -1 : 1;}\n"}, 0),
        ("", {"include/my_pkg/signs.hpp": "class Signs\n{\n  int sign_of(double value);\n};\n"}, 0),
        ("target_sources(core PRIVATE src/more.cpp)", {"src/more.cpp": "int sign_of(double a) {return 0;}\n"}, 0),
        ("target_sources(core PRIVATE src/signs.cpp)", {}, 0),
    ],
)
def test_functions_of_sources_that_no_target_has(lines: str, files: dict[str, str], count: int) -> None:
    found = told("CMK202", f"target_include_directories(core PRIVATE include)\n{lines}", {**SIGNS, **files})
    assert [level for level, _ in found] == ["warning"] * count
    assert all("which has `sign_of`; `src/core.cpp` uses it" in message for _, message in found)
