"""What CMake installs where, and what other packages may know of it."""

# ruff: noqa: E501  (a case a line)

from __future__ import annotations

import pytest
from cmaking import read_files, table, unknown

from rospkg_cli.example import BACKDROPS, manifest
from rospkg_cli.files import PackageFiles
from rospkg_cli.package.cmake.cmake_install_table import cmake_table
from rospkg_cli.package.collect_facts import collect_facts
from rospkg_cli.package.install_table import InstallTable
from rospkg_cli.package.package import Package
from rospkg_cli.package.package_facts import PackageFacts
from rospkg_cli.ros.distros import Targets
from rospkg_cli.tree import MemoryTree

FILES = {
    "launch/a.launch.py": "",
    "launch/sub/b.launch.py": "",
    "launch/sub/__pycache__/b.pyc": "",
    "config/a.yaml": "",
    "config/README.md": "",
    "scripts/run.py": "#!/usr/bin/env python3\n",
    "include/my_pkg/a.hpp": "",
    "my_pkg/__init__.py": "",
    "my_pkg/sub/tool.py": "",
    "plugins/p.xml": "",
    "src/a.cpp": "",
}


def installs(text: str) -> dict[str, str]:
    """Return destination → source of a package with FILES."""
    found = table({**FILES, "CMakeLists.txt": f"project(my_pkg)\n{text}\nament_package()\n"})
    assert found.pop("share/my_pkg/package.xml") == "package.xml"
    return found


@pytest.mark.parametrize(
    "text, destinations",
    [
        ("install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})", "share/my_pkg/launch/a.launch.py share/my_pkg/launch/sub/__pycache__/b.pyc share/my_pkg/launch/sub/b.launch.py"),
        ("install(DIRECTORY launch/ DESTINATION share/${PROJECT_NAME})", "share/my_pkg/a.launch.py share/my_pkg/sub/__pycache__/b.pyc share/my_pkg/sub/b.launch.py"),
        ("install(DIRECTORY launch config DESTINATION share/${PROJECT_NAME}/ PATTERN __pycache__ EXCLUDE PATTERN *.md EXCLUDE)", "share/my_pkg/config/a.yaml share/my_pkg/launch/a.launch.py share/my_pkg/launch/sub/b.launch.py"),
        ("install(DIRECTORY . DESTINATION share/my_pkg FILES_MATCHING PATTERN \"*.yaml\")", "share/my_pkg/config/a.yaml"),
        ("install(DIRECTORY launch DESTINATION share/my_pkg FILES_MATCHING REGEX \".*/sub/.*py$\")", "share/my_pkg/launch/sub/b.launch.py"),
        ("install(FILES config/a.yaml DESTINATION /${CMAKE_INSTALL_PREFIX}/share/my_pkg)", "share/my_pkg/a.yaml"),
        ("install(FILES config/a.yaml DESTINATION share/${PROJECT_NAME}/config RENAME b.yaml)", "share/my_pkg/config/b.yaml"),
        ("install(FILES config/nothing.yaml DESTINATION share/${PROJECT_NAME})", ""),
        ("install(FILES ../a.yaml /opt/b.yaml config/none.yaml DESTINATION share/my_pkg)", "share/my_pkg/a.yaml share/my_pkg/b.yaml"),
        ("install(FILES $ENV{PLACE}/a.yaml DESTINATION share/my_pkg)", ""),
        ("install(FILES ../a.yaml DESTINATION share/my_pkg RENAME c.yaml)", "share/my_pkg/c.yaml"),
        ("install(PROGRAMS scripts/run.py DESTINATION ${CMAKE_INSTALL_PREFIX}/lib/${PROJECT_NAME} RENAME run)", "lib/my_pkg/run"),
        ("file(GLOB y config/*.yaml)\ninstall(FILES ${y} TYPE DATA)", "share/a.yaml"),
        ("add_executable(talker src/a.cpp)\ninstall(TARGETS talker DESTINATION lib/${PROJECT_NAME})", "lib/my_pkg/talker"),
        ("add_executable(talker src/a.cpp)\nset_target_properties(talker PROPERTIES OUTPUT_NAME node)\ninstall(TARGETS talker RUNTIME DESTINATION lib/${PROJECT_NAME})", "lib/my_pkg/node"),
        ("add_executable(talker src/a.cpp)\nset_target_properties(talker PROPERTIES OUTPUT_NAME other RUNTIME_OUTPUT_NAME node LIBRARY_OUTPUT_NAME third)\ninstall(TARGETS talker RUNTIME DESTINATION lib/${PROJECT_NAME})", "lib/my_pkg/node"),
        ("add_library(l SHARED src/a.cpp)\nset_property(TARGET l PROPERTY LIBRARY_OUTPUT_NAME m)\nset_property(TARGET k PROPERTY LIBRARY_OUTPUT_NAME m)\ninstall(TARGETS l)", "lib/libm.so"),
        ("add_library(l SHARED src/a.cpp)\nadd_library(i INTERFACE)\ninstall(TARGETS l i EXPORT e ARCHIVE DESTINATION a LIBRARY DESTINATION b RUNTIME DESTINATION c INCLUDES DESTINATION d)", "b/libl.so"),
        ("add_library(l STATIC src/a.cpp)\ninstall(TARGETS l)", "lib/libl.a"),
        ("add_library(l MODULE src/a.cpp)\ninstall(TARGETS l)", "lib/libl.so"),
        ("add_library(l SHARED src/a.cpp)\nset_target_properties(l PROPERTIES PREFIX \"\" SUFFIX .x)\ninstall(TARGETS l)", "lib/l.x"),
        ("pybind11_add_module(_m src/a.cpp)\ninstall(TARGETS _m DESTINATION ${PYTHON_INSTALL_DIR}/my_pkg)", "lib/python/my_pkg/_m.so"),
        ("ament_auto_add_library(l SHARED src/a.cpp)\nament_auto_add_executable(n src/a.cpp)\nament_auto_package(INSTALL_TO_SHARE config)", "include/my_pkg/a.hpp lib/libl.so lib/my_pkg/n share/my_pkg/config/README.md share/my_pkg/config/a.yaml"),
        ("ament_python_install_package(${PROJECT_NAME})", "lib/python/my_pkg/__init__.py lib/python/my_pkg/sub/tool.py"),
        ("ament_python_install_package(other PACKAGE_DIR my_pkg)", "lib/python/other/__init__.py lib/python/other/sub/tool.py"),
        ("add_library(c SHARED src/a.cpp)\nrclcpp_components_register_node(c PLUGIN \"n::C\" EXECUTABLE c_node)", "lib/my_pkg/c_node"),
        ("pluginlib_export_plugin_description_file(base plugins/p.xml)", "share/my_pkg/plugins/p.xml"),
        ("rosidl_generate_interfaces(${PROJECT_NAME} msg/A.msg DEPENDENCIES std_msgs)", "share/my_pkg/msg/A.msg"),
        ("generate_parameter_library(params config/a.yaml)", "include/my_pkg/params.hpp"),
        ("generate_parameter_library(params config/a.yaml include/my_pkg/a.hpp)", "include/my_pkg/a.hpp include/my_pkg/params.hpp"),
        ("ament_generate_version_header(l)", "include/my_pkg/my_pkg/version.h"),
        ("ament_generate_version_header(l HEADER_PATH v.hpp INSTALL_PATH include)\nament_generate_version_header(m SKIP_INSTALL)", "include/v.hpp"),
        ("ament_package(CONFIG_EXTRAS cmake/a.cmake cmake/b-extras.cmake.in)", "share/my_pkg/cmake/a.cmake share/my_pkg/cmake/b-extras.cmake"),
        ("list(APPEND ${PROJECT_NAME}_CONFIG_EXTRAS a.cmake)", "share/my_pkg/cmake/a.cmake"),
        ("ament_auto_package(USE_SCOPED_HEADER_INSTALL_DIR)", "include/my_pkg/my_pkg/a.hpp"),
        ("ament_get_python_install_dir(d)\ninstall(FILES my_pkg/sub/tool.py DESTINATION ${d}/x)", "lib/python/x/tool.py"),
        ("if(BUILD_TESTING)\ninstall(FILES config/a.yaml DESTINATION share/my_pkg/test)\nendif()", "share/my_pkg/test/a.yaml"),
        ("function(put)\ninstall(DIRECTORY ${ARGN} DESTINATION share/${PROJECT_NAME})\nendfunction()\nput(config)", "share/my_pkg/config/README.md share/my_pkg/config/a.yaml"),
    ],
)  # fmt: skip
def test_the_install_table(text: str, destinations: str) -> None:
    found = installs(text)
    assert " ".join(sorted(found)) == destinations
    assert all(
        not source or source in FILES or source.startswith(("msg/", "a.", "cmake/")) for source in found.values()
    )


@pytest.mark.parametrize(
    "text, whats",
    [
        ("install(FILES config/a.yaml DESTINATION ${unheard})", "executable header library module other share"),
        ("install(FILES ${unheard} DESTINATION share/my_pkg)", "share"),
        ("install(TARGETS ${unheard} DESTINATION lib/my_pkg)", ""),  # set nowhere: it is empty
        ("get_property(later GLOBAL PROPERTY p)\ninstall(TARGETS ${later} DESTINATION lib/my_pkg)", "executable"),
        ("install(CODE \"do()\")", "executable header library module other share"),
        ("someones_install_macro(config)", "executable share"),
        ("ExternalProject_Add(x URL y)", "executable share"),
        ("FetchContent_MakeAvailable(x)", ""),
        ("acme_generate_schema_headers(config)\ntest_big_endian(BIG)", ""),
        ("install(FILES ${CMAKE_CURRENT_BINARY_DIR}/gen.yaml DESTINATION share/my_pkg)", ""),
        ("install(DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/gen DESTINATION share/my_pkg)", "share"),
        ("someones_other_macro(config)", "executable share"),
        ("someones_other_macro()", "executable share"),
        ("add_executable(a a.cpp)\nsomeones_other_macro(config)", "share"),
        ("add_executable(a a.cpp)\nsomeones_other_macro()", "share"),
        ("someones_warning_flags()", ""),
    ],
)  # fmt: skip
def test_what_can_not_be_told(text: str, whats: str) -> None:
    assert " ".join(sorted(unknown({**FILES, "CMakeLists.txt": f"project(my_pkg)\n{text}\n"}))) == whats


ENTRIES = "[options.entry_points]\nconsole_scripts =\n    talker = my_pkg.talker:main\n"


@pytest.mark.parametrize(
    "arguments, executables",
    [
        ("SCRIPTS_DESTINATION lib/my_pkg", "lib/my_pkg/talker"),
        ("", ""),
        ("SCRIPTS_DESTINATION ${unheard}", "?"),
        ("SETUP_CFG other.cfg SCRIPTS_DESTINATION lib/my_pkg", "?"),
    ],
)
def test_entry_points_of_a_python_package_that_cmake_installs(arguments: str, executables: str) -> None:
    text = f"project(my_pkg)\nament_python_install_package(my_pkg {arguments})\n"
    files = {**FILES, "CMakeLists.txt": text, "setup.cfg": ENTRIES, "package.xml": manifest(build_type="ament_cmake")}
    (found,) = Package(PackageFiles(MemoryTree.of(files))).parts(InstallTable).good
    told = " ".join(row.destination for row in found.of("executable"))
    assert (told if found.knows("executable") else "?") == executables


def facts(files: dict[str, str]) -> PackageFacts:
    return collect_facts(Package(PackageFiles(MemoryTree.of(files))), Targets(), "", "my_pkg")


def test_what_other_packages_know() -> None:
    text = """project(my_pkg)
add_library(c SHARED src/a.cpp)
rclcpp_components_register_nodes(c "n::A" n::B)
add_executable(talker src/a.cpp)
install(TARGETS c DESTINATION lib)
install(TARGETS talker DESTINATION lib/${PROJECT_NAME})
install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})
ament_python_install_package(${PROJECT_NAME})
pybind11_add_module(_m src/a.cpp)
install(TARGETS _m DESTINATION ${PYTHON_INSTALL_DIR}/my_pkg)
ament_package()
"""
    found = facts({**FILES, "package.xml": manifest(build_type="ament_cmake"), "CMakeLists.txt": text})
    assert found.executables == {"talker"}
    assert found.components == {"n::A", "n::B"}
    assert found.modules == {"my_pkg", "my_pkg.sub.tool", "my_pkg._m"}
    assert "launch/a.launch.py" in found.share_files
    assert not found.unknown


def test_nothing_is_known_of_what_can_not_be_read() -> None:
    found = facts({**FILES, "package.xml": manifest(build_type="ament_cmake"), "CMakeLists.txt": "project("})
    assert found.unknown >= {"executables", "share_files", "components", "modules"}


def test_a_generated_file_is_known_by_its_name() -> None:
    found = installs("install(FILES ${CMAKE_CURRENT_BINARY_DIR}/a.yaml DESTINATION share/${PROJECT_NAME})")
    assert found == {"share/my_pkg/a.yaml": ""}


def test_the_faultless_package() -> None:
    assert facts({k: v for k, v in BACKDROPS["ament_cmake"].items() if v is not None}).share_files == {"package.xml"}


SCRIPTS = """[options]
scripts = scripts/run.py
[options.entry_points]
console_scripts =
    spawn = my_pkg.sub.tool:main
    broken
other = plugin = my_pkg:other
"""


def test_the_scripts_of_a_setup_cfg_are_executables() -> None:
    text = "project(my_pkg)\nament_python_install_package(${PROJECT_NAME} SCRIPTS_DESTINATION lib/${PROJECT_NAME})\n"
    found = facts({**FILES, "package.xml": manifest(build_type="ament_cmake"), "CMakeLists.txt": text,
                   "setup.cfg": SCRIPTS})  # fmt: skip
    assert found.executables == {"spawn", "run.py"}
    assert found.knows("executables")


def test_without_a_destination_setup_cfg_makes_no_scripts() -> None:
    assert "lib/my_pkg/spawn" not in table(
        {**FILES, "setup.cfg": SCRIPTS, "CMakeLists.txt": "project(my_pkg)\nament_python_install_package(my_pkg)\n"}
    )


def test_another_setup_cfg_may_be_named() -> None:
    text = "ament_python_install_package(my_pkg SETUP_CFG python/my.cfg SCRIPTS_DESTINATION libexec)"
    found = table({**FILES, "python/my.cfg": SCRIPTS, "CMakeLists.txt": f"project(my_pkg)\n{text}\n"})
    assert {path: source for path, source in found.items() if path.startswith("libexec")} == {
        "libexec/spawn": "", "libexec/run.py": "python/scripts/run.py",
    }  # fmt: skip


@pytest.mark.parametrize("text", ["SETUP_CFG ${unheard}", "SETUP_CFG broken.cfg"])
def test_scripts_of_a_setup_cfg_that_can_not_be_read_are_unknown(text: str) -> None:
    text = f"project(my_pkg)\nament_python_install_package(my_pkg {text} SCRIPTS_DESTINATION lib/my_pkg)\n"
    assert unknown({**FILES, "broken.cfg": "a = b", "CMakeLists.txt": text}) == {"executable"}


def certain(text: str) -> dict[str, bool]:
    files = {**FILES, "CMakeLists.txt": f"project(my_pkg)\n{text}\n"}
    return {row.destination: not row.maybe for row in cmake_table(read_files(files), "my_pkg").rows}


@pytest.mark.parametrize(
    "text, sure",
    [
        ("if(x_FOUND)\ninstall(FILES config/a.yaml DESTINATION .)\nendif()", {"a.yaml": False}),
        ("if(x_FOUND)\nlist(APPEND f config/a.yaml)\nendif()\ninstall(FILES ${f} DESTINATION .)", {"a.yaml": False}),
        ("if(x_FOUND)\nadd_library(l a.cpp)\nendif()\ninstall(TARGETS l)", {"lib/libl.so": False}),
        ("if(x_FOUND)\nament_package(CONFIG_EXTRAS a.cmake)\nendif()", {"share/my_pkg/package.xml": False, "share/my_pkg/cmake/a.cmake": False}),
        ("install(FILES config/a.yaml DESTINATION .)", {"a.yaml": True}),
    ],
)  # fmt: skip
def test_rows_under_an_unknown_condition_are_not_certain(text: str, sure: dict[str, bool]) -> None:
    assert certain(text) == sure
