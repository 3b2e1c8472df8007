"""Components that code of the package makes itself: nobody misses them by their name."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

LIBRARY = "add_library(parts SHARED src/part.cpp src/other.cpp)\ninstall(TARGETS parts DESTINATION lib)\n"
PROGRAM = "add_executable(prog src/part.cpp src/other.cpp)\ninstall(TARGETS prog DESTINATION lib/${PROJECT_NAME})\n"
CLASS = "namespace my_pkg {\nclass Part : public rclcpp::Node {};\n}\n"
MACRO = "RCLCPP_COMPONENTS_REGISTER_NODE(my_pkg::Part)\n"
MAKES = "auto part = std::make_shared<my_pkg::Part>();\n"
ONE = 'rclcpp_components_register_node({} PLUGIN "my_pkg::Part" EXECUTABLE part_node)\n'
SEVERAL = 'rclcpp_components_register_nodes({} "my_pkg::Part")\n'


def told(lines: str = LIBRARY, other: str = MAKES, part: str = CLASS + MACRO, **more: str) -> list[str]:
    files = {
        "CMakeLists.txt": CMAKE.replace(
            "ament_package", f"find_package(rclcpp_components REQUIRED)\n{lines}ament_package"
        ),
        "package.xml": manifest("  <depend>rclcpp_components</depend>\n", "ament_cmake"),
        "src/part.cpp": part,
        "src/other.cpp": other,
        **{path.replace("__", "/").replace("_DOT_", "."): text for path, text in more.items()},
    }
    found = lint_files(files, ["CMK108"]).findings
    assert all(("nothing here loads it" in each.message) is ("src/other.cpp` " in each.message) for each in found)
    return [each.severity.value for each in found]


@pytest.mark.parametrize(
    "other",
    [
        MAKES,
        "void f() {auto a = std::make_unique<Part>(1);}\n",
        "void f() {a = new ::my_pkg::Part(1);}\n",
        "struct A {\n  my_pkg::Part part_;\n};\n",
        "void f() {map[name] = my_pkg::Part::make_shared();}\n",
        "class More : public my_pkg::Part {};\n",
    ],
)
def test_what_code_makes_itself_is_an_info(other: str) -> None:
    assert told(other=other) == ["info"]


@pytest.mark.parametrize(
    "other",
    [
        "int none() {return 0;}\n",
        "// std::make_shared<my_pkg::Part>()\n",
        "auto part = std::make_shared<your_pkg::Part>();\n",
        "auto part = std::make_shared<my_pkg::Parts>();\n",
        "std::shared_ptr<my_pkg::Part> part;\n",
        f"int main() {{{MAKES}}}\n",
    ],
)
def test_a_forgotten_line_stays_a_warning(other: str) -> None:
    assert told(other=other) == ["warning"]


@pytest.mark.parametrize(
    "more, level",
    [
        ({"launch__a_DOT_launch_DOT_py": "nodes = [{'plugin': 'my_pkg::Part'}]\n"}, "warning"),
        ({"config__a_DOT_yaml": "part:\n  plugin: my_pkg::Part\n"}, "warning"),
        ({"README_DOT_md": "ros2 component load /C my_pkg my_pkg::Part\n"}, "warning"),
        ({"README_DOT_md": "`my_pkg::Part` is a class.\n"}, "info"),
        ({"src__loader_DOT_cpp": 'auto name = "my_pkg::Part";\n'}, "warning"),
    ],
)
def test_what_something_names_is_loaded(more: dict[str, str], level: str) -> None:
    assert told(**more) == [level]


@pytest.mark.parametrize(
    "lines, part, other, level",
    [
        (LIBRARY + ONE.format("parts"), CLASS, "int none() {return 0;}\n", "error"),
        (LIBRARY + ONE.format("parts"), CLASS, MAKES, "warning"),
        (LIBRARY + SEVERAL.format("parts"), CLASS, MAKES, "info"),
        (LIBRARY + ONE.format("parts"), CLASS + MACRO.replace("Part", "Prat"), MAKES, "error"),
        (PROGRAM + SEVERAL.format("prog"), CLASS + MACRO, f"int main() {{{MAKES}}}\n", "info"),
        (PROGRAM + ONE.format("prog"), CLASS + MACRO, f"int main() {{{MAKES}}}\n", "warning"),
        (PROGRAM + ONE.format("prog"), CLASS + MACRO, "int main() {}\n", "error"),
        (
            PROGRAM + ONE.format("prog").replace("part_node", "prog"),
            CLASS + MACRO,
            f"int main() {{{MAKES}}}\n",
            "error",
        ),
    ],
)
def test_what_cmake_registers(lines: str, part: str, other: str, level: str) -> None:
    assert told(lines, other, part) == [level]


def test_a_program_that_a_page_starts() -> None:
    page = {"README_DOT_md": "ros2 run my_pkg part_node\n"}
    assert told(LIBRARY + ONE.format("parts"), MAKES, CLASS, **page) == ["error"]


OTHER_SPACE = SEVERAL.replace("my_pkg::Part", "your_pkg::Part").format("parts")


def said(part: str, other: str, lines: str = OTHER_SPACE, **more: str) -> list[tuple[str, str]]:
    """Return the level, and the name of the class that the macro is to be given."""
    files = {
        "CMakeLists.txt": CMAKE.replace(
            "ament_package", f"find_package(rclcpp_components REQUIRED)\n{LIBRARY}{lines}ament_package"
        ),
        "package.xml": manifest("  <depend>rclcpp_components</depend>\n", "ament_cmake"),
        "src/part.cpp": part,
        "src/other.cpp": other,
        **{path.replace("__", "/").replace("_DOT_", "."): text for path, text in more.items()},
    }
    found = lint_files(files, ["CMK108"]).findings
    return [(each.severity.value, each.message.partition("REGISTER_NODE(")[2].partition(")")[0]) for each in found]


@pytest.mark.parametrize(
    ("part", "meant"),
    [
        (CLASS, "my_pkg::Part"),
        ("namespace my_pkg::inner {\nclass Part final : public A<B> {\n};\n}\n", "my_pkg::inner::Part"),
        ("namespace a {\nint f() {return 0;}\nnamespace b {\nstruct A_PUBLIC Part {};\n}\n}\n", "a::b::Part"),
        ("class Part {};\n", "Part"),
        ("// class Part {};\nclass Part;\n", "your_pkg::Part"),
        ("class Outer {\n  class Part {};\n};\n", "your_pkg::Part"),
        ("namespace {\nclass Part {};\n}\n", "your_pkg::Part"),
        (CLASS + CLASS.replace("my_pkg", "more"), "your_pkg::Part"),
        (CLASS + CLASS.replace("my_pkg", "your_pkg"), "your_pkg::Part"),
    ],
)
def test_the_macro_is_given_a_class_that_there_is(part: str, meant: str) -> None:
    assert said(part, "int none() {return 0;}\n") == [("error", meant)]


@pytest.mark.parametrize(
    ("lines", "more", "level"),
    [
        (OTHER_SPACE, {}, "info"),
        (OTHER_SPACE, {"config__a_DOT_yaml": "part:\n  plugin: your_pkg::Part\n"}, "error"),
        (OTHER_SPACE, {"README_DOT_md": "ros2 component load /C my_pkg my_pkg::Part\n"}, "error"),
        (ONE.replace("my_pkg::Part", "your_pkg::Part").format("parts"), {}, "warning"),
    ],
)
def test_what_code_makes_by_another_name_than_cmake_has(lines: str, more: dict[str, str], level: str) -> None:
    assert said(CLASS, MAKES, lines, **more) == [(level, "my_pkg::Part")]
