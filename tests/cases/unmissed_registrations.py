"""What is registered after `ament_package()`, and not missed there: nobody looks for it, or it is said in time too."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example

MADE = "add_library(core SHARED src/core.cpp)\ninstall(TARGETS core DESTINATION lib)\n"
FILES = {"src/core.cpp": "int core() {return 1;}\n", "plugins.xml": '<library path="core"/>\n'}
COMPONENTS = "pluginlib_export_plugin_description_file(rclcpp_components plugins.xml)\n"
PLUGINS = COMPONENTS.replace("rclcpp_components", "nav2_core")
NODE = "rclcpp_components_register_nodes(core {})\n"


def package(before: str, after: str) -> Example:
    text = CMAKE.replace("ament_package", f"{MADE}{before}ament_package") + after
    return Example(bad={"CMakeLists.txt": text, **FILES}, good={}, on="ament_cmake")


CASES = {
    "CMK004": (
        package("", COMPONENTS),
        package("", PLUGINS),
        package(PLUGINS, PLUGINS),
        package(PLUGINS.replace("plugins", "others"), PLUGINS),
        package("", COMPONENTS + PLUGINS),
        package(NODE.format("ns::Core"), NODE.format("ns::Core")),
        package(NODE.format("ns::Core"), NODE.format("ns::Other")),
        package(f"if(WITH_CORE)\n{PLUGINS}endif()\n", PLUGINS),
    ),
}
