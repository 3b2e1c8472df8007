"""What a build needs and package.xml or CMake gets by half: keys without headers, tags, blocks of tests, own names."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

NODE = "add_executable(node src/node.cpp)\ninstall(TARGETS node DESTINATION lib/${PROJECT_NAME})\n"
FOR_TESTS = "if(BUILD_TESTING)\n  find_package({0} REQUIRED)\nendif()\n"


def told(code: str, lines: str, depends: str, source: str = "") -> list[tuple[str, str]]:
    files = {
        "CMakeLists.txt": CMAKE.replace("ament_package()", f"{lines}ament_package()"),
        "package.xml": manifest(depends, "ament_cmake"),
        "src/node.cpp": f"{source}int main() {{return 0;}}\n",
    }
    found = lint_files(files, [code]).findings
    return [(each.severity.value, each.message) for each in found]


@pytest.mark.parametrize(
    "key, levels",
    [("libboost-thread", ["warning"]), ("libboost-thread-dev", []), ("libboost-dev", []), ("boost", [])],
)
def test_a_key_without_headers_serves_no_build(key: str, levels: list[str]) -> None:
    found = told("DEP104", "find_package(Boost REQUIRED COMPONENTS thread)\n", f"  <depend>{key}</depend>\n")
    assert [level for level, _ in found] == levels
    assert all(f"declares `{key}` alone" in message for _, message in found)


def test_libraries_of_the_project_itself() -> None:
    """A plain name, or one with a target behind it, that CMake requires and package.xml does not have."""
    found = f"find_package(ugv_sdk REQUIRED)\n{NODE}"
    for link in ("ugv_sdk", "ugv_sdk::core"):
        levels = [level for level, _ in told("DEP104", f"{found}target_link_libraries(node {link})\n", "")]
        assert levels == ["info"]
    assert told("DEP104", found, "") == []
    assert told("DEP104", f"{found}target_link_libraries(node ugv_sdk)\n", "  <depend>ugv_sdk</depend>\n") == []
    assert told("DEP104", f"add_subdirectory(ugv_sdk)\n{found}target_link_libraries(node ugv_sdk)\n", "") == []


@pytest.mark.parametrize("tag, levels", [("exec_depend", ["info"]), ("depend", []), ("build_depend", [])])
def test_a_metapackage_for_running_alone(tag: str, levels: list[str]) -> None:
    found = told("DEP201", "find_package(ros_gz_sim REQUIRED)\n", f"  <{tag}>ros_gz</{tag}>\n")
    assert [level for level, _ in found] == levels
    assert all("`ros_gz_sim`" in message for _, message in found)


def links(*words: str) -> str:
    return f"{NODE}target_link_libraries(node {' '.join(words)})\n"


@pytest.mark.parametrize("name, target", [("Eigen3", "Eigen3::Eigen"), ("std_msgs", "${std_msgs_TARGETS}")])
def test_what_is_found_for_tests_alone(name: str, target: str) -> None:
    depends = "  <depend>eigen</depend>\n  <depend>std_msgs</depend>\n"
    for_tests = FOR_TESTS.format(name)
    assert [level for level, _ in told("DEP107", links(target) + for_tests, depends)] == ["warning"]
    stranger = "find_package(nobodys REQUIRED)\n"
    assert [level for level, _ in told("DEP107", stranger + links(target) + for_tests, depends)] == ["info"]
    quiet = (
        f"find_package({name} REQUIRED)\n{links(target)}{for_tests}",
        f"if(BUILD_TESTING)\n  find_package({name} REQUIRED)\n  {links(target)}endif()\n",
        f"{links('other')}{for_tests}",
    )
    assert [told("DEP107", lines, depends) for lines in quiet] == [[], [], []]


def test_variables_in_other_letters_are_those_of_a_library() -> None:
    lines = f"find_package(yaml-cpp REQUIRED)\n{NODE}target_link_libraries(node ${{YAML_CPP_LIBRARIES}})\n"
    assert [level for level, _ in told("DEP201", lines, "  <build_depend>yaml-cpp</build_depend>\n")] == ["info"]
    assert told("DEP201", lines, "  <depend>yaml-cpp</depend>\n") == []
    assert told("DEP201", lines.replace("YAML_CPP", "OTHER"), "  <build_depend>yaml-cpp</build_depend>\n") == []


def test_what_is_declared_included_and_found_by_another() -> None:
    depends = "  <depend>rosbag2_cpp</depend>\n  <depend>rosbag2_storage</depend>\n  <depend>rclcpp</depend>\n"
    source = "#include <rosbag2_storage/serialized_bag_message.hpp>\n"
    lines = f"find_package(rosbag2_cpp REQUIRED)\n{NODE}ament_target_dependencies(node rosbag2_cpp)\n"
    (level, message), *others = told("DEP107", lines, depends, source)
    assert (level, others) == ("info", [])
    assert message.startswith("`rosbag2_storage` is declared and included")
    assert told("DEP107", f"find_package(rosbag2_storage REQUIRED)\n{lines}", depends, source) == []
    assert told("DEP107", lines, "  <depend>rosbag2_cpp</depend>\n", source) == []
    assert (
        told("DEP107", f"find_package(ament_cmake_auto)\nament_auto_find_build_dependencies()\n{lines}", depends) == []
    )
    assert told("DEP107", lines, depends, "#include <rcl_interfaces/msg/parameter.hpp>\n") == []


LIBRARY = """\
{0}add_library(core SHARED src/node.cpp)
target_link_libraries(core {1} yaml-cpp::yaml-cpp)
install(DIRECTORY include/ DESTINATION include/${{PROJECT_NAME}})
install(TARGETS core EXPORT export_core DESTINATION lib)
ament_export_targets(export_core HAS_LIBRARY_TARGET)
{2}"""
YAML = "find_package(yaml-cpp REQUIRED)\n"


@pytest.mark.parametrize(
    "found, scope, exports, levels",
    [
        (YAML, "PUBLIC", "", ["info"]),
        (YAML, "", "ament_export_dependencies(rclcpp)\n", ["info"]),
        (YAML, "PRIVATE", "", []),
        (YAML, "PUBLIC", "ament_export_dependencies(yaml-cpp)\n", []),
        (YAML, "PUBLIC", "ament_export_dependencies(yaml_cpp_vendor)\n", []),
        (YAML, "PUBLIC", "ament_export_dependencies(${{MORE}})\n", []),
        ("", "PUBLIC", "", []),
    ],
)
def test_a_target_of_a_library_that_is_handed_on(found: str, scope: str, exports: str, levels: list[str]) -> None:
    lines = LIBRARY.format(found, scope, exports).replace("{{", "{").replace("}}", "}")
    files = {
        "CMakeLists.txt": CMAKE.replace("ament_package()", f"{lines}ament_package()"),
        "package.xml": manifest("  <depend>yaml-cpp</depend>\n", "ament_cmake"),
        "src/node.cpp": "#include <my_pkg/core.hpp>\n",
        "include/my_pkg/core.hpp": "#pragma once\n",
    }
    assert [each.severity.value for each in lint_files(files, ["CMK113"]).findings] == levels


def test_interfaces_that_only_the_generators_find() -> None:
    lines = (
        "find_package(rosidl_default_generators REQUIRED)\n{}"
        'rosidl_generate_interfaces(${{PROJECT_NAME}} "msg/A.msg" DEPENDENCIES builtin_interfaces)\n'
    )
    depends = "  <buildtool_depend>rosidl_default_generators</buildtool_depend>\n"
    (level, message), *others = told("DEP107", lines.format(""), depends)
    assert (level, others) == ("info", [])
    assert message.startswith("CMake never looks for `builtin_interfaces`")
    assert told("DEP107", lines.format("find_package(builtin_interfaces REQUIRED)\n"), depends) == []
    assert told("DEP107", lines.format(""), f"{depends}  <depend>builtin_interfaces</depend>\n") == []


def test_packages_of_the_workspace_bring_targets() -> None:
    core = (
        "add_library(core SHARED src/core.cpp)\ninstall(TARGETS core EXPORT core_targets DESTINATION lib)\n"
        "ament_export_targets(core_targets)\n"
    )
    user = (
        "find_package(core REQUIRED)\nfind_package(pybind11 REQUIRED)\npybind11_add_module(fast src/fast.cpp)\n"
        "ament_target_dependencies(fast core)\n"
    )
    files = {}
    for name, lines in (("core", core), ("user", user)):
        cmake = CMAKE.replace("my_pkg", name).replace("ament_package()", f"{lines}ament_package()")
        files |= {f"{name}/CMakeLists.txt": cmake, f"{name}/package.xml": manifest("", "ament_cmake", name)}
    assert [each.severity.value for each in lint_files(files, ["CMK122"]).findings] == ["error"]
    files["core/CMakeLists.txt"] = CMAKE.replace("my_pkg", "core")
    assert not lint_files(files, ["CMK122"]).findings
