"""Targets that are linked with and without a keyword (CMK122): which calls count, and when both are run."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.finding import Severity
from rospkg_cli.testing import lint_files

FOUND = "find_package(rclcpp REQUIRED)\nfind_package(odd_thing REQUIRED)\nfind_package(OpenMP)\nfind_package(Other)\n"
NEEDS = "  <depend>rclcpp</depend>\n  <depend>odd_thing</depend>\n"
NODE = "add_executable(node src/node.cpp)\n"
PLAIN, WORD = "target_link_libraries(node m)\n", "target_link_libraries(node PRIVATE pthread)\n"
AMENT = "ament_target_dependencies(node rclcpp)\n"
AUTO = "find_package(ament_cmake_auto REQUIRED)\nament_auto_find_build_dependencies()\n"
NODE_AUTO = "ament_auto_add_executable(node src/node.cpp)\n"
ERROR, WARNING = Severity.ERROR, Severity.WARNING


def lint(lines: str, needs: str = NEEDS) -> list[tuple[Severity, str, bool]]:
    """Return level, last advice and whether there is a fix."""
    files = {
        "CMakeLists.txt": CMAKE.replace("ament_package()", f"{FOUND}{lines}ament_package()"),
        "package.xml": manifest(needs, "ament_cmake"),
        "src/node.cpp": "int main() {return 0;}\n",
    }
    found = lint_files(files, ["CMK122"]).findings
    return [(each.severity, each.message.rpartition("; ")[2], each.fix is not None) for each in found]


LINKED = "write `PUBLIC` behind the target of `target_link_libraries`"
HANDED = "write `PUBLIC` behind the target of `ament_target_dependencies`"


@pytest.mark.parametrize(
    "lines, expected",
    [
        (PLAIN + WORD, (ERROR, LINKED, True)),
        (WORD + PLAIN, (ERROR, LINKED, True)),
        (AMENT + WORD, (ERROR, HANDED, True)),
        (WORD + AMENT + PLAIN, (ERROR, HANDED, True)),
        ("ament_target_dependencies(node SYSTEM rclcpp)\n" + WORD, (ERROR, HANDED, False)),
        ("target_link_libraries(node PUBLIC ${X_TARGETS} m)\n" + PLAIN, (ERROR, LINKED, True)),
        (f"{PLAIN}if(OpenMP_FOUND)\n{WORD}endif()\n", (WARNING, LINKED, True)),
        (f"if(OpenMP_FOUND)\n{PLAIN}{WORD}endif()\n", (WARNING, LINKED, True)),
        (f"if(OpenMP_FOUND)\n{PLAIN}if(Other_FOUND)\n{WORD}endif()\nendif()\n", (WARNING, LINKED, True)),
        (f"if(BUILD_TESTING)\n{PLAIN}endif()\n{WORD}", (ERROR, LINKED, True)),
    ],
)
def test_calls_that_differ(lines: str, expected: tuple[Severity, str, bool]) -> None:
    assert lint(NODE + lines) == [expected]


@pytest.mark.parametrize(
    "lines",
    [
        PLAIN + AMENT,
        WORD + "ament_target_dependencies(node PUBLIC rclcpp)\n",
        "target_link_libraries(node PRIVATE)\n" + PLAIN,
        "target_link_libraries(node ${NOTHING})\n" + WORD,
        "ament_target_dependencies(node odd_thing)\n" + WORD,
        "target_link_libraries(node LINK_PUBLIC m)\n" + PLAIN + "target_link_libraries(node LINK_PRIVATE m)\n",
        f"if(OpenMP_FOUND)\n{PLAIN}else()\n{WORD}endif()\n",
        f"if(OpenMP_FOUND)\n{PLAIN}endif()\nif(Other_FOUND)\n{WORD}endif()\n",
        "target_link_libraries(other m)\n" + WORD,
    ],
)
def test_calls_that_agree_or_are_not_known(lines: str) -> None:
    assert lint(NODE + lines) == []


def test_commands_that_link_what_they_make() -> None:
    auto = (WARNING, "leave out the keyword, as `ament_auto_add_executable` takes none", False)
    assert lint(AUTO + NODE_AUTO + WORD) == [auto]
    assert lint(AUTO + NODE_AUTO + PLAIN) == []
    assert lint(AUTO + NODE_AUTO + WORD, "  <exec_depend>rclcpp</exec_depend>\n") == []
    assert lint(NODE_AUTO + WORD) == []
    module = "find_package(pybind11 REQUIRED)\npybind11_add_module(node src/node.cpp)\n"
    assert lint(module + PLAIN) == [(ERROR, LINKED, True)]
    assert lint(module + WORD) == []
    test = "find_package(ament_cmake_gtest REQUIRED)\nament_add_gtest(node src/node.cpp)\n"
    assert lint(test + WORD) == [(ERROR, "leave out the keyword, as `ament_add_gtest` takes none", False)]
    assert lint(NODE + "rosidl_target_interfaces(node my_pkg cpp)\n" + WORD)[0][0] is ERROR


IN_TARGET = f"{PLAIN}if(TARGET plugins)\n{WORD}endif()\n"


@pytest.mark.parametrize(
    "lines, levels",
    [
        (f"if(EXISTS ${{CMAKE_CURRENT_SOURCE_DIR}}/plugins)\n{{}}endif()\n{IN_TARGET}", []),
        (f"if(EXISTS ${{CMAKE_CURRENT_SOURCE_DIR}}/src)\n{{}}endif()\n{IN_TARGET}", [ERROR]),
        (f"if(EXISTS ${{CMAKE_CURRENT_SOURCE_DIR}}/plugins)\nelse()\n{{}}endif()\n{IN_TARGET}", [ERROR]),
        (f"if(WITH_PLUGINS)\n{{}}endif()\n{IN_TARGET}", [WARNING]),
        (f"if(FALSE)\n{{}}endif()\n{IN_TARGET}".replace("TARGET plugins", "TARGET plugins AND WITH_MORE"), []),
        (f"if(FALSE)\n{{}}endif()\n{IN_TARGET}".replace("TARGET plugins", "TARGET plugins OR WITH_MORE"), [WARNING]),
        (f"if(FALSE)\n{{}}endif()\n{IN_TARGET}".replace("TARGET", "NOT TARGET"), [WARNING]),
        (f"if(FALSE)\n{{}}else()\n  find_package(Plugins)\nendif()\n{IN_TARGET}", [WARNING]),
        (f"if(FALSE)\n{{}}endif()\ninclude(${{team_DIR}}/plugins.cmake)\n{IN_TARGET}", [WARNING]),
        (f"if(FALSE)\n{{}}endif()\nteam_plugins(fast)\n{IN_TARGET}", [WARNING]),
        (IN_TARGET, [WARNING]),
    ],
)
def test_a_branch_for_a_target(lines: str, levels: list[Severity]) -> None:
    made = lines.replace("{}", "  add_library(plugins SHARED src/node.cpp)\n")
    assert [level for level, _, _ in lint(NODE + made)] == levels
