"""Faults that are loud only where it is shown that something fails: what CMake is not given, and does not do."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, SETUP_CFG, manifest, scripts, setup_py
from rospkg_cli.testing import lint_files


def said(files: dict[str, str], code: str) -> list[str]:
    found = lint_files({f"src/my_pkg/{path}": text for path, text in files.items()}, [code]).findings
    return [f"{each.severity.value}: {each.message}" for each in found]


def package(lines: str, **sources: str) -> dict[str, str]:
    text = CMAKE.replace("ament_package", f"{lines}\nament_package")
    named = {name.replace("__", "/"): text for name, text in sources.items()}
    return {"package.xml": manifest("", "ament_cmake"), "CMakeLists.txt": text, **named}


GLOB = "file(GLOB SOURCES src/*.cpp)\nfile(GLOB HEADERS include/*.hpp)\n"
CODE = {"src/core/a.cpp": "int core() {return 1;}\n", "src/core/main.cc": "int main() {return 0;}\n"}


@pytest.mark.parametrize(
    ("lines", "level"),
    [
        ("add_library(core SHARED ${SOURCES})", "warning"),
        ("add_library(core SHARED ${SOURCES} ${HEADERS})", "warning"),
        ("add_library(core SHARED ${SOURCES} src/core/main.cc)", "info"),
        ("add_executable(core ${SOURCES} ${MORE})", "info"),
        ("foreach(each ${SOURCES})\n  message(${each})\nendforeach()", "info"),
        ("install(FILES ${SOURCES} DESTINATION share/my_pkg)", "info"),
        ("set(ALL ${SOURCES} src/core/main.cc)\nadd_library(core ${ALL})", "info"),
        ("rosidl_generate_interfaces(${PROJECT_NAME} ${SOURCES} DEPENDENCIES std_msgs)", "warning"),
    ],
)
def test_what_lacks_the_files_of_an_empty_glob(lines: str, level: str) -> None:
    (text,) = said(package(GLOB + lines) | CODE, "CMK124")
    assert text.startswith(f"{level}: ")
    assert ("; nothing here is made of it alone" in text) == (level == "info")


@pytest.mark.parametrize(
    ("lines", "level"),
    [
        ("function(message text)\nendfunction()", "info"),
        ("macro(install)\nendmacro()", "warning"),
        ("macro(find_package name)\n  list(APPEND FOUND ${name})\nendmacro()", "warning"),
        ("function(add_definitions)\n  message(STATUS none)\nendfunction()\nadd_definitions(-DARM)", "warning"),
        ("function(add_definitions)\n  add_compile_options(${ARGV})\nendfunction()\nadd_definitions(-DARM)", "info"),
        ("function(ament_package)\n  message(STATUS none)\nendfunction()", "warning"),
    ],
)
def test_a_command_that_is_defined_anew_to_do_the_same(lines: str, level: str) -> None:
    (text,) = said(package(lines), "CMK116")
    assert text.startswith(f"{level}: ")
    assert ("which may be intended" in text) == (level == "info")


CONFIG = (
    "- ros_topic_name: a\n  gz_topic_name: a\n  ros_type_name: std_msgs::msg::Bool\n  gz_type_name: gz.msgs.Boolean\n"
)


@pytest.mark.parametrize(
    ("starts", "level"),
    [("<launch/>\n", "info"), ('<launch>\n  <let name="bridge" value="config/bridge.yaml"/>\n</launch>\n', "warning")],
)
def test_a_config_of_a_bridge_that_something_names(starts: str, level: str) -> None:
    install = "install(DIRECTORY config launch DESTINATION share/${PROJECT_NAME})"
    files = package(install, config__bridge_dot_yaml=CONFIG, launch__a_dot_launch_dot_xml=starts)
    (text,) = said({path.replace("_dot_", "."): each for path, each in files.items()}, "LCH019")
    assert text.startswith(f"{level}: ")
    assert (", but nothing here names this file" in text) == (level == "info")


JOINS = """\
import os

from ament_index_python.packages import get_package_share_directory


def opened(namespace, debug):
    return {}


def main():
    {}
"""


@pytest.mark.parametrize(
    ("path", "call", "level"),
    [
        ("os.path.join(get_package_share_directory('my_pkg'), '/maps')", "opened('', True)", "warning"),
        ("os.path.join(get_package_share_directory('my_pkg'), '/maps')", "print()", "info"),
        ("os.path.join(namespace, '/maps/a.yaml')", "opened('', True)", "warning"),
        ("os.path.join(namespace, '/cmd_vel')", "opened('', True)", "info"),
    ],
)
def test_a_dropped_path_that_a_program_comes_to(path: str, call: str, level: str) -> None:
    files = {
        "package.xml": manifest(""),
        "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
        "setup.cfg": SETUP_CFG,
        "my_pkg/__init__.py": "",
        "my_pkg/talker.py": JOINS.format(path, call),
    }
    (text,) = said(files, "LCH021")
    assert text.startswith(f"{level}: ")


TWICE = """\
<launch>
  <arg name="camera1" default="/left"/>
  <arg name="camera1" default="/right"/>
  {}
  <log message="$(var camera1) and $(var camera2 /middle)"/>
</launch>
"""


@pytest.mark.parametrize(
    ("line", "level"), [("", "warning"), ('<include file="$(find-pkg-share no_one)/a.launch.xml"/>', "info")]
)
def test_an_argument_that_an_included_file_may_declare(line: str, level: str) -> None:
    files = {"package.xml": manifest(""), "launch/a.launch.xml": TWICE.format(line)}
    assert [text.partition(":")[0] for text in said(files, "LCH020")] == [level]


AWAITED = """\
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import ExecuteProcess, RegisterEventHandler
from launch.event_handlers import OnProcessExit


def generate_launch_description():
    share = get_package_share_directory('{}')
    first = ExecuteProcess(cmd=['echo', share])
    second = ExecuteProcess(cmd=['echo'])
    return LaunchDescription([RegisterEventHandler(OnProcessExit(target_action=first, on_exit=[second]))])
"""


@pytest.mark.parametrize(("package", "level"), [("my_pkg", "warning"), ("pkg_of_nobody", "info")])
def test_an_awaited_action_of_a_launch_that_ends_before(package: str, level: str) -> None:
    files = {"package.xml": manifest(""), "launch/a.launch.py": AWAITED.format(package)}
    assert [text.partition(":")[0] for text in said(files, "LCH018")] == [level]


NAMED = "add_executable(${PROJECTNAME}_node src/a.cpp)\ninstall(TARGETS ${PROJECTNAME}_node DESTINATION lib/my_pkg)"


@pytest.mark.parametrize(
    ("lines", "levels"),
    [
        (NAMED, ["info", "info"]),
        (NAMED.replace("TARGETS ${PROJECTNAME}", "TARGETS ${PROJECT_NAME}"), ["warning"]),
        (NAMED.replace("add_executable(${PROJECTNAME}", "add_executable(${PROJECT_NAME}"), ["error"]),
    ],
)
def test_a_target_that_is_called_so_everywhere(lines: str, levels: list[str]) -> None:
    found = said(package(lines, src__a=""), "CMK115")
    assert [text.partition(":")[0] for text in found] == levels
    assert all(text.endswith("; the target is called so everywhere") == text.startswith("info") for text in found)


HEADER = {"include/a.hpp": "int a();\n", "src/a.cpp": '#include "a.hpp"\nint main() {return a();}\n'}


@pytest.mark.parametrize(
    ("lines", "level"),
    [
        ("include_directories({CMAKE_CURRENT_SOURCE_DIR}/include)\nadd_executable(a src/a.cpp)", "warning"),
        ("include_directories(include {CMAKE_CURRENT_SOURCE_DIR}/include)\nadd_executable(a src/a.cpp)", "info"),
        ("set(FOLDERS include)\ninclude_directories({FOLDERS})\nadd_executable(a src/a.cpp)", "info"),
        ("link_directories($PROJECT_SOURCE_DIR/lib)", "info"),
        ("set(LIBRARIES m)\nadd_executable(a src/a.cpp)\ntarget_link_libraries(a {LIBRARIES})", "warning"),
        ("set(LIBRARIES m)\nset(OTHERS {LIBRARIES})", "info"),
        ("set(LIBRARIES m)\nset(OTHERS {LIBRARIES})\nadd_executable(a src/a.cpp ${OTHERS})", "warning"),
        ("install(DIRECTORY include DESTINATION include/{PROJECT_NAME})", "warning"),
    ],
)
def test_what_is_lost_with_a_dollar_sign(lines: str, level: str) -> None:
    (text,) = said(package(lines) | HEADER, "CMK126")
    assert text.startswith(f"{level}: ")


PROGRAM = {"src/a.cpp": "int a() {return 1;}\n"}


@pytest.mark.parametrize(("option", "level"), [("", "error"), ("EXCLUDE_FROM_ALL ", "warning")])
def test_a_program_without_main_that_is_built_on_demand(option: str, level: str) -> None:
    (text,) = said(package(f"add_executable(a {option}src/a.cpp)") | PROGRAM, "CMK125")
    assert text.startswith(f"{level}: ")


STARTED = "install(PROGRAMS scripts/hello.py DESTINATION lib/my_pkg)"


RUNS = '<executable cmd="$(var home)/{}"/>'


@pytest.mark.parametrize(
    ("line", "level"),
    [
        (RUNS.format("bye.py"), "warning"),
        (RUNS.format("good_bye.py"), "info"),
        (RUNS.format("bye.pyc"), "info"),
        ("<!-- bye.py -->", "info"),
    ],
)
def test_a_launch_file_that_names_a_script(line: str, level: str) -> None:
    script = "#!/usr/bin/env python3\nprint('hello')\n"
    files = {
        **package(STARTED),
        **dict.fromkeys(("scripts/hello.py", "scripts/bye.py"), script),
        "launch/a.launch.xml": f"<launch>\n  {line}\n</launch>\n",
    }
    (text,) = said(files, "CMK112")
    assert text.startswith(f"{level}: ")


NODE = "def main():\n    print('hello')\n"
STARTS = '<launch>\n  <node pkg="my_pkg" exec="talker"/>\n</launch>\n'


@pytest.mark.parametrize(("started", "level"), [("talker", "warning"), ("tuner", "error"), ("other", "error")])
def test_an_entry_point_of_a_module_that_is_left_out(started: str, level: str) -> None:
    entries = scripts("talker = my_pkg.talker:main", "tuner = my_pkg.more.tuner:main")
    files = {
        "package.xml": manifest(""),
        "setup.py": setup_py(entries).replace("find_packages(exclude=['test'])", "[package_name]"),
        "setup.cfg": SETUP_CFG,
        "launch/a.launch.xml": STARTS.replace("talker", started),
        **dict.fromkeys(("my_pkg/talker.py", "my_pkg/more/tuner.py"), NODE),
        **dict.fromkeys(("my_pkg/__init__.py", "my_pkg/more/__init__.py"), ""),
    }
    (text,) = said(files, "SET105")
    assert text.startswith(f"{level}: ")
    assert text.endswith("; nothing here starts it, as others of the package are") == (level == "warning")
