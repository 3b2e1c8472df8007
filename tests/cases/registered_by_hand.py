"""Classes that another command puts into the resource index of components (CMK108)."""

from __future__ import annotations

from .idioms_of_cmake import package

COMPONENT = "#include <rclcpp_components/register_node_macro.hpp>\nRCLCPP_COMPONENTS_REGISTER_NODE(arm::Arm)\n"
LIBRARY = "add_library(arm SHARED src/arm.cpp)\ninstall(TARGETS arm DESTINATION lib)\n"

CASES = {
    "CMK108": tuple(
        package(LIBRARY + line, {"src/arm.cpp": COMPONENT, "resource/components": "arm::Arm;lib/libarm.so\n"})
        for line in (
            "",
            'ament_index_register_resource("rclcpp_components" CONTENT "arm::Arm;lib/libarm.so\\n")\n',
            'ament_index_register_resource("rclcpp_components" CONTENT "arm::Leg;lib/libarm.so\\n")\n',
            "install(FILES resource/components DESTINATION share/ament_index/resource_index/rclcpp_components)\n",
        )
    ),
}
