"""Scripts that a pattern takes along, and programs in a folder of tools, which nobody starts (CMK103, CMK105)."""

from __future__ import annotations

from .idioms_of_cmake import package

GLOBBED = "file(GLOB scripts scripts/*.py)\ninstall(PROGRAMS ${scripts} DESTINATION lib/${PROJECT_NAME})\n"
NAMED = GLOBBED.replace("${scripts}", "scripts/plots.py")
TOOL = {"scripts/plots.py": "import os\n\nif __name__ == '__main__':\n    print(os.name)\n"}
STARTED = {"README.md": "Run `ros2 run my_pkg plots.py`.\n"}
NODE = "#include <rclcpp/rclcpp.hpp>\nint main(int argc, char ** argv)\n{\n  rclcpp::init(argc, argv);\n}\n"
PROGRAMS = "add_executable(talker src/talker.cpp)\nadd_executable(calibrate {}/calibrate.cpp)\n"
INSTALLED = "install(TARGETS talker DESTINATION lib/${PROJECT_NAME})\n"

CASES = {
    "CMK105": (
        package(GLOBBED, TOOL),
        package(GLOBBED, TOOL | STARTED),
        package(GLOBBED, {"scripts/plots.py": TOOL["scripts/plots.py"].replace("os", "rclpy")}),
        package(NAMED, TOOL),
    ),
    "CMK103": (
        *(
            package(PROGRAMS.format(where) + INSTALLED, {"src/talker.cpp": NODE, f"{where}/calibrate.cpp": NODE} | more)
            for where, more in (
                ("tools", {}),
                ("tools", {"README.md": "Run `ros2 run my_pkg calibrate`.\n"}),
                ("src", {}),
            )
        ),
        package(PROGRAMS.format("tools"), {"src/talker.cpp": NODE, "tools/calibrate.cpp": NODE}),
    ),
}
