"""C++ files that no target compiles: which of them are somebody's node, and which are left out on purpose."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

NODE = "int main() {\n  rclcpp::init(0, nullptr);\n}\n"
PART = "RCLCPP_COMPONENTS_REGISTER_NODE(my_pkg::Part)\n"
PLUGIN = "PLUGINLIB_EXPORT_CLASS(my_pkg::Part, nav2_core::Controller)\n"


def package(lines: str = "") -> dict[str, str]:
    cmake = CMAKE.replace("ament_package", f"add_executable(talker src/talker.cpp)\n{lines}\nament_package")
    return {"package.xml": manifest("", "ament_cmake"), "CMakeLists.txt": cmake, "src/talker.cpp": NODE}


def messages(files: dict[str, str], lines: str = "") -> list[str]:
    return [each.message for each in lint_files({**package(lines), **files}, ["CMK202"]).findings]


def levels(files: dict[str, str]) -> list[str]:
    return [each.severity.value for each in lint_files({**package(), **files}, ["CMK202"]).findings]


@pytest.mark.parametrize(
    ("source", "said"),
    [
        (NODE, "`ros2 run my_pkg spare` finds nothing; add an executable"),
        (PART, "the component can't be loaded"),
        (PLUGIN, "the plugin can't be loaded"),
        ("int main() {}\n", ""),
        ("void start() {\n  rclcpp::init(0, nullptr);\n}\n", ""),
        (f"// {NODE.splitlines()[0]}\n  rclcpp::init(0, nullptr);\n", ""),
        (f"#if SPARE\n{PART}#endif\n", ""),
    ],
)
def test_what_a_file_holds(source: str, said: str) -> None:
    found = messages({"src/spare.cpp": source})
    assert len(found) == bool(said)
    assert all(said in each for each in found)


@pytest.mark.parametrize(
    ("path", "count"),
    [
        ("src/spare.cc", 1),
        ("spare.cpp", 1),
        ("src/spare.hpp", 0),
        ("test/spare.cpp", 0),
        ("src/examples/spare.cpp", 0),
        ("third_party/spare.cpp", 0),
        ("src/node_template.cpp", 0),
        ("src/spare-old.cpp", 0),
        ("src/spare_new.cpp", 0),
        ("src/goldfish.cpp", 1),
    ],
)
def test_where_a_file_lies(path: str, count: int) -> None:
    assert len(messages({path: NODE})) == count
    assert messages({path: NODE, ".gitignore": f"/{path}\n"}) == []
    assert messages({path: NODE, "src/talker.cpp": f'#include "{path}"\n{NODE}'}) == []


@pytest.mark.parametrize(
    ("lines", "count"),
    [
        ("add_executable(spare src/spare.cpp)", 0),
        ("# add_executable(spare src/spare.cpp)", 0),
        ("# spare parts", 0),
        ("# spares", 1),
        ("# old-spare spare-old", 1),
        ("team_node(talker)", 0),
        ("include(${WHEREVER})", 0),
        ("add_executable(other ${SOURCES_OF_ANOTHER})", 0),
        ("set(SOURCES src/talker.cpp)\nadd_executable(other ${SOURCES})", 1),
        ("file(GLOB SOURCES src/*.cpp)\nadd_executable(other ${SOURCES})", 0),
    ],
)
def test_what_cmake_says_of_it(lines: str, count: int) -> None:
    assert len(messages({"src/spare.cpp": NODE}, lines)) == count


def test_a_file_may_be_built_alone() -> None:
    files = {"src/deep/more/spare.cpp": NODE}
    assert len(messages(files)) == 1
    assert messages({**files, "src/deep/CMakeLists.txt": ""}) == []
    assert len(messages({**files, "src/deep/CMakeLists.txt": ""}, "add_subdirectory(src/deep)")) == 1


def test_a_file_for_ros_1_is_left_alone() -> None:
    files = {"package.xml": manifest("", "catkin"), "src/spare.cpp": NODE}
    assert messages(files) == []


LAUNCH = '<launch>\n  <node pkg="{}" exec="{}"/>\n</launch>\n'
LOADED = (
    '<launch>\n  <node_container pkg="rclcpp_components" exec="component_container" name="c" namespace="">\n'
    '    <composable_node pkg="my_pkg" plugin="{}" name="p"/>\n  </node_container>\n</launch>\n'
)


@pytest.mark.parametrize(
    ("source", "path", "text", "level"),
    [
        (NODE, "README.md", "Run `ros2 run my_pkg spare` first.\n", "warning"),
        (NODE, "run.sh", "ros2  run my_pkg spare\n", "warning"),
        (NODE, "README.md", "Run `ros2 run my_pkg spare_part` first.\n", "info"),
        (NODE, "README.md", "Run `ros2 run other spare` first.\n", "info"),
        (NODE, "src/a.py", "ros2 run my_pkg spare\n", "info"),
        (NODE, "launch/a.launch.xml", LAUNCH.format("my_pkg", "spare"), "warning"),
        (NODE, "launch/a.launch.xml", LAUNCH.format("other", "spare"), "info"),
        (PART, "launch/a.launch.xml", LOADED.format("my_pkg::Part"), "warning"),
        (PART, "launch/a.launch.xml", LOADED.format("my_pkg::Other"), "info"),
        (PLUGIN, "config/a.yaml", "controller:\n  plugin: my_pkg::Part\n", "warning"),
        (PLUGIN, "config/a.yaml", "controller:\n  # plugin: my_pkg::Part\n", "info"),
        (PLUGIN, "config/a.yaml", "controller:\n  plugin: my_pkg::PartOfMore\n", "info"),
        (PLUGIN, "config/a.yaml", "controller:\n  plugin: 'my_pkg::Part'  # ours\n", "warning"),
        (PLUGIN, "plugins.xml", '<class type="my_pkg::Part"/>\n', "info"),
        (PLUGIN, "config/plugins.yaml", "plugin: my_pkg::Part\n", "warning"),
        (PLUGIN, "plugins.xml", '<class type="my_pkg::Pump"/>\n', "info"),
        (PLUGIN, "README.md", "There is my_pkg::Part.\n", "info"),
    ],
)
def test_what_nobody_names_may_be_a_leftover(source: str, path: str, text: str, level: str) -> None:
    assert levels({"src/spare.cpp": source, path: text}) == [level]


@pytest.mark.parametrize(
    ("target", "is_beside"),
    [
        ("add_executable(spare src/spare_node.cpp)", True),
        ("add_executable(spare_node src/spare_node.cpp)", False),
        ("add_library(spare SHARED src/spare_node.cpp)", False),
    ],
)
@pytest.mark.parametrize("page", ["Run `ros2 run my_pkg spare`.\n", ""])
def test_a_program_of_its_name_is_made_of_other_files(target: str, is_beside: bool, page: str) -> None:
    files = {"src/spare_node.cpp": NODE, "README.md": page, "src/spare.cpp": NODE}
    found = lint_files({**package(target), **files}, ["CMK202"]).findings
    (told,) = [each for each in found if each.location.path == "src/spare.cpp"]
    assert ("there is the target `spare`" in told.message) == is_beside
    assert ("finds nothing" in told.message) != is_beside
    assert told.severity.value == ("warning" if page and not is_beside else "info")


def test_a_launch_file_of_another_package_starts_it() -> None:
    other = {"other/package.xml": manifest("", "ament_cmake", "other")}
    other["other/CMakeLists.txt"] = CMAKE.replace("my_pkg", "other")
    other["other/launch/a.launch.xml"] = LAUNCH.format("my_pkg", "spare")
    own = {f"own/{path}": each for path, each in {**package(), "src/spare.cpp": NODE}.items()}
    assert [each.severity.value for each in lint_files({**own, **other}, ["CMK202"]).findings] == ["warning"]


TWINS = {
    "src/core.cpp": '#include "arm.hpp"\nint core() {return lift();}\n',
    "src/arm.hpp": "int lift();\n",
    "src/arm.cpp": '#include "arm.hpp"\nint lift() {return 1;}\n',
}


@pytest.mark.parametrize(
    ("lines", "files", "level"),
    [
        ("add_library(core SHARED src/core.cpp)", {}, "warning"),
        ("add_library(core STATIC src/core.cpp)", {}, "info"),
        ("add_library(core src/core.cpp)", {}, "info"),
        ("add_library(core src/core.cpp)\ntarget_link_libraries(talker core)", {}, "warning"),
        ("if(WITH_ARM)\nadd_library(core SHARED src/core.cpp)\nendif()", {}, "info"),
        ("add_library(core SHARED src/core.cpp)", {"lib/libarm.so.1": ""}, "info"),
        ("add_library(core SHARED src/core.cpp)", {"Makefile": "core:\n\tmake arms\n"}, "warning"),
        ("add_library(core SHARED src/core.cpp)", {"Makefile": "arm.o: src/arm.cpp\n"}, ""),
        ("add_library(core SHARED src/core.cpp)", {"Makefile": "%.o: src/%.cpp\n"}, ""),
        ("add_library(core SHARED src/core.cpp)", {"src/Makefile": ""}, ""),
        ("add_library(core SHARED src/core.cpp)", {"src/meson.build": ""}, ""),
    ],
)
def test_a_file_whose_header_is_compiled(lines: str, files: dict[str, str], level: str) -> None:
    found = lint_files({**package(lines), **TWINS, **files}, ["CMK202"]).findings
    assert [each.severity.value for each in found] == [level] * bool(level)


def test_a_description_offers_a_class_and_loads_none() -> None:
    description = {"plugins.xml": '<class type="my_pkg::Part"/>\n', "src/spare.cpp": PLUGIN}
    files = {**package("pluginlib_export_plugin_description_file(nav2_core plugins.xml)"), **description}
    assert [each.severity.value for each in lint_files(files, ["CMK202"]).findings] == ["info"]
    files |= {"config/parts.yaml": "loader:\n  ros__parameters:\n    part: my_pkg::Part\n"}
    assert [each.severity.value for each in lint_files(files, ["CMK202"]).findings] == ["warning"]


@pytest.mark.parametrize(("more", "level"), [("", "warning"), ("#include <ros/ros.h>\n", "info")])
def test_a_target_that_stops_at_a_source_of_ros_1_is_never_linked(more: str, level: str) -> None:
    files = {
        "src/part.hpp": "class Part\n{\npublic:\n  void start();\n};\n",
        "src/part.cpp": '#include "part.hpp"\nvoid Part::start() {}\n',
        "src/talker.cpp": f'{more}#include "part.hpp"\nint main() {{auto start = &Part::start;}}\n',
    }
    assert levels(files) == [level]
