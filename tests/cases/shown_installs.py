"""What is installed, and what looks as if it were: folders, programs, modules and places that CMake names."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest, scripts, setup_py

MAIN = "int main() {return 0;}\n"
LAUNCH = {"launch/talker.launch.xml": "<launch/>\n"}
HOME = "DESTINATION lib/${PROJECT_NAME}"
NODE = "#!/usr/bin/env python3\nimport rclpy\n\nif __name__ == '__main__':\n    rclpy.init()\n"
NODES = {f"scripts/{name}.py": NODE for name in ("talker", "listener")}
LISTED = {f"launch/{name}.launch.xml": "<launch/>\n" for name in "abc"}
AB = "launch/a.launch.xml launch/b.launch.xml"
FINDER = "find_package(ament_cmake_python REQUIRED)\n"
IMPORTS = "#!/usr/bin/env python3\nfrom my_pkg.words import WORD\n\nprint(WORD)\n"
IN_SRC = {"src/my_pkg/__init__.py": "", "src/my_pkg/words.py": "WORD = 'a'\n"}
SCRIPT = f"install(PROGRAMS scripts/hello.py {HOME})\n"


def package(lines: str, files: dict[str, str] | None = None) -> Example:
    text = CMAKE.replace("ament_package", lines + "ament_package")
    bad = {"CMakeLists.txt": text, "src/a.cpp": MAIN, **(files or {})}
    return Example(bad=bad, good={}, on="ament_cmake")


def examples(more: str) -> Example:
    """Two programs of a folder for examples."""
    made = "".join(f"add_executable({name} src/examples/{name}.cpp)\n" for name in ("talker", "listener"))
    return package(made + more, {f"src/examples/{name}.cpp": MAIN for name in ("talker", "listener")})


def nodes(names: str, registered: str) -> Example:
    """Components, each in a library that a program of its own links."""
    lines = "find_package(rclcpp_components REQUIRED)\n"
    for name in names:
        lines += f"add_library({name} SHARED src/{name}.cpp)\nadd_executable({name}_node src/main.cpp)\n"
        lines += f"target_link_libraries({name}_node PRIVATE {name})\n"
        lines += f"install(TARGETS {name} DESTINATION lib)\ninstall(TARGETS {name}_node {HOME})\n"
    lines += "".join(f'rclcpp_components_register_nodes({name} "my_pkg::{name}")\n' for name in registered)
    sources = {f"src/{name}.cpp": f"RCLCPP_COMPONENTS_REGISTER_NODE(my_pkg::{name})\n" for name in names}
    return package(lines, {**sources, "src/main.cpp": MAIN})


CASES = {
    "CMK101": (
        *(package(f"{before}install(FILES {names} DESTINATION share/${{PROJECT_NAME}}/launch)\n", {**LISTED, **more})
          for before, names, more in (
              ("", AB, {}),
              ("", "launch/a.launch.xml", {}),
              ("", f"{AB} launch/c.launch.xml", {}),
              ("file(GLOB found launch/[ab].launch.xml)\n", "${found}", {}),
              ("", AB, {"README.md": "Run `ros2 launch my_pkg c.launch.xml`.\n"}),
              ("", AB, {"launch/more/d.launch.xml": "<launch/>\n"}),
              ("", AB, {"launch/b.launch.xml": "<!-- c.launch.xml -->\n<launch/>\n"}),
              ("add_custom_target(x DEPENDS launch/c.launch.xml)\n", AB, {}),
          )),
        package("add_custom_target(all_files SOURCES launch/talker.launch.xml)\n", LAUNCH),
        package("add_custom_target(made DEPENDS launch/talker.launch.xml)\n", LAUNCH),
        package("add_link_options(-Wl,-z,defs)\n", LAUNCH),
        package("make_launch_files(all)\n", LAUNCH),
        package("make_launch_files(all)\ninstall(DIRECTORY launch DESTINATION share)\n", LAUNCH),
        package("make_launch_files(all)\ninstall(DIRECTORY launch DESTINATION launch)\n", LAUNCH),
        *(package(f"if(WITH_MORE)\n  install(DIRECTORY launch DESTINATION {place})\nendif()\n", LAUNCH)
          for place in ("share", "other", "share/${PROJECT_NAME}")),
        package("", {"launch/talker.launch": '<launch>\n  <node pkg="my_pkg" exec="talker"/>\n</launch>\n'}),
        package("", {"launch/talker.launch": '<launch>\n  <node pkg="my_pkg" type="talker" name="a"/>\n</launch>\n'}),
        package("find_package(catkin QUIET)\nif(catkin_FOUND)\n  add_message_files(FILES A.msg)\nendif()\n", LAUNCH),
        package("find_package(other QUIET)\nif(other_FOUND)\n  add_message_files(FILES A.msg)\nendif()\n", LAUNCH),
    ),
    "CMK104": (
        *(package(f"install({rule} DESTINATION {place})\n", {**NODES, "more/a.txt": "a\n"})
          for rule, place in (
              ("DIRECTORY scripts more", "share/${PROJECT_NAME}"), ("DIRECTORY scripts/", "bin"),
              ("FILES scripts/talker.py", "bin"), ("DIRECTORY scripts", "share/other"),
              ("FILES scripts/talker.py scripts/words.txt", "share/${PROJECT_NAME}"),
          )),
        package("install(DIRECTORY scripts DESTINATION share/${PROJECT_NAME})\n", {**NODES, "scripts/a.txt": "a\n"}),
        package("install(DIRECTORY scripts DESTINATION share/${PROJECT_NAME})\n",
                {**NODES, "launch/a.launch.py": "CMD = ['python3', 'scripts/talker.py', 'listener.py']\n"}),
        package("install(DIRECTORY scripts DESTINATION share/${PROJECT_NAME})\n",
                {**NODES, "README.md": "ros2 run my_pkg talker.py\n"}),
        package("install(DIRECTORY scripts DESTINATION share/${PROJECT_NAME})\n"
                "install(PROGRAMS scripts/talker.py scripts/listener.py DESTINATION lib/${PROJECT_NAME})\n", NODES),
    ),
    "CMK103": (
        *(
            Example(
                bad={
                    "CMakeLists.txt": CMAKE.replace(
                        "project(my_pkg)", f"extract_package_metadata(pkg)\nproject({name})\n{lines}"
                    ),
                    "src/a.cpp": MAIN,
                },
                good={},
                on="ament_cmake",
            )
            for name in ("${pkg_extracted_name}", "my_pkg")
            for lines in (
                "add_executable(${PROJECT_NAME}_node src/a.cpp)",
                f"add_executable(${{PROJECT_NAME}}_node src/a.cpp)\ninstall(TARGETS ${{PROJECT_NAME}}_node {HOME})",
            )
        ),
        Example(
            bad={
                "CMakeLists.txt": CMAKE.replace("ament_package", "add_executable(my_pkg src/a.cpp)\nament_package"),
                "src/a.cpp": MAIN,
            },
            good={},
            on="ament_cmake",
        ),
        examples(f"install(TARGETS talker {HOME})\n"),
        examples(""),
        package("function(strict name)\n  target_compile_options(${name} PRIVATE -Wall)\nendfunction()\n"
                "add_executable(talker src/a.cpp)\nstrict(talker)\n"),
        package("add_executable(talker src/a.cpp)\nmake_strict(talker)\n"),
        package("function(make name)\n  add_executable(${name} src/a.cpp)\nendfunction()\nmake(talker)\n"),
        package("if(DEFINED ENV{AMENT_PREFIX_PATH})\n  add_executable(talker src/a.cpp)\nendif()\n"),
        package("if(DEFINED ENV{SOMETHING})\n  add_executable(talker src/a.cpp)\nendif()\n"),
    ),
    "CMK108": (
        *(nodes(names, registered) for names, registered in (("abc", "ab"), ("abc", "a"), ("ab", "a"), ("abc", "abc"))),
    ),
    "CMK109": (
        package(SCRIPT, {"scripts/hello.py": IMPORTS, **IN_SRC}),
        package(SCRIPT + FINDER + "ament_python_install_package(my_pkg PACKAGE_DIR src/my_pkg)\n",
                {"scripts/hello.py": IMPORTS, **IN_SRC}),
        package(FINDER, IN_SRC),
        package(f"{FINDER}install(PROGRAMS my_pkg/hello {HOME})\n",
                {"my_pkg/__init__.py": "", "my_pkg/words.py": "WORD = 'a'\n", "my_pkg/hello": "#!/bin/sh\n"}),
        *(package(SCRIPT + "ament_environment_hooks(env/path.dsv.in)\n",
                  {"scripts/hello.py": IMPORTS, **IN_SRC, **more})
          for more in ({"env/path.dsv.in": "prepend-non-duplicate;GZ_SIM_RESOURCE_PATH;share\n"},
                       {"env/path.dsv.in": "prepend-non-duplicate;PYTHONPATH;lib\n"})),
    ),
    "CMK111": (
        *(package(f"if(WITH_MORE)\n  install(FILES LICENSE DESTINATION {place})\nendif()\n", {"LICENSE": "MIT\n"})
          for place in ("/share/${PROJECT_NAME}", "/lib/${PROJECT_NAME}/more", "/opt/${PROJECT_NAME}",
                        "/share/${PROJECT_NAME}s")),
    ),
    "CMK115": (
        *(package(f"find_package({name} REQUIRED)\nset(YAML_CPP_INCLUDE_DIRS ${{YAML_CPP_INCLUDE_DIR}})\n")
          for name in ("yaml-cpp", "acme")),
        *(package(f"set(PACKAGE_DEPENDENCIES rclcpp)\n{lines}") for lines in (
            "foreach(each IN ITEMS ${PAKCAGE_DEPENDENCIES})\n  find_package(${each} REQUIRED)\nendforeach()\n",
            "foreach(each IN ITEMS ${PACKAGE_DEPENDENCIES})\n  find_package(${each} REQUIRED)\nendforeach()\n",
            "if(WITH_MORE)\n  foreach(each ${PAKCAGE_DEPENDENCIES})\n  endforeach()\nendif()\n",
        )),
        *(package(f"if(WITH_MORE)\n  {lines}\nendif()\n") for lines in (
            "install(FILES a.txt DESTINATION share/${PROJECTNAME})",
            "set(WORDS a)\n  install(FILES a.txt DESTINATION share/${WROSD})",
            "message(${PROJECTNAME})",
        )),
    ),
    "DEP109": (
        Example(
            bad={
                "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
                "my_pkg/speech.py": "GREETING = 'hello'\n",
                "my_pkg/listener.py": "def main():\n    from my_pkg.speach import GREETING\n\n    print(GREETING)\n",
                "test/test_words.py": "from my_pkg.wrods import NAME\n",
                "my_pkg/talker.py": "from my_pkg.speach import GREETING\n\n\ndef main():\n    print(GREETING)\n",
                "my_pkg/teller.py": "from my_pkg.speach import GREETING\nfrom my_pkg.speech import NAME, GRETING\n",
            },
            good={},
        ),
    ),
    "DEP106": (
        *(
            Example(
                bad={
                    "urdf/robot.urdf.xacro": '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="robot">\n'
                    f'  <xacro:include filename="$(find {name})/urdf/arm.xacro"/>\n</robot>\n',
                    "package.xml": manifest("  <exec_depend>arm_bringup</exec_depend>\n"),
                },
                good={},
            )
            for name in ("my_pgk", "arm_description")
        ),
    ),
}  # fmt: skip
