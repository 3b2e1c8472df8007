"""CMake rules on what real packages do: where they keep quiet, and how they say it."""

from __future__ import annotations

import pytest

from rospkg_cli.engine.discovery.discover import packages_in
from rospkg_cli.engine.fixing.fix import fix_all
from rospkg_cli.engine.run.scope import Scope
from rospkg_cli.engine.run.session import Session
from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.finding import Safety, Severity
from rospkg_cli.ros.distros import Targets
from rospkg_cli.rules.cmake import cmk113_missing_export_dependency as cmk113
from rospkg_cli.testing import lint_files
from rospkg_cli.tree import MemoryTree, TreeEntry

RVIZ = {"rviz/robot.rviz": "Panels: []\n"}
OPENS = """\
from ament_index_python.packages import get_package_share_directory


def generate_launch_description():
    mine = get_package_share_directory('my_pkg')
    theirs = get_package_share_directory('nav2_bringup')
    return LaunchDescription([Node(arguments=['-d', os.path.join({}, 'rviz', 'robot.rviz')])])
"""
ASKED = """\
find_package(rclcpp REQUIRED)
add_executable(talker src/talker.cpp)
if({})
  ament_target_dependencies(talker rclcpp)
else()
  target_link_libraries(talker PUBLIC rclcpp::rclcpp)
endif()
install(TARGETS talker DESTINATION lib/${{PROJECT_NAME}})
"""


def package(lines: str, body: str = "", name: str = "my_pkg") -> dict[str, str]:
    """Return a package whose CMakeLists.txt has lines before ament_package()."""
    cmake = CMAKE.replace("my_pkg", name).replace("ament_package()", f"{lines}\nament_package()")
    return {"package.xml": manifest(body, "ament_cmake", name), "CMakeLists.txt": cmake}


def said(files: dict[str, str], code: str, *targets: str) -> list[str]:
    return [finding.message for finding in lint_files(files, [code], targets).findings]


@pytest.mark.parametrize(
    ("share", "level"),
    [
        ("mine", Severity.WARNING),
        ("theirs", Severity.INFO),
        ("get_package_share_directory('nav2_bringup')", Severity.INFO),
        ("get_package_share_directory(name)", Severity.WARNING),
        ("FindPackageShare(package='my_pkg')", Severity.WARNING),
    ],
)
def test_a_folder_is_needed_where_its_own_package_is_asked_for_it(share: str, level: Severity) -> None:
    """RViz goes on without its config: a warning."""
    install = "install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})"
    files = {**package(install), **RVIZ, "launch/a.launch.py": OPENS.format(share)}
    assert [finding.severity for finding in lint_files(files, ["CMK101"]).findings] == [level]


@pytest.mark.parametrize(("share", "level"), [("mine", Severity.ERROR), ("theirs", Severity.INFO)])
def test_the_same_holds_for_setup_py(clean, share: str, level: Severity) -> None:
    launch = OPENS.format(share).replace("robot.rviz", "tree.xml").replace("rviz", "bt_xml")
    files = {**clean, "bt_xml/tree.xml": "<root/>\n", "launch/a.launch.py": launch}
    assert [finding.severity for finding in lint_files(files, ["SET206"]).findings] == [level]


def test_an_executable_may_stand_in_bin_too() -> None:
    lines = "add_executable(talker src/talker.cpp)\ninstall(TARGETS talker DESTINATION bin)\n"
    files = {**package(lines), "src/talker.cpp": "int main() {return 0;}\n"}
    assert len(said(files, "CMK104")) == 1
    both = package(f"{lines}install(TARGETS talker DESTINATION lib/${{PROJECT_NAME}})\n")
    assert said({**files, **both}, "CMK104") == []


@pytest.mark.parametrize("condition", ["BUILD_TESTING", "SOMETHING_ELSE"])
def test_a_script_is_judged_where_it_is_certainly_installed_for_use(condition: str) -> None:
    lines = "install(FILES scripts/hello.py DESTINATION lib/${PROJECT_NAME})"
    files = {"scripts/hello.py": "#!/usr/bin/env python3\nprint('hello')\n"}
    assert len(said({**package(lines), **files}, "CMK105")) == 1
    assert said({**package(f"if({condition})\n  {lines}\nendif()"), **files}, "CMK105") == []


@pytest.mark.parametrize(
    "condition",
    ['$ENV{ROS_DISTRO} MATCHES "humble"', "NOT ROS_DISTRO STREQUAL lyrical", "COMMAND ament_target_dependencies"],
)
def test_what_asks_for_the_distribution_first_is_left_alone(condition: str) -> None:
    files = {
        **package(ASKED.format(condition), "  <depend>rclcpp</depend>\n"),
        "src/talker.cpp": "int main() {return 0;}\n",
    }
    assert said(files, "CMK005", "lyrical") == []
    other = {**files, **package(ASKED.format("WIN32"), "  <depend>rclcpp</depend>\n")}
    assert len(said(other, "CMK005", "lyrical")) == 1


def exporting(lines: str) -> dict[str, str]:
    cmake = cmk113.cmake(lines).replace("«", "").replace("»", "")
    return {**cmk113.FILES, "CMakeLists.txt": cmake}


PLUGIN = "pluginlib_export_plugin_description_file(rviz_common plugins.xml)\n"
COMPONENT = 'rclcpp_components_register_node(core PLUGIN "my_pkg::Core" EXECUTABLE core_node)\n'
HEADERS = "ament_export_include_directories(include/${PROJECT_NAME})\n"


@pytest.mark.parametrize(
    ("lines", "levels"),
    [(PLUGIN, []), (PLUGIN + HEADERS, [Severity.INFO]), (COMPONENT, [Severity.INFO]), (HEADERS, [Severity.INFO])],
)
def test_plugins_and_components_may_only_be_loaded(lines: str, levels: list[Severity]) -> None:
    files = exporting(cmk113.LINES + lines)
    assert [finding.severity for finding in lint_files(files, ["CMK113"]).findings] == levels
    own = {f"src/my_pkg/{path}": text for path, text in files.items()}
    user = package("find_package(my_pkg REQUIRED)\nadd_library(a a.cpp)", "  <depend>OTHER</depend>\n", "user_pkg")
    user["a.cpp"] = "#include <my_pkg/core.hpp>\n"
    user["package.xml"] = user["package.xml"].replace("OTHER", "my_pkg")
    theirs = {f"src/user_pkg/{path}": text for path, text in user.items()}
    found = lint_files({**own, **theirs}, ["CMK113"]).findings
    assert [finding.severity for finding in found] == [Severity.WARNING]
    bringup = {**theirs, **{f"src/user_pkg/{path}": text for path, text in package("", "", "user_pkg").items()}}
    bringup["src/user_pkg/package.xml"] = theirs["src/user_pkg/package.xml"]
    assert [finding.severity for finding in lint_files({**own, **bringup}, ["CMK113"]).findings] == levels


def with_a_user(own: dict[str, str], others: dict[str, str], finds: str) -> list[str]:
    """Return the levels of CMK113 where a package includes a header of another one and finds some packages."""
    user = package(f"find_package(my_pkg REQUIRED)\n{finds}add_library(a a.cpp)", "", "user_pkg")
    user["package.xml"] = user["package.xml"].replace("  <export>", "  <depend>my_pkg</depend>\n  <export>", 1)
    files = {f"src/my_pkg/{path}": text for path, text in own.items()}
    files |= {f"src/user_pkg/{path}": text for path, text in user.items()}
    files |= {f"src/other_pkg/{path}": text for path, text in others.items()}
    files["src/user_pkg/a.cpp"] = "#include <my_pkg/core.hpp>\n"
    return [each.severity.value for each in lint_files(files, ["CMK113"]).findings]


def test_a_package_with_a_config_of_its_own_may_find_what_is_missing() -> None:
    own = exporting(cmk113.LINES + HEADERS)
    assert with_a_user(own, {}, "") == ["warning"]
    finds = "find_package(other_pkg REQUIRED)\n"
    for text, level in (("std_msgs", "info"), ("sensor_msgs", "warning")):
        other = package(f"find_package({text} REQUIRED)\nadd_library(b b.cpp)\n", "", "other_pkg")
        other["CMakeLists.txt"] = other["CMakeLists.txt"].replace("ament_package()", "")
        assert with_a_user(own, {**other, "b.cpp": "\n"}, finds) == [level]


@pytest.mark.parametrize(("included", "level"), [("<std_msgs/msg/string.hpp>", "warning"), ('"far.hpp"', "warning"),
                                                 ("<string>", "info")])  # fmt: skip
def test_who_includes_another_header_lacks_nothing(included: str, level: str) -> None:
    old = cmk113.LINES.replace("core EXPORT export_core", "core")
    old = old.replace("export_targets(export_core HAS_LIBRARY_TARGET)", "export_libraries(core)")
    own = exporting(old + HEADERS)
    far = {"include/my_pkg/far.hpp": "#pragma once\n#include <std_msgs/msg/string.hpp>\n"}
    own["include/my_pkg/core.hpp"] = f"#pragma once\n#include {included}\n"
    assert with_a_user({**own, **far}, {}, "") == [level]


@pytest.mark.parametrize(("text", "levels"), [("std_msgs", []), ("sensor_msgs", ["warning"])])
def test_a_file_that_users_run_may_find_what_is_missing(text: str, levels: list[str]) -> None:
    own = exporting(cmk113.LINES + HEADERS)
    own["CMakeLists.txt"] = own["CMakeLists.txt"].replace("package()", "package(CONFIG_EXTRAS cmake/extras.cmake)")
    assert with_a_user({**own, "cmake/extras.cmake": f"find_package({text} REQUIRED)\n"}, {}, "") == levels


@pytest.mark.parametrize(
    "link",
    [
        "target_link_libraries(core PRIVATE ${std_msgs_TARGETS})",
        "if(SOMETHING_ELSE)\n  target_link_libraries(core PUBLIC ${std_msgs_TARGETS})\nendif()",
        "add_executable(tool src/core.cpp)\ntarget_link_libraries(tool PUBLIC ${std_msgs_TARGETS})",
    ],
)
def test_what_a_library_does_not_certainly_pass_on_need_not_be_exported(link: str) -> None:
    public = "target_link_libraries(core PUBLIC rclcpp::rclcpp «${std_msgs_TARGETS}»)"
    assert public in cmk113.LINES
    without = "target_link_libraries(core PUBLIC rclcpp::rclcpp)"
    assert len(said(exporting(cmk113.LINES), "CMK113")) == 1
    assert said(exporting(cmk113.LINES.replace(public, f"{without}\n{link}")), "CMK113") == []


def test_a_library_without_a_target_lacks_headers() -> None:
    old = cmk113.LINES.replace("core EXPORT export_core", "core").replace(
        "ament_export_targets(export_core HAS_LIBRARY_TARGET)",
        "ament_export_include_directories(include/${PROJECT_NAME})\nament_export_libraries(core)",
    )
    (message,) = said(exporting(old), "CMK113")
    assert "because a header of `std_msgs` was not found" in message


def test_libraries_of_the_system_are_found_in_ways_of_their_own() -> None:
    files = exporting(cmk113.LINES)
    renamed = {path: text.replace("std_msgs", "GeographicLib") for path, text in files.items()}
    declared = renamed["package.xml"].replace("<depend>GeographicLib<", "<depend>geographiclib<")
    assert len(said(renamed, "CMK113")) == 1
    assert said({**renamed, "package.xml": declared}, "CMK113") == []


def test_what_another_package_looks_for_itself_is_there() -> None:
    files = exporting(
        cmk113.LINES.replace("std_msgs", "class_loader").replace("cies(rclcpp)", "cies(rclcpp_components)")
    )
    files = {path: text.replace("std_msgs", "class_loader") for path, text in files.items()}
    assert said(files, "CMK113") == []


@pytest.mark.parametrize("place", ["include", "include/my_pkg"])
def test_headers_go_where_they_are_exported_from(place: str) -> None:
    files = {**package(f'ament_export_include_directories("{place}")'), "include/my_pkg/a.hpp": "#pragma once\n"}
    (finding,) = lint_files(files, ["CMK106"]).findings
    wanted = place.replace("my_pkg", "${PROJECT_NAME}")
    assert finding.fix is not None
    assert f"install(DIRECTORY include/\n  DESTINATION {wanted}\n)" in finding.fix.operations[0].text


@pytest.mark.parametrize(("sources", "count"), [("a.hpp b.h", 0), ("a.hpp b.cpp", 1), ("a.hpp ${MORE}", 1)])
def test_a_library_of_headers_is_nothing_to_load(sources: str, count: int) -> None:
    lines = f"add_library(empty SHARED {sources})\nadd_library(core SHARED core.cpp)\n"
    lines += "target_link_libraries(core empty)\ninstall(TARGETS core DESTINATION lib)"
    files = {**package(lines), **dict.fromkeys(("a.hpp", "b.h", "b.cpp", "core.cpp"), "")}
    assert len(said(files, "CMK103")) == count


def repaired(files: dict[str, str], code: str) -> str:
    """Return CMakeLists.txt as the fixes of a rule leave it."""
    tree = MemoryTree.of(files)
    folders = tuple(packages_in(tree))
    session = Session(tree, Scope(folders, frozenset(folders), "my_pkg"), frozenset({code}), Targets())
    outcome = fix_all(session, (Safety.SAFE, Safety.UNSAFE))
    changed = outcome.changes["CMakeLists.txt"].text
    return changed.text if changed else ""


NODE = {"src/a.cpp": "int main() {return 0;}\n", "src/core.cpp": "int core() {return 1;}\n"}
LIB = "  ARCHIVE DESTINATION lib\n  LIBRARY DESTINATION lib\n  RUNTIME DESTINATION bin\n"


def test_a_target_is_installed_below_the_call_that_makes_it() -> None:
    lines = "install(DIRECTORY src DESTINATION share/${PROJECT_NAME})\nadd_executable(a src/a.cpp)\n"
    text = repaired({**package(lines), **NODE}, "CMK103")
    assert text.endswith("install(TARGETS a\n  DESTINATION lib/${PROJECT_NAME}\n)\n\nament_package()\n")


def test_a_target_that_may_not_be_there_is_asked_for() -> None:
    lines = "add_executable(a src/a.cpp)\nfind_package(CUDA)\nif(CUDA_FOUND)\n"
    lines += "  add_library(${PROJECT_NAME}_gpu SHARED src/core.cpp)\n  target_link_libraries(a ${PROJECT_NAME}_gpu)\n"
    lines += "endif()\ninstall(TARGETS a DESTINATION lib/${PROJECT_NAME})\n"
    text = repaired({**package(lines), **NODE}, "CMK103")
    rule = f"install(TARGETS ${{PROJECT_NAME}}_gpu\n{LIB})".replace("\n", "\n  ")
    assert f"if(TARGET ${{PROJECT_NAME}}_gpu)\n  {rule}\nendif()\n" in text


def test_targets_of_a_loop_are_installed_by_their_names() -> None:
    lines = "foreach(n a b)\n  add_executable(${n} src/a.cpp)\nendforeach()\n"
    text = repaired({**package(lines), **NODE}, "CMK103")
    assert "$" not in text.replace("${PROJECT_NAME}", "").partition("endforeach()")[2]


def test_an_example_that_a_test_starts_by_its_path_is_where_it_belongs() -> None:
    lines = "add_executable(a src/a.cpp)\ninstall(TARGETS a DESTINATION share/${PROJECT_NAME}/examples)\n"
    files = {**package(lines), **NODE}
    assert len(said(files, "CMK104")) == 1
    assert said({**files, "test/test_a.py": "PATH = prefix + '/share/my_pkg/examples/a'\n"}, "CMK104") == []
    assert len(said({**files, "test/test_a.py": "PATH = prefix + '/share/my_pkg/a'\n"}, "CMK104")) == 1


def test_all_dependencies_are_exported_in_one_call() -> None:
    text = repaired(exporting(cmk113.LINES.replace("ament_export_dependencies(rclcpp)\n", "")), "CMK113")
    assert "ament_export_targets(export_core HAS_LIBRARY_TARGET)\nament_export_dependencies(rclcpp std_msgs)\n" in text


def test_what_may_be_called_by_its_name_is_not_moved_safely() -> None:
    lines = "add_executable(a src/a.cpp)\ninstall(TARGETS a DESTINATION bin)\n"
    (finding,) = lint_files({**package(lines), **NODE}, ["CMK104"]).findings
    assert finding.fix is not None
    assert finding.fix.safety is Safety.UNSAFE
    readme = {"README.md": "Start it with `ros2 run my_pkg a`.\n"}
    (finding,) = lint_files({**package(lines), **NODE, **readme}, ["CMK104"]).findings
    assert finding.fix is not None
    assert finding.fix.safety is Safety.SAFE
    readme = {"README.md": "It needs root: `sudo install/my_pkg/bin/a`.\n"}
    assert lint_files({**package(lines), **NODE, **readme}, ["CMK104"]).findings == ()


def test_a_target_of_a_folder_is_installed_beside_its_like() -> None:
    below = "add_executable(a a.cpp)\nadd_executable(b a.cpp)\ninstall(TARGETS a DESTINATION lib/${PROJECT_NAME})\n"
    files = {**package("add_subdirectory(src)"), **NODE, "src/CMakeLists.txt": below}
    (finding,) = lint_files(files, ["CMK103"]).findings
    assert finding.fix is not None
    (edit,) = finding.fix.operations
    assert (edit.path, edit.text) == ("src/CMakeLists.txt", " b")


@pytest.mark.parametrize(
    ("lines", "count"),
    [
        ("ament_add_gtest(test_a test/a.cpp)", 1),
        ("ament_add_gtest(test_a ${SOURCES})", 0),
        ("ament_add_gtest(test_a ${CMAKE_CURRENT_BINARY_DIR}/a.cpp)", 0),
        ("ament_add_gtest(test_a ../other/a.cpp)", 0),
        ("ament_add_gtest(test_a SKIP_TEST WORKING_DIRECTORY test/there APPEND_ENV A=b)", 0),
        ("ament_add_gtest(test_a test/ignored.cpp)", 0),
        ("configure_file(a.cpp.in ${CMAKE_CURRENT_SOURCE_DIR}/test/a.cpp)\nament_add_gtest(test_a test/a.cpp)", 0),
        ("ament_add_pytest_test(test_a test/a.py)", 1),
        ("ament_add_pytest_test(test_a test)", 0),
        ("ament_add_pytest_test(${NAME} test/a.py)", 0),
        ("if(SOMETHING_ELSE)\n  ament_add_pytest_test(test_a test/a.py)\nendif()", 0),
        ("ament_add_ros_isolated_pytest_test(test_a test/a.py)", 1),
        ("add_ros_test(test/a.py)", 1),
        ("function(add_launch_test name)\nendfunction()\nadd_launch_test(test/a.py)", 0),
        ("generate_parameter_library(parameters src/a.yaml)", 1),
        ("generate_parameter_library(${NAME} src/a.yaml)", 0),
        ("generate_parameter_library(parameters test/there.py src/validators.hpp)", 0),
        ("ament_auto_package(INSTALL_TO_SHARE test USE_SCOPED_HEADER_INSTALL_DIR)", 0),
        ("ament_auto_package(INSTALL_TO_SHARE test USE_SCOPED_HEADERS)", 1),
    ],
)
def test_what_tests_and_parameters_need(lines: str, count: int) -> None:
    files = {**package(lines), "test/there.py": "", ".gitignore": "ignored.cpp\n"}
    assert len(said(files, "CMK102")) == count


@pytest.mark.parametrize(
    ("arguments", "near"),
    [
        ("rclcpp::rclcpp", ""),
        ("rclcpp::rclpcp", "rclcpp::rclcpp"),
        ("rclcpp::rclpc", "rclcpp::rclcpp"),
        ("rclcpp::rclp", "rclcpp::rclcpp"),
        ("rclcpp::rcl", ""),
        ("rclcpp::rclcpp2", ""),
        ("rcclpp::rclcpp", "rclcpp::rclcpp"),
        ("rcclp::rclcpp", ""),
        ("$<BUILD_INTERFACE:rclcpp::rclpcp>", ""),
        ("OpenMP::OpenMP_C", ""),
        ("base::basics", ""),
        ("base::bsaic", "base::basic"),
        ("my_pkg::coer", "my_pkg::core"),
        ("tf2::tf22", ""),
        ("nav_msgs::nav_smgs", "nav_msgs::nav_msgs"),
        ("nav_msgs::nav_msgs", ""),
        ("nav_msgs::nav_msg", "nav_msgs::nav_msgs"),
        ("Rclcpp::rclcpp", "rclcpp::rclcpp"),
        ("rclcpP::rclcpp", ""),
    ],
)
def test_targets_that_are_nearly_those_of_a_package(arguments: str, near: str) -> None:
    link = (
        "find_package(rclcpp REQUIRED)\nfind_package(OpenMP REQUIRED)\nfind_package(base REQUIRED)\n"
        "add_library(core src/core.cpp)\nadd_library(my_pkg::core ALIAS core)\nadd_library(base::basics ALIAS core)\n"
        "add_library(rclcpP::rclcpp ALIAS core)\n"
        f"add_library(user src/core.cpp)\ntarget_link_libraries(user PUBLIC {arguments})\n"
    )
    export = "install(TARGETS basic EXPORT export_base DESTINATION lib)\nament_export_targets(export_base)"
    base = package(f"add_library(basic src/basic.cpp)\n{export}", name="base")
    files = {
        f"{name}/{path}": text
        for name, each in (("my_pkg", package(link)), ("base", base))
        for path, text in each.items()
    }
    found = said(files, "CMK110")
    assert [message.partition("did you mean `")[2].partition("`")[0] for message in found] == ([near] if near else [])


@pytest.mark.parametrize(
    ("name", "near"),
    [
        ("rclcpp", ""),
        ("rclpcp", "rclcpp"),
        ("rclp", ""),
        ("rclpy", ""),
        ("std_msg", "std_msgs"),
        ("Eigen", ""),
        ("helper_lib", "helper_libs"),
        ("helpers", ""),
        ("hepler_ilbs", "helper_libs"),
        ("hepler_ilsb", ""),
        ("helper_libs", ""),
        ("rclc", ""),
        ("std_srvs", ""),
        ("std_msgs_", "std_msgs"),
        ("${UNKNOWN_PACKAGES}", ""),
    ],
)
def test_packages_that_are_nearly_one_that_is_found(name: str, near: str) -> None:
    lines = (
        "find_package(rclcpp REQUIRED)\nfind_package(Eigen3 REQUIRED)\nfind_package(helper_libs REQUIRED)\n"
        "find_package(helper_libz REQUIRED)\n"
        f"add_library(core src/core.cpp)\nament_target_dependencies(core PUBLIC {name})\n"
    )
    found = said(package(lines, "  <depend>std_msgs</depend>\n"), "CMK117")
    assert [message.partition("did you mean `")[2].partition("`")[0] for message in found] == ([near] if near else [])


def test_a_mistyped_target_in_a_branch_is_left_alone_and_told_once() -> None:
    start = "find_package(rclcpp REQUIRED)\nadd_library(core src/core.cpp)\nadd_library(base src/core.cpp)\n"
    link = "target_link_libraries({} PUBLIC rclcpp::rclpcp)"
    assert said(package(f"{start}if(SOMETHING_ELSE)\n  {link.format('core')}\nendif()"), "CMK110") == []
    looped = f"{start}foreach(each core base)\n  {link.format('${each}')}\nendforeach()"
    assert len(said(package(looped), "CMK110")) == 1


@pytest.mark.parametrize(
    ("lines", "near"),
    [
        ("target_inclde_directoris(core PUBLIC include)", "target_include_directories"),
        ("target_inclde_diretoris(core PUBLIC include)", ""),
        ("ament_taget_dependencies(core rclcpp)", "ament_target_dependencies"),
        ("mesage(STATUS hello)", "message"),
        ("mesagge(STATUS hello)", ""),
        ("prjoectt(other)", "project"),
        ("messaeg1(STATUS hello)", ""),
        ("mesag(STATUS hello)", ""),
        ("lists(APPEND a b)", ""),
        ("add_gtest(test_core)", ""),
        ("qt4_wrap_cpp(core)", ""),
        ("roslint_cpp()", ""),
        ("function(add_my_robot)\nendfunction()\nadd_my_rboot()", "add_my_robot"),
        ("function(add_exectable)\nendfunction()\nadd_exectable()", ""),
        ("if(SOMETHING_ELSE)\n  mesage(STATUS hello)\nendif()", ""),
        ("include(${WHEREVER})\nmesage(STATUS hello)", ""),
        ("foreach(each a b)\n  mesage(STATUS hello)\nendforeach()", "message"),
    ],
)
def test_commands_that_are_nearly_a_known_one(lines: str, near: str) -> None:
    found = said(package(lines), "CMK114")
    assert [message.partition("did you mean `")[2].partition("`")[0] for message in found] == ([near] if near else [])


def test_a_misspelt_ament_package_is_one_finding() -> None:
    files = package("")
    for name, codes in (("ament_apckage", ["CMK114"]), ("ament_done", ["CMK003"]), ("mesage", ["CMK003", "CMK114"])):
        cmake = files["CMakeLists.txt"].replace("ament_package()", f"{name}()")
        found = lint_files({**files, "CMakeLists.txt": cmake}, ["CMK003", "CMK114"]).findings
        assert sorted(finding.code for finding in found) == codes


@pytest.mark.parametrize(
    ("lines", "levels"),
    [
        ("install(FILES a.txt DESTINATION share/${PROJECTNAME})", [Severity.ERROR]),
        ('include_directories("${CMAKE_CURENT_SOURCE_DIR}/include")', [Severity.INFO]),
        ("include_directories(${CMAKE_CURENT_SUORCE_DIR})", [Severity.INFO]),
        ("include_directories(${CMAKE_CURENT_SUORCE_DIRS})", []),
        ("include_directories(${PROJECT_NAME} ${PROJECT_NAME2} ${SOMETHING})", []),
        ("include_directories([[${PROJECTNAME}]])", []),
        ("include_directories(\\${PROJECTNAME})", []),
        ("include_directories(PROJECTNAMES)\ninclude_directories(${PROJECTNAMES})", []),
        ("set(PROJECTNAME a)\ninclude_directories(${PROJECTNAME})", []),
        ("message(STATUS ${PROJECTNAME})", []),
        ("if(SOMETHING_ELSE)\n  include_directories(${PROJECTNAME})\nendif()", [Severity.INFO]),
        ("include(${WHEREVER})\ninclude_directories(${PROJECTNAME})", []),
        ('cmake_parse_arguments(PROJECT "NAMES" "" "" ${ARGN})\ninclude_directories(${PROJECT_NAMES})', []),
        ("foreach(each a b)\n  include_directories(${PROJECTNAME})\nendforeach()", [Severity.INFO]),
        ("include_directories(${PROJECTNAME} ${ROJECT_NAME})", [Severity.INFO, Severity.INFO]),
    ],
)
def test_variables_that_are_nearly_one_of_cmake(lines: str, levels: list[Severity]) -> None:
    files = {**package(lines), "a.txt": ""}
    assert [finding.severity for finding in lint_files(files, ["CMK115"]).findings] == levels


FOUND = "".join(f"find_package({name} REQUIRED)\n" for name in ("rclcpp", "std_msgs", "OpenCV", "ompl"))


@pytest.mark.parametrize(
    ("lines", "near"),
    [
        ("include_directories(${RCLCPP_INCLUDE_DIRS})", "rclcpp_INCLUDE_DIRS"),
        ("include_directories(${Std_Msgs_LIBRARIES})", "std_msgs_LIBRARIES"),
        ("include_directories(${rclcpp_INCLUDE_DIR})", "rclcpp_INCLUDE_DIRS"),
        ("include_directories(${rclcpp_LIBS})", "rclcpp_LIBRARIES"),
        ("include_directories(${rclcpp_LIBRARIES})", ""),
        ("include_directories(${OPENCV_LIBS})", "OpenCV_LIBS"),
        ("include_directories(${OpenCV_LIBS} ${OpenCV_INCLUDE_DIR})", ""),
        ("include_directories(${OMPL_LIBRARIES})", ""),
        ("include_directories(${rclpy_LIBS})", ""),
        ("set(RCLCPP_LIBRARIES a)\ninclude_directories(${RCLCPP_LIBRARIES})", ""),
        ("set(rclcpp_LIBRARIES a)\ninclude_directories(${RCLCPP_LIBRARIES})", "rclcpp_LIBRARIES"),
        ("set(SOURCES a)\ninclude_directories(${SOURCE})", "SOURCES"),
        ("set(SRCS a)\ninclude_directories(${SRCSS})", ""),
        ("set(SOURCES a)\ninclude_directories(${SOURC})", ""),
        ("set(SOME_SOURCES a)\ninclude_directories(${SOME_SOURC})", ""),
        ("set(SOME_SOURCES a)\ninclude_directories(${SOME_SOURCE})", "SOME_SOURCES"),
        ("set(SOME_SOURCEFILES a)\ninclude_directories(${SOME_SOURCEFIL})", "SOME_SOURCEFILES"),
        ("set(SOME_SOURCES2 a)\ninclude_directories(${SOME_SOURCES})", ""),
        ("set(rclcpp_sources a)\ninclude_directories(${rclcpp_source})", ""),
        ("set(my_pkg_sources a)\ninclude_directories(${my_pkg_source})", ""),
        ("set(SOURCES a)\nteam_macro(a)\ninclude_directories(${SOURCE})", ""),
    ],
)
def test_variables_that_are_nearly_one_of_a_package(lines: str, near: str) -> None:
    found = said(package(FOUND + lines), "CMK115")
    levels = {each.severity for each in lint_files(package(FOUND + lines), ["CMK115"]).findings}
    assert levels == ({Severity.INFO} if near else set())  # a build that needs it tells so
    assert [message.partition("did you mean `")[2].partition("`")[0] for message in found] == ([near] if near else [])


@pytest.mark.parametrize(
    ("lines", "level", "strange"),
    [
        ("set(SOURCES src/a.cpp)\nadd_executable(a ${SORCES})", "warning", "info"),
        ("set(SOURCES src/a.cpp)\nadd_executable(a ${SOUCRES})", "warning", "warning"),
        ("set(SOURCES src/a.cpp)\nadd_executable(a ${Sources})", "info", "info"),
        ("set(SOURCE_FILES src/a.cpp)\nadd_executable(a ${SOURCES_FIELS})", "info", "info"),
        ("install(FILES a.txt DESTINATION share/${PROJECTNAME})", "error", "error"),
        ("install(FILES a.txt DESTINATION share/${PROJCETNAME})", "info", "info"),
        ("install(FILES a.txt DESTINATION share/${RCLCPP_LIBS})", "info", "info"),
        ("add_executable(${NODES} src/a.cpp)", "warning", "info"),
        ("set(CORE_FILES a)\nlist(APPEND CORE_FILSE b)\nmessage(${CORE_FILES})", "info", "info"),
        ("set(CORE_FILES a)\nlist(APPEND CORE_FIELDS b)\nmessage(${CORE_FILES})", "info", "info"),
    ],
)
def test_what_another_package_may_set_is_an_info(lines: str, level: str, strange: str) -> None:
    files = {"a.txt": "", "src/a.cpp": "int main() {return 0;}\n"}
    for found, expected in (("rclcpp", level), ("rclcpp)\nfind_package(team_tools", strange)):
        whole = {**package(f"find_package({found})\n{lines}"), **files}
        levels = [each.severity.value for each in lint_files(whole, ["CMK115"]).findings]
        assert levels == [expected]


BUILT = "add_executable(talker src/a.cpp)\nadd_executable(spare src/a.cpp)\nset(NODES talker)\n"


@pytest.mark.parametrize(
    ("items", "codes"),
    [
        ("${NODES}", ["CMK103"]),
        ("${NODES} ${LIBS}", ["CMK103", "CMK115"]),
        ("${NODES} a${LIBS}", []),
        ("${NODES} ${rclcpp_LIBS}", ["CMK103", "CMK115"]),
        ("${NODES} ${CMAKE_LIBS}", []),
        ("${NODES} ${my_pkg_LIBS}", []),
        ("${NODES} ${FUTURE_NODES}", ["CMK103", "CMK115"]),
    ],
)
def test_what_nothing_sets_installs_nothing(items: str, codes: list[str]) -> None:
    lines = f"{BUILT}install(TARGETS {items} DESTINATION lib/${{PROJECT_NAME}})"
    files = {**package(lines), "src/a.cpp": "int main() {return 0;}\n"}
    found = lint_files(files, ["CMK103", "CMK115"]).findings
    assert sorted(each.code for each in found) == codes
    assert {each.severity for each in found if each.code == "CMK115"} <= {Severity.INFO}
    unread = {**files, **package(f"include(${{WHEREVER}})\n{lines}")}
    assert said(unread, "CMK115") == []


def test_an_unset_variable_says_what_is_left() -> None:
    (message,) = said(package('include_directories("${PROJECTNAME}/include")'), "CMK115")
    assert "`${PROJECTNAME}/include` becomes `/include`" in message
    (message,) = said(package("include_directories(${PROJECTNAME})"), "CMK115")
    assert "becomes nothing" in message
    (message,) = said(package('include_directories("${PROJECTNAME}\n")'), "CMK115")
    assert "becomes" not in message
    for length, count in ((60, 1), (61, 0)):
        path = "${PROJECTNAME}/".ljust(length, "a")
        (message,) = said(package(f"include_directories({path})"), "CMK115")
        assert message.count("becomes") == count


@pytest.mark.parametrize(
    ("path", "count"),
    [
        *((f"config/a.{end}", 1) for end in ("json5", "toml", "ini", "cfg", "conf", "xml", "txt", "TOML")),
        *(
            (f"config/{name}", 0)
            for name in ("CMakeLists.txt", "requirements.txt", "README.txt", "license.txt", "a.md")
        ),
        *((f"description/a.{end}", 1) for end in ("urdf", "xacro", "srdf", "sdf", "world", "stl", "dae", "glb")),
        *((f"{name}/a.sdf", 1) for name in ("robot_description", "robot", "gazebo", "sdf", "simulation", "scenes")),
        ("description/a.txt", 0),
        ("anything/a.sdf", 0),
    ],
)
def test_files_that_are_for_run_time(path: str, count: int) -> None:
    assert len(said({**package(""), path: "a\n"}, "CMK101")) == count


@pytest.mark.parametrize(("more", "count"), [("", 1), (" RENAME hello", 0), (" PERMISSIONS OWNER_EXECUTE", 0)])
def test_a_bit_is_not_needed_where_ament_makes_no_link(more: str, count: int) -> None:
    files = package(f"install(PROGRAMS scripts/hello.py{more} DESTINATION lib/${{PROJECT_NAME}})")
    files = {**files, "scripts/hello.py": TreeEntry("file", b"#!/bin/sh\necho\n", 0o644)}
    assert len(lint_files(files, ["CMK105"]).findings) == count


@pytest.mark.parametrize(
    ("place", "count"),
    [
        ("lib/python3.12/site-packages/my_pkg", 0), ("lib/python3/dist-packages/my_pkg", 0),
        ("lib/python3.12/other/my_pkg", 1), ("lib/python3.12/site-packages-of/my_pkg", 1),
    ],
)  # fmt: skip
def test_modules_that_are_installed_where_one_python_looks(place: str, count: int) -> None:
    files = {
        **package(
            "install(PROGRAMS scripts/hello.py DESTINATION lib/${PROJECT_NAME})\n"
            f"install(DIRECTORY my_pkg/ DESTINATION {place})"
        ),
        "scripts/hello.py": "#!/usr/bin/env python3\nfrom my_pkg.words import HELLO\n\nprint(HELLO)\n",
        "my_pkg/__init__.py": "",
        "my_pkg/words.py": "HELLO = 'hello'\n",
    }
    assert len(said(files, "CMK109")) == count


@pytest.mark.parametrize(
    ("name", "command", "count"),
    [
        ("ament_target_dependencies", "ament_target_dependencies", 0),
        ("more", "ament_target_dependencies", 1),
        ("FindPackageHandleStandardArgs", "find_package_handle_standard_args", 0),
        ("GoogleTest", "gtest_discover_tests", 0),
        ("more", "gtest_discover_tests", 1),
        ("bindTools", "pybind11_add_module", 0),
        ("more", "rosidl_generate_interfaces", 0),
        ("more", "qt5_wrap_ui", 0),
        ("more", "qt_wrap_ui", 1),
    ],
)
def test_a_copy_of_a_command_in_its_own_file(name: str, command: str, count: int) -> None:
    text = f"function({command})\nendfunction()\n"
    files = {**package(f"include(cmake/{name}.cmake)"), f"cmake/{name}.cmake": text}
    assert len(said(files, "CMK116")) == count


def test_what_one_install_breaks_is_one_finding() -> None:
    files = package(
        "install(PROGRAMS scripts/a.py scripts/b.py DESTINATION lib/${PROJECT_NAME})\n"
        "install(PROGRAMS scripts/c.py DESTINATION lib/${PROJECT_NAME})"
    )
    scripts = {f"scripts/{name}.py": TreeEntry("file", b"#!/bin/sh\necho\n", 0o644) for name in "abc"}
    findings = lint_files({**files, **scripts}, ["CMK105"]).findings
    assert [[place.path for place, _ in finding.related] for finding in findings] == [["scripts/b.py"], []]
    assert findings[0].message.startswith("`scripts/a.py` and `scripts/b.py` are not executable: ")
    assert findings[0].message.endswith(
        "; `chmod +x` them (nothing here starts it, and a copy of files may lose the bit)"
    )
    assert findings[0].fix is not None
    assert len(findings[0].fix.operations) == 2


GONE = "install(DIRECTORY {} DESTINATION share/${{PROJECT_NAME}})\n"


@pytest.mark.parametrize(
    ("lines", "starts"),
    [
        (GONE.format("maps rviz"), ["`maps` and `rviz` do not exist"]),
        (GONE.format("maps") + GONE.format("rviz"), ["`maps` does not exist", "`rviz` does not exist"]),
        (GONE.format("maps") + GONE.format("maps rviz"), ["`maps` and `rviz` do not exist"]),
        (GONE.format("maps lanch"), ["`maps` does not exist", "`lanch` does not exist (did you mean `launch`?)"]),
        (GONE.format("maps maps"), ["`maps` does not exist"]),
    ],
)
def test_folders_that_one_command_installs_are_one_cause(lines: str, starts: list[str]) -> None:
    files = {**package(lines + GONE.format("launch")), "launch/a.launch.xml": "<launch/>\n"}
    found = said(files, "CMK102")
    assert sorted(each.partition(":")[0] for each in found) == sorted(starts)
    assert all(("add files to them" in each) is ("do not" in each) for each in found)


def test_scripts_that_cmake_gives_to_chmod() -> None:
    """Those that it does not name keep their fault."""
    names = (
        "set(NODES a.py)\nforeach(node ${NODES})\n  execute_process(COMMAND {} +x ${CMAKE_INSTALL_PREFIX}/lib/my_pkg/"
    )
    lines = f"install(DIRECTORY scripts/ DESTINATION lib/${{PROJECT_NAME}})\n{names}${{node}})\nendforeach()"
    files = {f"scripts/{name}.py": "#!/usr/bin/env python3\nprint()\n" for name in "ab"}
    (finding,) = lint_files({**package(lines.replace("{} +x", "chmod +x")), **files}, ["CMK105"]).findings
    assert finding.message.startswith("the executable bit of `scripts/b.py` is not")
    (finding,) = lint_files({**package(lines.replace("{} +x", "echo")), **files}, ["CMK105"]).findings
    assert finding.message.startswith("the executable bit of `scripts/a.py` and `scripts/b.py` is not")


@pytest.mark.parametrize(
    ("keeps", "end"),
    [
        ("", "`chmod +x scripts/a.py` (`git update-index --chmod=+x`), and add USE_SOURCE_PERMISSIONS"),
        (
            " USE_SOURCE_PERMISSIONS",
            "; `chmod +x scripts/a.py` (nothing here starts it, and a copy of files may lose the bit)",
        ),
    ],
)
def test_a_folder_whose_scripts_have_no_bit_to_keep(keeps: str, end: str) -> None:
    files = package(f"install(DIRECTORY scripts/ DESTINATION lib/${{PROJECT_NAME}}{keeps})")
    script = TreeEntry("file", b"#!/usr/bin/env python3\nprint()\n", 0o644)
    (finding,) = lint_files({**files, "scripts/a.py": script}, ["CMK105"]).findings
    assert finding.message.endswith(end)
    assert finding.fix is not None
    assert len(finding.fix.operations) == (1 if keeps else 2)
