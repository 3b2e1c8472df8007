"""Programs for tests and demonstrations beside others of a package (CMK103, CMK104), modules of other folders
(RPK001)."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, SETUP_CFG, Example, manifest, scripts, setup_py

MAIN = "#include <rclcpp/rclcpp.hpp>\nint main(int argc, char ** argv) {rclcpp::init(argc, argv);}\n"
TALKER = "add_executable(talker src/talker.cpp)\ninstall(TARGETS talker DESTINATION lib/${PROJECT_NAME})\n"
SHARE = "install(TARGETS %s DESTINATION share/${PROJECT_NAME})\n"
LINK = "target_link_libraries(%s rclcpp::rclcpp)\n"
NODES = ("sensor_test", "DemoNode", "listener", "tested")


def built(node: str, more: str = "", talker: str = TALKER, files: dict[str, str] | None = None) -> Example:
    lines = f"{talker}add_executable({node} src/{node}.cpp)\n{LINK % node}{more}"
    text = CMAKE.replace("ament_package", f"find_package(rclcpp REQUIRED)\n{lines}ament_package")
    own = {"CMakeLists.txt": text, "src/talker.cpp": MAIN, f"src/{node}.cpp": MAIN, **(files or {})}
    own["package.xml"] = manifest("  <depend>rclcpp</depend>\n", "ament_cmake")
    return Example(bad=own, good={}, on="ament_cmake")


LAUNCH = {"launch/a.launch.xml": '<launch><node pkg="my_pkg" exec="sensor_test"/></launch>\n'}
TOOL = {
    "package.xml": manifest("", "ament_python"),
    "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
    "setup.cfg": SETUP_CFG,
    "my_pkg/__init__.py": "",
    "resource/my_pkg": "",
    "bench/__init__.py": "",
}

CASES = {
    "CMK103": (
        *map(built, NODES),
        built("sensor_test", talker=""),
        built("sensor_test", files={"README.md": "ros2 run my_pkg sensor_test\n"}),
        built("sensor_test", files={"run.sh": "ros2 run my_pkg sensor_test\n"}),
        built("sensor_test", files=LAUNCH),
    ),
    "CMK104": (
        *(built(each, SHARE % each) for each in NODES),
        built("sensor_test", SHARE % "sensor_test", talker=""),
        built("sensor_test", SHARE % "sensor_test", files={"README.md": "ros2 run my_pkg sensor_test\n"}),
    ),
    "RPK001": (
        Example(bad={**TOOL, "bench/talker.py": "def a(:\n"}, good={}, on=""),
        Example(bad={**TOOL, "my_pkg/talker.py": "def a(:\n"}, good={}, on=""),
        Example(bad={**TOOL, "setup.py": setup_py(scripts("talk = talker:main")), "bench/talker.py": "def a(:\n"},
                good={}, on=""),
    ),
}  # fmt: skip
