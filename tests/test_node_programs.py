"""Which programs that CMake builds are nodes: what their own files and the libraries of the package say."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, existing_files, manifest
from rospkg_cli.testing import lint_files

ON = {**existing_files(BACKDROPS["ament_cmake"]), "package.xml": manifest("  <depend>rclcpp</depend>\n", "ament_cmake")}
MAIN = "int main(int argc, char ** argv) {return core(argc, argv);}\n"
BARE = "// no rclcpp::init here\nint main() {return 0;}\n"
NODE = "#include <rclcpp/rclcpp.hpp>\nint main() {return 0;}\n"
NAMED = "int main(int c, char ** v) {rclcpp::init(c, v);}\n"
DERIVED = "struct A : rclcpp::Node {};\n" + NODE
INIT = "int core(int c, char ** v) {rclcpp::init(c, v);}\n"
OWN = "add_library(core STATIC src/core.cpp)\ntarget_link_libraries(a core)\n"
BASE = "add_library(base STATIC src/base.cpp)\ntarget_link_libraries(core base)\n"


def levels(code: str, lines: str, **files: str) -> list[str]:
    lines = f"find_package(rclcpp REQUIRED)\n{lines}"
    sources = {f"src/{name}.cpp": text for name, text in files.items() if name != "readme"}
    pages = {"README.md": files["readme"]} if "readme" in files else {}
    built = {"CMakeLists.txt": CMAKE.replace("ament_package", lines + "ament_package")}
    return [each.severity.value for each in lint_files({**ON, **sources, **pages, **built}, [code]).findings]


@pytest.mark.parametrize(
    ("lines", "files", "level"),
    [
        ("", {"a": BARE}, "info"),
        ("", {"a": NODE}, "warning"),
        ("", {"a": NAMED}, "warning"),
        ("", {}, "warning"),
        ("", {"a": BARE, "readme": "Call `ros2 run my_pkg a` first.\n"}, "warning"),
        ("", {"a": BARE, "readme": "Call `ros2 run my_pkg b` first.\n"}, "info"),
        (OWN, {"a": MAIN, "core": INIT}, "warning"),
        (OWN, {"a": MAIN, "core": NODE}, "info"),
        (OWN, {"a": MAIN}, "warning"),
        (OWN + BASE, {"a": MAIN, "core": BARE, "base": INIT}, "warning"),
        (OWN + BASE, {"a": MAIN, "core": BARE, "base": BARE}, "info"),
        ("target_sources(a PRIVATE src/b.cpp)\n", {"a": BARE, "b": NODE}, "warning"),
        ("target_link_libraries(a a m)\n", {"a": BARE}, "info"),
    ],
)
def test_a_program_that_leaves_ros_alone_need_not_be_installed(lines: str, files: dict[str, str], level: str) -> None:
    assert levels("CMK103", f"add_executable(a src/a.cpp)\n{lines}", **files) == [level]


@pytest.mark.parametrize(
    ("place", "source", "level"),
    [
        ("bin", BARE, "info"),
        ("bin", NODE, "info"),
        ("bin", NAMED, "warning"),
        ("bin", DERIVED, "warning"),
        ("lib", BARE, "info"),
        ("lib", NODE, "error"),
    ],
)
def test_a_program_that_leaves_ros_alone_may_lie_anywhere(place: str, source: str, level: str) -> None:
    lines = "add_executable(a src/a.cpp)\ntarget_link_libraries(a rclcpp::rclcpp)\n"
    assert levels("CMK104", f"{lines}install(TARGETS a DESTINATION {place})\n", a=source) == [level]


@pytest.mark.parametrize(("other", "level"), [("lib/${PROJECT_NAME}", "info"), ("bin", "warning")])
def test_a_node_in_bin_beside_others_that_launch_files_find(other: str, level: str) -> None:
    lines = "add_executable(a src/a.cpp)\nadd_executable(b src/b.cpp)\ntarget_link_libraries(a rclcpp::rclcpp)\n"
    lines += f"install(TARGETS a DESTINATION bin)\ninstall(TARGETS b RUNTIME DESTINATION {other})\n"
    assert levels("CMK104", lines, a=NAMED, b=NAMED)[0] == level


@pytest.mark.parametrize(
    ("comment", "level"),
    [
        ("#install(TARGETS\n#  a\n#  DESTINATION lib/${PROJECT_NAME}\n#)\n", "info"),
        ("# install(TARGETS b a DESTINATION lib/${PROJECT_NAME})\n", "info"),
        ("#[[\ninstall(TARGETS a\n  DESTINATION lib/${PROJECT_NAME})\n]]\n", "info"),
        ("# install(TARGETS b DESTINATION lib/a)\n", "warning"),
        ("# install(TARGETS b DESTINATION a)\n", "warning"),
        ("# install a\n", "warning"),
    ],
)
def test_a_program_whose_install_is_a_comment_is_left_out_on_purpose(comment: str, level: str) -> None:
    assert levels("CMK103", f"add_executable(a src/a.cpp)\n{comment}", a=NAMED) == [level]
    readme = "Call `ros2 run my_pkg a` first.\n"
    assert levels("CMK103", f"add_executable(a src/a.cpp)\n{comment}", a=NAMED, readme=readme) == ["warning"]
    named = f"add_executable(${{PROJECT_NAME}} src/a.cpp)\n{comment.replace(' a', ' ${PROJECT_NAME}')}"
    assert levels("CMK103", named, a=NAMED) == [level]
