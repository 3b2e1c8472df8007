"""What CMake has to find before it is used: packages, the commands they bring, and what they export."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.finding import Severity
from rospkg_cli.testing import lint_files

ERROR, WARNING, INFO = Severity.ERROR, Severity.WARNING, Severity.INFO
NO_AMENT = "find_package(ament_cmake REQUIRED)\n"
GTEST = "if(BUILD_TESTING)\n  {}\nendif()"
NEEDS_GTEST = "  <test_depend>ament_cmake_gtest</test_depend>\n"
LINTS = "find_package(ament_lint_auto REQUIRED)\n  ament_lint_auto_find_test_dependencies()\n  "


def package(lines: str, body: str = "", start: str = CMAKE) -> dict[str, str]:
    cmake = start.replace("ament_package()", f"{lines}\nament_package()")
    return {"package.xml": manifest(body, "ament_cmake"), "CMakeLists.txt": cmake}


def levels(files: dict[str, str], code: str) -> list[Severity]:
    return [finding.severity for finding in lint_files(files, [code]).findings]


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        ("", [ERROR]),
        ("find_package(Eigen3 REQUIRED)", [ERROR]),
        ("find_package(eigen REQUIRED)", [ERROR]),
        ("find_package(rclcpp REQUIRED)", [INFO]),
        ("find_package(ament_cmake_auto REQUIRED)", []),
        ("find_package(ament_cmake_core REQUIRED)", []),
        ("find_package(ament_cmaek REQUIRED)", []),
        ("find_package(${SOME_PACKAGE} REQUIRED)", []),
        ("include(${SOME_FILE})", []),
        ("team_package()", []),
        ("macro(ament_package)\nendmacro()", []),
        ("ament_export_dependencies(rclcpp)", [ERROR]),
    ],
)
def test_ament_package_comes_with_ament_cmake(lines: str, expected: list[Severity]) -> None:
    assert levels(package(lines, start=CMAKE.replace(NO_AMENT, "")), "CMK114") == expected


@pytest.mark.parametrize(
    ("lines", "declared", "expected"),
    [
        ("ament_add_gtest(test_a test/a.cpp)", NEEDS_GTEST, [ERROR]),
        ("ament_add_gtest(test_a test/a.cpp)", "", []),
        (f"{LINTS}ament_add_gtest(test_a test/a.cpp)", NEEDS_GTEST, []),
        (f"{LINTS}ament_add_gtest(test_a test/a.cpp)", NEEDS_GTEST.replace("test_depend", "depend"), [ERROR]),
        ("find_package(ament_cmake_ros REQUIRED)\n  ament_add_gtest(test_a test/a.cpp)", NEEDS_GTEST, []),
        ("find_package(my_own_tools REQUIRED)\n  ament_add_gtest(test_a test/a.cpp)", NEEDS_GTEST, [INFO]),
        ("find_package(std_msgs REQUIRED)\n  ament_add_gtest(test_a test/a.cpp)", NEEDS_GTEST, [ERROR]),
        ("if(SOMETHING_ELSE)\n    ament_add_gtest(test_a test/a.cpp)\n  endif()", NEEDS_GTEST, []),
    ],
)
def test_commands_for_tests_come_with_what_is_found(lines: str, declared: str, expected: list[Severity]) -> None:
    files = {**package(GTEST.format(lines), declared), "test/a.cpp": "int main() {return 0;}\n"}
    assert levels(files, "CMK114") == expected


@pytest.mark.parametrize(
    ("lines", "codes"),
    [
        ("rosidl_generate_interfaces(${PROJECT_NAME} msg/A.msg)", ["CMK114"]),
        ("rclcpp_components_register_nodes(core my_pkg::A)", ["CMK114"]),
        (
            "add_library(core SHARED a.cpp)\ntarget_link_libraries(core rclcpp_components::component)\n"
            "rclcpp_components_register_nodes(core my_pkg::A)",
            ["DEP107"],
        ),
    ],
)
def test_a_package_that_is_linked_is_told_once(lines: str, codes: list[str]) -> None:
    files = package(lines, "  <depend>rclcpp_components</depend>\n")
    assert [finding.code for finding in lint_files(files, ["CMK114", "DEP107"]).findings] == codes


@pytest.mark.parametrize(
    ("lines", "declared", "near"),
    [
        ("find_package(rclpcp REQUIRED)", "rclcpp", "rclcpp"),
        ("find_package(rclpcp)", "rclcpp", ""),
        ("find_package(rclpcp QUIET REQUIRED)", "rclcpp", ""),
        ("find_package(Rclpcp REQUIRED)", "rclcpp", ""),
        ("find_package(rclpcp REQUIRED)", "std_msgs", "rclcpp"),
        ("find_package(rclpcp REQUIRED)\nfind_package(rclcpp REQUIRED)", "rclcpp", "rclcpp"),
        ("if(SOMETHING_ELSE)\n  find_package(rclpcp REQUIRED)\nendif()", "rclcpp", ""),
        ("find_package(tf2_eigne REQUIRED)", "tf2_eigen", "tf2_eigen"),
        ("find_package(tinyxml REQUIRED)", "tinyxml2", ""),
        ("find_package(rclpcp REQUIRED)\nament_export_dependencies(rclpcp)", "rclcpp", "rclcpp"),
        ("ament_export_dependencies(rclpcp)", "rclcpp", "rclcpp"),
        ("ament_export_dependencies(rclcpp Eigen3)", "rclcpp", ""),
        ("find_package(OpenGL REQUIRED)\nament_target_dependencies(a rclcpp OpenCV)", "rclcpp", ""),
        ("find_package(Eigen3 REQUIRED)\nament_target_dependencies(a rclcpp EIGEN3)", "rclcpp", ""),
        ("find_package(rclcpp REQUIRED)\nament_target_dependencies(a RCLCPP)", "std_msgs", "rclcpp"),
    ],
)
def test_packages_that_are_nearly_declared(lines: str, declared: str, near: str) -> None:
    found = lint_files(package(lines, f"  <depend>{declared}</depend>\n"), ["CMK117"]).findings
    assert [each.message.partition("did you mean `")[2].partition("`")[0] for each in found] == ([near] if near else [])


@pytest.mark.parametrize("module", ["cmake/Findrclpcp.cmake", "cmake/rclpcpConfig.cmake", "rclpcp-config.cmake"])
def test_a_module_of_the_package_finds_under_any_name(module: str) -> None:
    files = package("find_package(rclpcp REQUIRED)", "  <depend>rclcpp</depend>\n")
    assert levels(files, "CMK117") == [ERROR]
    assert levels({**files, module: ""}, "CMK117") == []


@pytest.mark.parametrize("command", ["ament_target_dependencies(talker core)", "ament_export_dependencies(core)"])
def test_a_target_is_no_package(command: str) -> None:
    lines = f"add_library(core src/a.cpp)\nadd_library(talker src/a.cpp)\n{command}"
    (finding,) = lint_files(package(lines), ["CMK117"]).findings
    assert "is a target of this package" in finding.message
    assert finding.fix is None
    assert levels(package(f"find_package(core REQUIRED)\n{lines}"), "CMK117") == []


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        ("macro(INSTALL)\nendmacro()", [WARNING]),
        ("macro(install)\n  if(TRUE)\n    install(FILES a DESTINATION b)\n  endif()\nendmacro()", [ERROR]),
        ("macro(install)\n  if(TRUE)\n  else()\n    _install(${ARGV})\n  endif()\nendmacro()", []),
        ("function(ament_package)\nendfunction()", [WARNING]),
        ("function(ament_package)\nendfunction()\nfind_package(rclcpp REQUIRED)", [WARNING]),
        ("function(ament_package)\nendfunction()\nfind_package(ament_cmake REQUIRED)", [INFO]),
        ("function(install)\nendfunction()\nfind_package(ament_cmake REQUIRED)", [WARNING]),
        ("function(tell)\nendfunction()", []),
        ("function()\nendfunction()", []),
        ("if(NOT COMMAND ament_package)\n  function(ament_package)\n  endfunction()\nendif()", []),
    ],
)
def test_functions_that_replace_a_command(lines: str, expected: list[Severity]) -> None:
    assert levels(package(lines), "CMK116") == expected


@pytest.mark.parametrize(
    ("include", "expected"),
    [
        ("include(cmake/tell.cmake)", [WARNING]),
        ("if(${ANYTHING})\n  include(cmake/tell.cmake)\nendif()", [INFO]),
        ("if(${ANYTHING})\n  include(cmake/tell.cmake)\nendif()\ninclude(cmake/tell.cmake)", [WARNING]),
    ],
)
def test_a_file_that_is_included_under_a_condition_may_replace_nothing(include: str, expected: list[Severity]) -> None:
    files = package(include) | {"cmake/tell.cmake": "function(find_package name)\nendfunction()\n"}
    assert levels(files, "CMK116") == expected


CORE = "add_library(core SHARED a.cpp)\nadd_executable(talker a.cpp)\nadd_library(plain INTERFACE)\n"


@pytest.mark.parametrize(
    ("lines", "said"),
    [
        ("ament_export_libraries(core)", ""),
        ("ament_export_libraries(croe)", "did you mean `core`"),
        ("ament_export_libraries(pthread yaml-cpp /usr/lib/croe)", ""),
        ("ament_export_libraries(${PROJECT_NAME})", "nothing makes the library `my_pkg` (`${PROJECT_NAME}`): "),
        ("ament_export_libraries(talker)", "a program"),
        ("ament_export_libraries(talkr)", ""),
        ("ament_export_libraries(plain)", "without a file"),
        ("add_library(parts OBJECT a.cpp)\nament_export_libraries(parts)", "without a file"),
        ("add_library(theirs INTERFACE IMPORTED)\nament_export_libraries(theirs)", ""),
        ("if(SOMETHING_ELSE)\n  ament_export_libraries(croe)\nendif()", ""),
        ("include(${WHEREVER})\nament_export_libraries(croe)", ""),
        ("team_macro(croe)\nament_export_libraries(croe)", ""),
        ("set_target_properties(core PROPERTIES OUTPUT_NAME croe)\nament_export_libraries(croe)", ""),
        ("foreach(each a b)\n  ament_export_libraries(croe)\nendforeach()", "did you mean `core`"),
    ],
)
def test_libraries_that_are_exported(lines: str, said: str) -> None:
    found = lint_files(package(CORE + lines), ["CMK118"]).findings
    assert len(found) == bool(said)
    assert all(said in each.message for each in found)


def test_a_library_that_comes_as_a_file_is_exported() -> None:
    files = package(f"{CORE}ament_export_libraries(my_pkg)")
    assert levels(files, "CMK118") == [INFO]  # nobody here links it
    assert levels({**files, "lib/libmy_pkg.so": ""}, "CMK118") == []


PROGRAM = "add_executable(a a.cpp)\ninstall(TARGETS a DESTINATION lib/${PROJECT_NAME})\n"
USER = "find_package(base REQUIRED)\nadd_executable(user user.cpp)"


def test_a_library_that_nobody_links() -> None:
    base = package(f"{PROGRAM}ament_export_libraries(${{PROJECT_NAME}})")
    user = package(USER, "  <depend>base</depend>\n")
    assert levels(workspace(base=base), "CMK118") == [INFO]
    assert levels(workspace(base=base, user=user), "CMK118") == [INFO]
    header = {"include/base/base.hpp": "int base();\n"}
    including = {**user, "user.cpp": "#include <base/base.hpp>\n"}
    assert levels(workspace(base={**base, **header}, user=including), "CMK118") == [INFO]  # CMake only warns of it
    slip = {**package(f"{CORE}ament_export_libraries(croe)"), **header}
    assert levels(workspace(base=slip, user=including), "CMK118") == [WARNING]
    unsought = {**including, "CMakeLists.txt": including["CMakeLists.txt"].replace("find_package(base REQUIRED)\n", "")}
    assert levels(workspace(base=slip, user=unsought), "CMK118") == [INFO]
    whole = package(f"{CORE}ament_export_libraries(croe core)")
    assert levels(workspace(base={**whole, **header}, user=including), "CMK118") == [INFO]
    python = {"package.xml": user["package.xml"].replace("ament_cmake", "ament_python")}
    assert levels(workspace(base=base, user=python), "CMK118") == [INFO]


def workspace(**packages: dict[str, str]) -> dict[str, str]:
    return {
        f"{name}/{path}": text.replace("my_pkg", name)
        for name, files in packages.items()
        for path, text in files.items()
    }


@pytest.mark.parametrize(
    ("line", "expected"), [("plain", [ERROR]), ("talker", [ERROR]), ("croe", [INFO]), ("core", [])]
)
def test_an_export_that_is_needed(line: str, expected: list[Severity]) -> None:
    user = package(USER, "  <depend>base</depend>\n")
    base = package(f"{CORE}ament_export_libraries({line})")
    assert levels(workspace(base=base, user=user), "CMK118") == expected
    user = {**user, "package.xml": user["package.xml"].replace("depend>base</", "exec_depend>base</exec_")}
    assert levels(workspace(base=base, user=user), "CMK118") == [INFO] * len(expected)


EXPORT = "install(TARGETS core EXPORT export_core DESTINATION lib)\n"
EXPORTED = f"{EXPORT}ament_export_targets(export_core)\n"


@pytest.mark.parametrize(
    ("lines", "link", "said"),
    [
        (EXPORTED, "base::core", ""),
        (EXPORTED, "base::other", "`base` exports `base::core`, not `base::other`"),
        (EXPORT, "base::core", "`base` exports no target"),
        (f"{EXPORTED}install(TARGETS talker EXPORT export_core)", "base::other", "`base::core` and others, not"),
        (EXPORTED.replace("(export", "(${WHICH} export"), "base::other", ""),
        (f"if(SOMETHING_ELSE)\n{EXPORTED}endif()\n", "base::other", ""),
        (f"{EXPORTED}team_export(core)", "base::other", ""),
        (f"{EXPORTED}include(${{WHEREVER}})", "base::other", ""),
        (f"{EXPORTED}install(EXPORT export_core DESTINATION lib)", "base::other", ""),
        (f"{EXPORTED}install(FILES a.cmake DESTINATION share)", "base::other", ""),
        (f"{EXPORTED}export(TARGETS core FILE a.cmake)", "base::other", ""),
        (f"{EXPORTED}install(CODE a)", "base::other", ""),
        (EXPORTED.replace("TARGETS core", "TARGETS core ${base_MORE}"), "base::other", ""),
        (f'{EXPORTED}rosidl_generate_interfaces(base "msg/A.msg")', "base::other", ""),
        (f"{EXPORTED}ament_package(CONFIG_EXTRAS a.cmake)", "base::other", ""),
        (f"{EXPORTED}add_subdirectory(src)", "base::other", ""),
    ],
)
def test_targets_of_the_workspace(lines: str, link: str, said: str) -> None:
    user = f"find_package(base REQUIRED)\nadd_executable(node a.cpp)\ntarget_link_libraries(node {link})"
    files = workspace(base=package(CORE + lines), user=package(user, "  <depend>base</depend>\n"))
    found = lint_files(files, ["CMK110"]).findings
    found = tuple(each for each in found if each.package == "user")
    assert len(found) == bool(said)
    assert all(said in each.message for each in found)


def test_a_target_of_another_package_of_the_workspace_may_have_this_ones_name() -> None:
    user = "find_package(base REQUIRED)\nadd_executable(node a.cpp)\ntarget_link_libraries(node base::more)"
    more = (CORE + EXPORTED).replace("core", "more").replace("export_more)", "export_more NAMESPACE base::)")
    files = workspace(base=package(CORE + EXPORTED), user=package(user, "  <depend>base</depend>\n"))
    assert levels(files, "CMK110") == [ERROR]
    assert levels({**files, **workspace(more=package(more))}, "CMK110") == []


PART = """\
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_components/register_node_macro.hpp>
RCLCPP_COMPONENTS_REGISTER_NODE(my_pkg::Part)
"""
LINK = "add_executable(main src/main.cpp)\ntarget_link_libraries(main part)\n"


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        ("add_library(part SHARED src/part.cpp)\ninstall(TARGETS part DESTINATION lib)", [WARNING]),
        ("add_library(part src/part.cpp)\ninstall(TARGETS part DESTINATION lib)", [WARNING]),
        ("add_library(part STATIC src/part.cpp)\ninstall(TARGETS part DESTINATION lib)", []),
        ("add_library(part OBJECT src/part.cpp)\ninstall(TARGETS part DESTINATION lib)", []),
        ("add_library(part SHARED src/part.cpp)", []),
        (f"add_library(part SHARED src/part.cpp)\ninstall(TARGETS part DESTINATION lib)\n{LINK}", [INFO]),
        ("add_executable(part src/part.cpp)\ninstall(TARGETS part DESTINATION lib/${PROJECT_NAME})", []),
        (
            "if(SOMETHING_ELSE)\n  add_library(part SHARED src/part.cpp)\nendif()\n"
            "install(TARGETS part DESTINATION lib)",
            [],
        ),
        (
            "if(BUILD_TESTING)\n  add_library(part SHARED src/part.cpp)\n  install(TARGETS part DESTINATION lib)\n"
            "endif()",
            [],
        ),
        (
            "add_library(part SHARED src/part.cpp)\ninstall(TARGETS part DESTINATION lib)\n"
            'rclcpp_components_register_nodes(part "my_pkg::Part")',
            [],
        ),
    ],
)
def test_a_component_of_a_library_that_is_only_loaded(lines: str, expected: list[Severity]) -> None:
    files = {**package(lines), "src/part.cpp": PART, "src/main.cpp": "int main() {return 0;}\n"}
    assert levels(files, "CMK108") == expected


@pytest.mark.parametrize("name", ["rclcpp", "std_msgs", "launch_testing_ament_cmake", "ament_cmake_ros", "my_tools"])
def test_a_command_for_tests_is_told_by_one_rule(name: str) -> None:
    """Also where a dependency installs its package, which is not to find it."""
    files = package(GTEST.format("ament_add_gtest(test_a test/a.cpp)"), f"  <depend>{name}</depend>\n")
    assert len(lint_files({**files, "test/a.cpp": "int main() {return 0;}\n"}, ["CMK114", "DEP104"]).findings) == 1


@pytest.mark.parametrize("command", ["nanobind_add_module", "pybind11_add_module", "python3_add_library"])
def test_options_of_python_modules_are_no_sources(command: str) -> None:
    lines = f"{command}(part STABLE_ABI NB_STATIC NB_DOMAIN one NO_EXTRAS WITH_SOABI MODULE src/part.cpp)"
    assert levels({**package(lines), "src/part.cpp": PART}, "CMK102") == []
    assert levels(package(lines), "CMK102") != []
