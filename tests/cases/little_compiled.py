"""What nobody compiles, links or opens today: packages without targets, libraries that a program does without."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest

INSTALL = "install(DIRECTORY include/ DESTINATION include)\n"
INCLUDE = '#include "my_pkg/{}"\n'
HEADERS = {
    "include/my_pkg/core.hpp": INCLUDE.format("core_types.h") + INCLUDE.format("cor.hpp"),
    "include/my_pkg/types.hpp": "int types();\n",
}
PUBLIC = {
    "include/my_pkg/words.hpp": "#include <std_msgs/msg/string.hpp>\n",
    "src/talker.cpp": "int main() {return 0;}\n",
}
TOOL = "install(PROGRAMS scripts/tool.py DESTINATION lib/${PROJECT_NAME})\n"
MATRICES = {"src/talker.cpp": "#include <Eigen/Dense>\nint main() {return 0;}\n"}
LAUNCH = {"launch/a.launch.xml": "<launch/>\n"}
UNKNOWN = {
    "src/talker.cpp": INCLUDE.format("lost.hpp") + "int main() {return 0;}\n",
    "src/spare.cpp": INCLUDE.format("gone.hpp"),
    "include/my_pkg/core.hpp": INCLUDE.format("no.hpp"),
}
BESIDE = {"src/talker.cpp": '#include "words.hpp"\nint main() {return 0;}\n', "src/words.hpp": '#include "word.hpp"\n'}
PROGRAM = """\
add_executable(talker src/talker.cpp{})
target_include_directories(talker PRIVATE include)
install(TARGETS talker DESTINATION lib/${{PROJECT_NAME}})
"""
LINKED = """\
include_directories(include)
add_library(core SHARED src/core.cpp)
add_executable(talker src/talker.cpp{})
target_link_libraries(talker core)
install(TARGETS talker DESTINATION lib/${{PROJECT_NAME}})
"""
CORE = {
    "src/core.cpp": INCLUDE.format("core.hpp") + "int core() {return 1;}\n",
    "src/talker.cpp": INCLUDE.format("core.hpp") + "int main() {return core();}\n",
    "include/my_pkg/core.hpp": "int core();\n",
}
FOUND = "find_package(std_msgs REQUIRED)\n"
USING = {"src/talker.cpp": "#include <std_msgs/msg/string.hpp>\nint main() {return 0;}\n"}
ROBOT = '<robot name="robot"><link name="base"/></robot>\n'
LONE = CORE | {"src/talker.cpp": "int main() {return 0;}\n"}

SWITCH = "set(WITH_ARM OFF)\nif({})\n  add_executable(talker src/arm.cpp)\nendif()\n"


def package(lines: str, files: dict[str, str], body: str = "") -> Example:
    text = CMAKE.replace("ament_package", lines + "ament_package")
    files = {"package.xml": manifest(body, "ament_cmake"), "CMakeLists.txt": text, **files}
    return Example(bad=files, good={}, on="ament_cmake")


def beside(files: dict[str, str], lines: str = "", tag: str = "exec_depend") -> Example:
    """A package that another one depends on."""
    user = manifest(f"  <{tag}>my_pkg</{tag}>\n", "ament_cmake").replace("<name>my_pkg", "<name>user")
    own = {f"my_pkg/{path}": text for path, text in package(lines, files).bad_files().items()}
    beside = {
        "user/package.xml": user,
        "user/CMakeLists.txt": CMAKE.replace("(my_pkg)", "(user)"),
        "user/launch/a.launch.xml": "<launch/>\n",
    }
    return Example(bad={**own, **beside}, good={}, on="")


CASES = {
    "CMK102": (
        package("if(WIN32)\n  add_executable(talker src/windows.cpp)\nendif()\n", {}),
        package("if(APPLE OR WITH_MORE)\n  add_executable(talker src/mac.cpp)\nendif()\n", {}),
        package("if(WIN32)\nelse()\n  add_executable(talker src/unix.cpp)\nendif()\n", {}),
        package("if(WITH_MORE)\n  add_executable(talker src/more.cpp)\nendif()\n", {}),
        *(package(SWITCH.format(asked), {}) for asked in ("0", "FALSE", "WITH_ARM", "TRUE AND WITH_ARM", "1")),
        package(SWITCH.format("WITH_ARM").replace(" OFF)", ' OFF CACHE BOOL "")'), {"README.md": "-DWITH_ARM=ON\n"}),
    ),
    "CMK103": (
        package(LINKED.format(""), CORE),
        package(LINKED.format(" src/core.cpp"), CORE),
        package(LINKED.format(""), LONE),
        package(LINKED.format("").replace("src/core.cpp", "src/core.cpp ${MORE}"), LONE),
        package(LINKED.format("") + "ament_export_libraries(core)\n", LONE),
    ),
    "CMK101": (
        beside({"rviz/robot.rviz": "Panels: []\n"}),
        beside({"rviz/robot.rviz": "Panels: []\n", "rviz/robot.urdf": ROBOT}),
    ),
    "CMK121": tuple(
        package(FOUND + PROGRAM.format(""), USING | {"README.md": f"For {names}.\n"}, "  <depend>std_msgs</depend>\n")
        for names in ("Foxy", "Foxy and Humble", "Humble")
    ),
    "CMK105": (
        package(TOOL, {"scripts/tool.py": "print('hello')\n"}),
        package(TOOL, {"scripts/tool.py": "print('hello')\n", "README.md": "Run `ros2 run my_pkg tool.py`.\n"}),
        package(TOOL, {"scripts/tool.py": "import rclpy\n\nrclpy.init()\n"}),
    ),
    "DEP105": (
        beside(PUBLIC, INSTALL),
        beside(PUBLIC, INSTALL, "depend"),
        beside(PUBLIC, PROGRAM.format("") + INSTALL, "depend"),
        package("find_package(PCL REQUIRED)\n" + PROGRAM.format(""), MATRICES),
        package("find_package(PCL)\n" + PROGRAM.format(""), MATRICES),
        package("find_package(OpenCV REQUIRED)\n" + PROGRAM.format(""), MATRICES),
    ),
    "CMK201": (
        package("", HEADERS),
        package(INSTALL, HEADERS),
        package("ament_auto_package()\n", HEADERS),
        package(PROGRAM.format(""), BESIDE),
        package("install(DIRECTORY . DESTINATION include)\n", HEADERS),
        package("install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})\n", HEADERS | LAUNCH),
        package("install(DIRECTORY ${OF_OTHERS} DESTINATION include)\n", HEADERS),
        package(PROGRAM.format(" ${OF_OTHERS}"), UNKNOWN),
        package(PROGRAM.format(" ${OF_OTHERS}") + "# others may be spare\n", UNKNOWN),
    ),
}
