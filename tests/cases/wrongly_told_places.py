"""What the user gives (CMK115), what nothing reads (PRM007), and other places told wrongly or too loudly."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest

SET = "set(SENSOR_SDK_LIB m)\n"
CORE = {"src/core.cpp": ""}
READER = """\
#include <rclcpp/rclcpp.hpp>
class Talker : public rclcpp::Node
{{
public:
  Talker() : Node("talker")
  {{
    declare_parameter("rate", 10.0);
    get_parameter("rate", rate_);
    get_parameter("prefix", {});
    {}
  }}
  double rate_;
  std::string prefix_ = "left";  // prefix_ of a joint
}};
"""
IN_PYTHON = """\
import rclpy.node


class Talker(rclpy.node.Node):
    def __init__(self):
        super().__init__('talker')
        self.declare_parameter('rate', 10.0)
        try:
            self.rate = self.get_parameter('rat').value
        except Exception:
            pass
{}"""
CAUGHT = ("", "        print(self.rate)\n", "        print(getattr(self, 'rate'))\n")


def talker(*lines: str) -> Example:
    """A node that gets a parameter which nothing declares."""
    return Example(on="ament_cmake", bad={"include/my_pkg/talker.hpp": READER.format(*lines)}, good={})


SUBFOLDER = "add_library(core ${{SOURCES_OF_A_FILE}} {})"
WITH_SDL = {"src/window.cpp": "#include <ncurses.h>\n"}
BARE = "GREETING = 'hello'\nprint(GREETING)\n"
AMENT = """\
find_package(ament_cmake QUIET)
if(ament_cmake_FOUND)
  install(DIRECTORY params DESTINATION share/${PROJECT_NAME})
  install(DIRECTORY launch/ DESTINATION share/${PROJECT_NAME}/launch FILES_MATCHING PATTERN "*.py")
  install(TARGETS talker DESTINATION lib/${PROJECT_NAME})
endif()
"""
OLD = {"launch/a.launch": "<launch/>\n", "src/talker.cpp": "#include <ros/ros.h>\n"}
BRANCHES = (
    (AMENT, OLD),
    (AMENT, {**OLD, "src/listener.cpp": "#include <rclcpp/rclcpp.hpp>\n"}),
    (AMENT.replace("ament_cmake_FOUND", "TRUE"), OLD),
)
INCLUDES = '<launch><include file="$(find-pkg-share my_pkg)/launch/b.launch.xml"/></launch>\n'
DEFAULT = """\
#include <rclcpp/rclcpp.hpp>
struct Talker : public rclcpp::Node
{{
  Talker() : Node("talker")
  {{
    path = declare_parameter<std::string>({});
  }}
  std::string path;
}};
"""
PATH = '"/home/ada/ws/src/my_pkg/maps/office.csv"'
VALUE = "talker:\n  ros__parameters:\n    {}\n"


def defaults(argument: str, *values: str) -> Example:
    """A node with a default in a home folder, and YAML for it."""
    yaml = {f"config/robot{n}.yaml": VALUE.format(value) for n, value in enumerate(values)}
    files = {"include/my_pkg/talker.hpp": DEFAULT.format(argument), "maps/office.csv": "1\n"}
    return Example(on="ament_cmake", bad={**files, **yaml}, good={})


def package(lines: str, files: dict[str, str] = CORE) -> Example:
    text = CMAKE.replace("ament_package", f"{lines}\nament_package")
    return Example(bad={"CMakeLists.txt": text, **files}, good={}, on="ament_cmake")


CASES = {
    **{code: tuple(package(*each) for each in BRANCHES) for code in ("CMK102", "CMK110", "CMK129")},
    "CMK115": tuple(
        package(SET + lines)
        for lines in (
            "find_library(SDK sdk PATHS ${SENSOR_SDK_DIR}/lib /opt/sdk/lib)",
            "find_path(SDK sdk.h HINTS ${SENSOR_SDK_DIR} PATH_SUFFIXES include)",
            "find_library(SDK sdk ${SENSOR_SDK_DIR}/lib)",
            "find_package(sdk QUIET PATHS ${SENSOR_SDK_DIR})\ninclude_directories(${SENSOR_SDK_DIR})",
            "find_library(SDK NAMES ${SENSOR_SDK_DIR} PATHS /opt/sdk)",
            "include_directories(${SENSOR_SDK_DIR} $ENV{SENSOR_SDK_DIR})",
            "include_directories(${SENSOR_SDK_DIR})\nlink_directories($ENV{SENSOR_SDK_DIR})",
            "include_directories(${SENSOR_SDK_DIR})",
            "find_path(SDK sdk.h PATHS ${CMAKE_SOURCEDIR}/include)",
        )
    ),
    "CMK105": tuple(
        package(
            "install(PROGRAMS scripts/hello.py DESTINATION lib/${PROJECT_NAME})", {"scripts/hello.py": BARE, **more}
        )
        for more in (
            {},
            {"scripts/tool.py": "from hello import GREETING\n"},
            {"other/tool.py": "import hello\n"},
            {"scripts/tool.py": "from hello import GREETING\n", "README.md": "`ros2 run my_pkg hello.py`\n"},
        )
    ),
    "DEP105": tuple(
        package(SUBFOLDER.format(listed), {f"src/{name}.cpp": "int x = 1;\n" for name in "ab"} | WITH_SDL | more)
        for listed, more in (
            ("src/a.cpp src/b.cpp", {}),
            ("src/a.cpp", {}),
            ("src/a.cpp src/b.cpp src/window.cpp", {}),
            ("src/a.cpp src/b.cpp", {"tools/CMakeLists.txt": "file(GLOB TOOLS *.cpp)\n"}),
            ("src/a.cpp src/b.cpp", {"tools/CMakeLists.txt": "add_executable(tool ${name}.cpp)\n"}),
            ("src/a.cpp src/b.cpp src/${name}.cpp", {}),
        )
    ),
    "DEP118": (
        *(defaults(f'"map", {PATH}', *given) for given in ((), ("map: a.csv",), ("map: a.csv", "map: b.csv"))),
        defaults(f'"map", {PATH}', "map: a.csv", "rate: 2.0"),
        defaults(f'"map", {PATH}', "map: a.csv", f"map: {PATH}"),
        defaults(f'"maps", {PATH}', "map: a.csv"),
        defaults(f'\n        "map", std::string({PATH})', "map: a.csv"),
    ),
    "LCH003": tuple(
        Example(bad={"my_pkg/launch/a.launch.xml": INCLUDES, **files}, good={}, on="ament_python")
        for files in (
            {"my_pkg/package.xml": manifest(), "my_pkg/launch/b.launch.xml": "<launch/>\n"},
            {"my_pkg/package.xml": manifest()},
            {"my_pkg/launch/b.launch.xml": "<launch/>\n"},
        )
    ),
    "PRM007": (
        *(talker("prefix_", line) for line in ("", "show(prefix_);", "return prefix_;", "int n = 2 * prefix_;")),
        talker("this->prefix_", 'show("prefix_");'),
        talker("prefix_", "// prefix_ = 1"),
        talker("data.prefix_", ""),
        talker("prefix_", "}\n#define PREFIX prefix_\n  void show() {"),
        talker("left_", ""),
        *(Example(bad={"my_pkg/talker.py": IN_PYTHON.format(line)}, good={}) for line in CAUGHT),
        Example(bad={"my_pkg/talker.py": IN_PYTHON.format("").replace("except Exception", "finally")}, good={}),
    ),
}
