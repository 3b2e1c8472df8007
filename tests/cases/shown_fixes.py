"""What fixes write into files of many layouts: their diffs are in `tests/fixes/`."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, SETUP_CFG, SETUP_PY, Example, manifest
from rospkg_cli.rules.cmake import cmk101_cmake_folder_not_installed as cmk101

from .shown_cmake import HASH, HOME, package
from .shown_interfaces import listed

MAIN = {"src/a.cpp": "int main() {}\n", "src/b.cpp": "int b() {return 1;}\n", "include/my_pkg/b.hpp": "#pragma once\n"}
SHARE = "DESTINATION share/${PROJECT_NAME}"
EXECUTABLE = "add_executable(talker src/a.cpp)"
LIBRARY = "add_library(core SHARED src/b.cpp)"
OTHER = "add_executable(other src/a.cpp)"
RULES = (
    f"install(TARGETS other {HOME})",
    f"install(TARGETS\n  other\n  {HOME}\n)",
    f"install(TARGETS other RUNTIME {HOME})",
    f"install(TARGETS other EXPORT e {HOME})",
    "install(TARGETS other DESTINATION bin)",
    f"if(UNKNOWN)\n  install(TARGETS other {HOME})\nendif()",
    f"foreach(each other)\n  install(TARGETS ${{each}} {HOME})\nendforeach()",
    f"set(all other)\ninstall(TARGETS ${{all}} {HOME})",
    f'install(TARGETS "other" {HOME})  # why',
    f"install(FILES LICENSE {SHARE})",
    f"INSTALL(TARGETS other {HOME})",
    f"if(BUILD_TESTING)\n  install(TARGETS other {HOME})\nendif()",
    "",
)
LIBRARIES = (
    "install(TARGETS base DESTINATION lib)",
    "install(TARGETS base\n  LIBRARY DESTINATION lib\n)",
    "install(TARGETS base EXPORT e LIBRARY DESTINATION lib)\nament_export_targets(e)",
    "install(TARGETS base other DESTINATION lib)",
    "",
)
BASE = "add_library(base SHARED src/b.cpp)"
EXPORTS = (
    "ament_export_libraries(core)",
    "ament_export_targets(e)",
    "ament_export_dependencies(x)\nament_export_libraries(core)",
)
FILES = {"config/a.yaml": "a: 1\n", "config/b.yaml": "a: 1\n"}
NAMED = (
    f"install(FILES config/a.yaml {SHARE}/config)",
    f"install(FILES config/a.yaml {SHARE})",
    f"install(FILES config/a.yaml {SHARE}/config RENAME c.yaml)",
    f"install(FILES\n  config/a.yaml\n  {SHARE}/config\n)",
    f"install(FILES ${{FILES}} {SHARE}/config)",
    f"install(PROGRAMS config/a.yaml {SHARE}/config)",
    f"set(here config/a.yaml)\ninstall(FILES ${{here}} {SHARE}/config)",
)
INCLUDES = '<launch>\n  <include file="$(find-pkg-share my_pkg)/config/b.yaml"/>\n</launch>\n'
SCRIPTS = {"scripts/a.py": HASH, "scripts/b.py": HASH + "import rclpy\n", "scripts/c.py": HASH}
PROGRAMS = (
    f"install(PROGRAMS scripts/a.py {HOME})",
    f"install(PROGRAMS\n  scripts/a.py\n  scripts/c.py\n  {HOME}\n)",
    f"install(PROGRAMS scripts/a.py {HOME} RENAME x)",
    f"INSTALL(PROGRAMS scripts/a.py scripts/c.py {HOME})",
    f"install(PROGRAMS scripts/a.py scripts/c.py\n  {HOME})\nadd_custom_target(x)\nmessage(x)",
)
WRONG = (
    "install(TARGETS talker DESTINATION bin)",
    "install(TARGETS talker other DESTINATION bin)",
    "install(TARGETS talker\n  RUNTIME DESTINATION bin\n  LIBRARY DESTINATION lib\n)",
    "install(TARGETS\n  core\n  talker\n  RUNTIME DESTINATION bin\n  LIBRARY DESTINATION lib\n)",
    "install(TARGETS core talker DESTINATION lib)",
    "set(WHERE bin)\ninstall(TARGETS talker DESTINATION ${WHERE})",
    "install(TARGETS talker other\n  RUNTIME DESTINATION bin\n  ARCHIVE DESTINATION bin)",
    "install(PROGRAMS scripts/b.py scripts/c.py DESTINATION share/${PROJECT_NAME})",
)
ENDS = (
    "ament_package()\n",
    "ament_package()",
    "# the end\nament_package()\n",
    "if(BUILD_TESTING)\nendif()\n\nament_package()\n",
    "AMENT_PACKAGE()\n",
    "ament_auto_package()\n",
    "ament_auto_package(\n  INSTALL_TO_SHARE\n    launch\n)\n",
    "ament_auto_package(INSTALL_TO_SHARE launch USE_SCOPED_HEADER_INSTALL_DIR)\n",
    "ament_auto_package(X)\n",
)
LISTS = (
    listed("msg/Status.msg", "srv/SetMode.srv"),
    listed("srv/SetMode.srv", "msg/Status.msg"),
    listed("msg/Status.msg"),
    listed("msg/Zone.msg", "msg/Status.msg"),
    listed("msg/Status.msg").replace('"', ""),
    listed("msg/Status.msg").replace('\n  "msg/Status.msg"\n', ' "msg/Status.msg"'),
    listed("${files}", before='set(files\n  "msg/Status.msg"\n)\n'),
    listed("${files}", before="set(files msg/Status.msg)\n"),
    listed("msg/Status.msg", more="  DEPENDENCIES builtin_interfaces\n"),
    listed("msg/Status.msg", more="  DEPENDENCIES std_msgs\n"),
    listed("msg/Status.msg", more="  DEPENDENCIES std_msgs builtin_interfaces\n  ADD_LINTER_TESTS\n"),
)
DATA = "    data_files=[\n        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),\n"
DATA += "        ('share/' + package_name, ['package.xml']),\n    ],\n"
MARKER = "('share/ament_index/resource_index/packages', ['resource/' + package_name]),"
LAUNCHED = "        ('share/my_pkg/launch', ['launch/a.launch.xml']),\n"
ENTRIES = (
    "('share/my_pkg/config', ['config/a.yaml'])", "('share/my_pkg/other', ['config/a.yaml'])",
    "('share/' + package_name + '/config', ['config/a.yaml', ])", "('share/my_pkg/config', glob('config/a.*'))",
)  # fmt: skip
LAYOUTS = (
    DATA,
    "    data_files=[('share/' + package_name, ['package.xml'])],\n",
    "    data_files=[\n        ('share/' + package_name, ['package.xml'])\n    ],\n",
    "    data_files=[('share/my_pkg', ['package.xml']),],\n",
    "    data_files=[],\n",
    "    data_files=files,\n",
    "    data_files=files + [('share/my_pkg', ['package.xml'])],\n",
    "    data_files=[\n        (os.path.join('share', package_name), ['package.xml']),  # why\n    ],\n",
    '    data_files=[("share/my_pkg", ["package.xml"]), ("share/my_pkg/launch", ["launch/a.launch.py"])],\n',
    "    data_files=(('share/my_pkg', ['package.xml']),),\n",
    "",
)
HEADS = (
    "from setuptools import find_packages, setup\n",
    "import os\nfrom glob import glob\n\nfrom setuptools import setup, find_packages\n",
    "import glob\nimport setuptools\nfrom setuptools import setup, find_packages\n",
    '"""Docs."""\nfrom setuptools import *\n',
    "glob = 5\nfrom setuptools import find_packages, setup\n",
    "import os\nimport sys\n\nimport numpy\nfrom setuptools import find_packages, setup\n",
)
OLD_HEAD = "from setuptools import find_packages, setup\n"


def python(data: str = DATA, head: str = OLD_HEAD, **more: str) -> Example:
    """A package whose setup.py has another list of data_files, or other imports."""
    known = "files = []\n" if "=files" in data else ""
    text = SETUP_PY.replace(DATA, data).replace(OLD_HEAD, head + known)
    named = {name.replace("__", "/").replace("_DOT_", "."): each for name, each in more.items()}
    return Example(bad={"setup.py": text, "setup.cfg": SETUP_CFG, **named}, good={})


def ended(end: str) -> Example:
    return Example(
        bad={"CMakeLists.txt": CMAKE.replace("ament_package()\n", end), "config/a.yaml": "a: 1\n"},
        good={},
        on="ament_cmake",
    )


def depends(*lines: str) -> Example:
    """A manifest with dependencies in some layout, and an import, a test and a message that it lacks."""
    body = "".join(f"{line}\n" for line in lines)
    files = {"my_pkg/a.py": "import std_msgs.msg\n", "test/test_a.py": "import pytest\n"}
    return Example(bad={"package.xml": manifest(body), **files}, good={})


BODIES = (
    (),
    ("  <depend>rclpy</depend>",),
    ("  <exec_depend>rclpy</exec_depend>", "  <exec_depend>tf2_ros</exec_depend>"),
    ("  <exec_depend>tf2_ros</exec_depend>", "  <exec_depend>rclpy</exec_depend>"),
    ("\t<exec_depend>rclpy</exec_depend>",),
    ("  <exec_depend>rclpy</exec_depend>  <!-- why -->", "", "  <test_depend>ament_copyright</test_depend>"),
    (
        "  <!-- run -->",
        "  <exec_depend>rclpy</exec_depend>",
        "",
        "  <!-- test -->",
        "  <test_depend>ament_pep257</test_depend>",
    ),
    ("  <buildtool_depend>x</buildtool_depend>", "", "  <test_depend>ament_copyright</test_depend>"),
    ("  <exec_depend>a</exec_depend> <exec_depend>rclpy</exec_depend>",),
    ("    <depend>a</depend>", "    <exec_depend>z</exec_depend>"),
)

CASES = {
    "CMK101": (
        *(ended(end) for end in ENDS),
        *(package(each, cmk101.INSTALL.replace("«", "").replace("»", ""), files={"config/a.yaml": "a: 1\n"})
          for each in ("", "message(x)")),
    ),
    "CMK103": (
        *(package(OTHER, rule, EXECUTABLE, files=MAIN) for rule in RULES),
        *(package(OTHER, EXECUTABLE, rule, files=MAIN) for rule in RULES),
        *(package(OTHER, BASE, LIBRARY, rule, EXPORTS[0], files=MAIN) for rule in LIBRARIES),
        package(BASE, LIBRARY, "target_link_libraries(base PUBLIC core)", LIBRARIES[2], files=MAIN),
        package("if(UNKNOWN)\n  add_executable(talker src/a.cpp)\nendif()", OTHER, RULES[0], files=MAIN),
        package("set(name ${PROJECT_NAME}_talker)\nadd_executable(${name} src/a.cpp)", files=MAIN),
        package("add_executable(${PROJECT_NAME}_talker src/a.cpp)", OTHER, RULES[1], files=MAIN),
        package("function(make name)\n  add_executable(${name} src/a.cpp)\nendfunction()\nmake(talker)", files=MAIN),
    ),
    "CMK104": tuple(package(EXECUTABLE, OTHER, LIBRARY, each, files={**MAIN, **SCRIPTS}) for each in WRONG),
    "CMK106": (
        *(package(LIBRARY, each, files=MAIN) for each in EXPORTS),
        package(LIBRARY, "target_include_directories(core PUBLIC $<INSTALL_INTERFACE:include/my_pkg>)",
                EXPORTS[0], files=MAIN),
        package(LIBRARY, "target_include_directories(core PUBLIC $<INSTALL_INTERFACE:include>)",
                EXPORTS[0], files=MAIN),
        package("ament_export_include_directories(include/${PROJECT_NAME})", files=MAIN),
    ),
    "CMK112": tuple(package(each, files=SCRIPTS) for each in PROGRAMS),
    "DEP101": tuple(depends(*each) for each in BODIES),
    "DEP102": tuple(depends(*each) for each in BODIES),
    "IDL005": tuple(
        Example(bad={"CMakeLists.txt": text, "msg/Other.msg": "int32 a\n", "msg/Zone.msg": "int32 a\n",
                "action/Go.action": "---\n---\n"},
                good={}, on="interfaces")
        for text in LISTS
    ),
    "IDL007": tuple(
        Example(bad={"CMakeLists.txt": text, "msg/Status.msg": "geometry_msgs/Pose pose\nstd_msgs/Header header\n",
                     "msg/Zone.msg": "int32 a\n"}, good={}, on="interfaces")
        for text in LISTS
    ),
    "LCH004": (
        *(package(each, f"install(DIRECTORY launch {SHARE})",
                  files={**FILES, "launch/a.launch.xml": INCLUDES}) for each in NAMED),
        *(python(DATA.replace("    ],", f"        {each},\n{LAUNCHED}    ],"), launch__a_DOT_launch_DOT_xml=INCLUDES,
                 config__a_DOT_yaml="a: 1\n", config__b_DOT_yaml="a: 1\n") for each in ENTRIES),
    ),
    "SET202": tuple(python(each.replace(MARKER, "")) for each in LAYOUTS),
    "SET203": tuple(python(each.replace("['package.xml']", "['LICENSE']")) for each in LAYOUTS),
    "SET206": (
        *(python(each, config__a_DOT_yaml="a: 1\n", launch__b_DOT_launch_DOT_py="") for each in LAYOUTS),
        *(python(DATA, each, config__a_DOT_yaml="a: 1\n") for each in HEADS),
        python(DATA.replace("'", '"'), OLD_HEAD.replace("'", '"') + 'a = "b"\nc = "d"\ne = "f"\n',
               maps__a_DOT_yaml="a: 1\n"),
    ),
}  # fmt: skip
