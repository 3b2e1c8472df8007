"""Sentences about CMakeLists.txt that no example shows: levels, several places in one finding, and silence."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest
from rospkg_cli.rules.cmake import cmk101_cmake_folder_not_installed as cmk101
from rospkg_cli.rules.cmake import cmk105_script_not_executable as cmk105
from rospkg_cli.rules.cmake import cmk109_missing_python_install as cmk109
from rospkg_cli.rules.cmake import cmk112_script_not_installed as cmk112
from rospkg_cli.rules.cmake import cmk113_missing_export_dependency as cmk113

MAIN = "int main() {return 0;}\n"
SCRIPT = "#!/usr/bin/env python3\nimport rclpy\n\nprint(rclpy.ok())\n"
LAUNCH = "<launch>\n</launch>\n"
OPENS = "share = FindPackageShare('{}')\npath = [share, '/{}/a.yaml']\n"
LIB = "lib/${PROJECT_NAME}"


def cmake(lines: str, body: str = "", files: dict[str, str] | None = None) -> Example:
    """A CMake package with some lines, dependencies and files more."""
    text = CMAKE.replace("ament_package", lines.replace("«", "").replace("»", "") + "ament_package")
    package = {"package.xml": manifest(body, "ament_cmake")} if body else {}
    return Example(bad={"CMakeLists.txt": text, **package, **(files or {})}, good={}, on="ament_cmake")


def with_config(**files: str) -> Example:
    """A package that does not install config/, with files by their names without the dot."""
    named = {name.replace("__", "/").replace("_DOT_", "."): text for name, text in files.items()}
    return cmake("", files={"config/a.yaml": "a: 1\n", **named})


def old(version: str) -> str:
    return f"cmake_minimum_required(VERSION {version})\n"


ATD = "ament_target_dependencies"
TWO = (
    "find_package(rclcpp REQUIRED)\nadd_executable(a src/a.cpp)\nadd_executable(b src/a.cpp)\n"
    f"{ATD}(a rclcpp)\n{ATD}(b rclcpp ${{MORE}})\n{ATD}(b rclcpp)\ninstall(TARGETS a b DESTINATION {LIB})\n"
)
PLUGINS = (
    "add_library(core SHARED src/a.cpp)\nament_export_libraries(core)\n"
    "pluginlib_export_plugin_description_file(b p.xml)\n"
)
INCLUDE = "ament_export_include_directories(include)\n"
TALKER = f"add_executable(talker src/a.cpp)\ninstall(TARGETS talker DESTINATION {LIB})\n"
HEADER = {"include/my_pkg/a.hpp": "#pragma once\n", "src/a.cpp": MAIN}
PATHS = "install(PROGRAMS scripts/go.py DESTINATION share/${PROJECT_NAME}/scripts)\n"
GO = {"scripts/go.py": SCRIPT}
HELLO = {"scripts/hello.py": "print('hello')\n"}
IMPORTS = {**HELLO, "scripts/other.py": "#!/usr/bin/env python3\nfrom hello import main\n"}
BOTH = f"install(PROGRAMS scripts/hello.py scripts/other.py DESTINATION {LIB})\n"
GTEST = "find_package(ament_cmake_gtest REQUIRED)\n"
MORE = cmk113.LINES.replace(" «", " ${nav_msgs_TARGETS} «").replace(
    "find_package(s", "find_package(nav_msgs REQUIRED)\nfind_package(s"
)
NAV = (
    "#pragma once\n#include <nav_msgs/msg/path.hpp>\n#include <rclcpp/rclcpp.hpp>\n#include <std_msgs/msg/string.hpp>\n"
)
NEEDS = "  <depend>nav_msgs</depend>\n  <depend>rclcpp</depend>\n  <depend>std_msgs</depend>\n"
USER = {
    "src/user_pkg/package.xml": manifest("  <build_depend>OTHER</build_depend>\n", "ament_cmake", "user_pkg").replace(
        "OTHER", "my_pkg"
    ),
    "src/user_pkg/CMakeLists.txt": CMAKE.replace("my_pkg", "user_pkg"),
}


def in_workspace(example: Example, build_type: str = "<build_type>ament_cmake", *, is_compiled: bool = True) -> Example:
    """The package below src/, beside one that needs it for its build."""
    files = {"package.xml": manifest("", "ament_cmake"), **example.bad}
    own = {f"src/my_pkg/{path}": text for path, text in files.items()}
    user = {path: text.replace("<build_type>ament_cmake", build_type) for path, text in USER.items()}
    if is_compiled:
        text = user["src/user_pkg/CMakeLists.txt"]
        compiled = text.replace("ament_package", "add_library(user INTERFACE)\nament_package")
        user["src/user_pkg/CMakeLists.txt"] = compiled
    return Example(bad={**own, **user}, good={}, on="")


CASES = {
    "CMK002": (
        cmake(old("3.5")),
        cmake(old("3.5...3.9") + old("3.4") + old("3.5...3.10")),
        cmake(old("3.9")),
        Example(
            bad={"CMakeLists.txt": CMAKE.replace("3.20", "3.5"), "package.xml": manifest("", "catkin")},
            good={},
            on="ament_cmake",
        ),
    ),
    "CMK005": (cmake(TWO, "  <depend>rclcpp</depend>\n", {"src/a.cpp": MAIN}),),
    "CMK101": (
        cmake("", files={"launch/a.launch.xml": LAUNCH}),
        with_config(my_pkg__a_DOT_py=OPENS.format("my_pkg", "config")),
        with_config(my_pkg__a_DOT_py=OPENS.format("your_pkg", "config")),
        with_config(test__a_DOT_py=OPENS.format("my_pkg", "config")),
        with_config(urdf__a_DOT_urdf="<a b='package://my_pkg/config/a.yaml'/>\n"),
        with_config(src__a_DOT_xml="<a b='$(find my_pkg)/config/a.yaml'/>\n"),
        with_config(README_DOT_md="    ros2 run a b --params-file src/my_pkg/config/a.yaml\n"),
        with_config(README_DOT_md="    ros2 run a b --params-file my_pkg/config/a.yaml\n"),
        with_config(README_DOT_md="    ros2 run a b --params-file $(ros2 pkg prefix my_pkg)/config/a.yaml\n"),
        with_config(README_DOT_md="    ros2 launch my_pkg a.launch.py\n"),
        with_config(_DOT_gitignore="config/\n"),
        cmake(cmk101.INSTALL, files={"launch/a.launch.xml": LAUNCH}),
    ),
    "CMK104": (
        cmake(PATHS, files=GO),
        cmake(PATHS, files={**GO, "launch/a.launch.py": "cmd=[share + '/scripts/go.py']\n"}),
        cmake(PATHS, files={**GO, "launch/a.launch.py": "Node(package='my_pkg', executable='go.py')\n"}),
        cmake(PATHS, files={"scripts/go.py": "#!/bin/sh\n"}),
    ),
    "CMK105": (
        cmake(cmk105.PROGRAMS, files={"scripts/hello.py": "import os\n\n\ndef hello():\n    print(os.name)\n"}),
        *(
            cmake(cmk105.FILES, files={"scripts/hello.py": f"{cmk105.SHEBANG}\n\ndef a():\n    pass\n{end}"})
            for end in ("", "\n\nraise OSError\n")
        ),
        cmake(cmk105.PROGRAMS, files={"scripts/hello.py": "def generate_launch_description():\n    ...\n\nprint()\n"}),
        cmake(cmk105.PROGRAMS, files={"scripts/hello.py": "import os\n\nif __name__ == '__main__':\n    os.abort()\n"}),
        cmake(cmk105.PROGRAMS, files={**HELLO, "launch/a.launch.py": "cmd=['python3', share + '/hello.py']\n"}),
        cmake(cmk105.PROGRAMS, files={**HELLO, "launch/a.launch.py": "cmd=['bash', share + '/hello.py']\n"}),
        *(
            cmake(cmk105.PROGRAMS.replace("hello.py", "hello"), files={"scripts/hello": text})
            for text in ("import os\n\nprint(os.name)\n", "import -window root a.png\nprint (a)\n")
        ),
        cmake(BOTH, files=IMPORTS),
        cmake(BOTH, files={**IMPORTS, "scripts/other.py": "#!/usr/bin/env python3\nimport hello_world\n"}),
    ),
    "CMK106": (
        in_workspace(cmake(TALKER + INCLUDE, files=HEADER), "<build_type>ament_python"),
        cmake(TALKER + INCLUDE, files=HEADER),
        in_workspace(cmake(TALKER + INCLUDE, files=HEADER)),
        cmake(f"add_library(core src/a.cpp)\nament_export_libraries(core)\n{INCLUDE}", files=HEADER),
        cmake("add_executable(core src/a.cpp)\nament_export_libraries(core)\n" + INCLUDE, files=HEADER),
        cmake(PLUGINS + INCLUDE, files={**HEADER, "p.xml": "<library/>\n"}),
        in_workspace(cmake(PLUGINS + INCLUDE, files={**HEADER, "p.xml": "<library/>\n"})),
        in_workspace(cmake(PLUGINS + INCLUDE, files={**HEADER, "p.xml": "<library/>\n"}), is_compiled=False),
    ),
    "CMK107": (
        cmake(f"{GTEST}ament_add_gtest(a test/a.cpp)\nament_add_gtest(b test/a.cpp)\n",
              "  <test_depend>ament_cmake_gtest</test_depend>\n", {"test/a.cpp": MAIN}),
        cmake(GTEST, "  <depend>ament_cmake_gtest</depend>\n"),
    ),
    "CMK109": tuple(
        Example(
            bad={
                **cmk109.missing_python_install.examples[0].bad,
                "CMakeLists.txt": cmk109.BAD.replace("«", hook).replace("»", ""),
                "scripts/hello.py": start + cmk109.SCRIPT,
            },
            good={},
            on="ament_cmake",
        )
        for hook, start in (
            ("ament_environment_hooks(env.sh.in)\n", ""),
            ("", "import sys\nsys.path.append('x')\n"),
            ("", "import sys\n"),
        )
    ),
    "CMK110": tuple(
        cmake(f"{line}\n", files={"src/a.cpp": MAIN})
        for line in (
            "target_compile_options(gtest PRIVATE -w)",
            "find_package(fmt)\ntarget_compile_options(fmt INTERFACE -w)",
            "add_dependencies(nothing other)",
            "add_subdirectory(third_party/a)\ntarget_compile_options(a PRIVATE -w)",
        )
    ),
    "CMK111": tuple(
        cmake(f"install(FILES LICENSE DESTINATION {place})\n")
        for place in ("/lib/udev/rules.d", "/usr/lib/systemd/system", "/etcetera", "$ENV{HOME}/a")
    )
    + tuple(
        cmake(f"set(WHERE {value})\ninstall(FILES LICENSE DESTINATION /${{WHERE}}/a)\n")
        for value in ("${CMAKE_INSTALL_PREFIX}/share", "$ENV{PLACE}", "opt")
    )
    + (cmake("unset(CMAKE_INSTALL_PREFIX)\ninstall(FILES LICENSE DESTINATION /${CMAKE_INSTALL_PREFIX}/a)\n"),),
    "CMK112": tuple(
        cmake(cmk112.ONE.partition("find_package(ament_cmake REQUIRED)\n")[2].removesuffix("ament_package()\n"),
              files={"scripts/hello.py": cmk112.SCRIPT, "scripts/bye.py": cmk112.SCRIPT, **more})
        for more in (
            {},
            {"scripts/bye.py": cmk112.SCRIPT + "import rospy\n"},
            {"scripts/bye.py": SCRIPT},
            {"scripts/hello.py": cmk112.SCRIPT + "run('bye.py')\n"},
            {"launch/a.launch.py": "executable='bye.py'\n"},
        )
    ),
    "CMK113": (
        *(
            Example(
                bad={
                    **{path: text.replace("std_msgs", "arm") for path, text in cmk113.FILES.items()},
                    "CMakeLists.txt": cmk113.cmake(
                        cmk113.LINES.replace("«", "").replace("»", "").replace("std_msgs", "arm")
                        .replace("dependencies(rclcpp", f"dependencies(rclcpp {name}")
                    ),
                },
                good={}, on="ament_cmake",
            )
            for name in ("arm_planning", "armature", "nav_msgs")
        ),
        cmake(MORE, NEEDS, {"src/core.cpp": "", "include/my_pkg/core.hpp": NAV}),
        cmake(cmk113.LINES.replace("ament_export_dependencies(rclcpp)\n", ""), NEEDS,
              {"src/core.cpp": "PLUGINLIB_EXPORT_CLASS(my_pkg::A, base::A)\n", "include/my_pkg/core.hpp": NAV}),
        cmake(MORE.replace("ament_export_dependencies(rclcpp)\n", ""), NEEDS,
              {"src/core.cpp": "", "include/my_pkg/core.hpp": NAV}),
    ),
}  # fmt: skip
