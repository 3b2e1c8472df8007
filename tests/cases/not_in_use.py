"""Faults where nothing comes to them: programs among launch files, plugins that no list names."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest, scripts, setup_py

VIEWER = """\
import rclpy
from cv_bridge import CvBridge


def main():
    rclpy.init()
    CvBridge()


if __name__ == "__main__":
    main()
"""
BY_HAND = """\
import cv_bridge
from launch import LaunchService

if __name__ == "__main__":
    LaunchService().run()
"""
COSTMAP = """\
local_costmap:
  local_costmap:
    ros__parameters:
      plugins: [{}]
      static_layer:
        plugin: nav2_costmap_2d::StaticLayers
      voxel_layer:
        plugin: costmap_2d::VoxelLayer
"""
LISTS = (
    '"voxel_layer"',
    '"static_layer", "voxel_layer"',
    '"static_layer",\n                "voxel_layer"',
)

ON_REQUEST = """\
import rclpy.node
from std_srvs.srv import Empty


class Talker(rclpy.node.Node):
    def __init__(self):
        super().__init__('talker')
        self.declare_parameter('rate', 10.0)
        self.create_service(Empty, 'load', self.load)

    def {}(self, request, response):
        self.rate = self.get_parameter('rat').value
        return response
"""
NODES = """\
add_library(talker SHARED src/talker.cpp)
ament_target_dependencies(talker rclcpp rclcpp_components)
rclcpp_components_register_nodes(talker PLUGIN "my_pkg::Talker"{})
install(TARGETS talker DESTINATION lib)
ament_package"""
COMPONENT = """\
#include <rclcpp_components/register_node_macro.hpp>
RCLCPP_COMPONENTS_REGISTER_NODE(my_pkg::Talker)
"""

HEIRS = """\
{}


class Talker:
    def go(self):
        pass


class Loud(Talker):
    def go(self):
        pass

    def lose(self):
        return nothing{}


def main():
    Loud().go()
"""

LOOPED = """\
#include <rclcpp/rclcpp.hpp>
class Talker : public rclcpp::Node {
public:
  Talker() : Node("talker") {
    for (const auto & axis : {"x_", "y_"}) {
      declare_parameter(axis + std::string("p"), 1.0);
    }
    x_p_ = get_parameter("%s").as_double();
  }
  double x_p_;
};
"""
NESTED = """\
from rclpy.node import Node


class Talker(Node):
    class Publisher:
        pass

    def __init__(self):
        super().__init__('talker')
        self.{}()
"""

SLAM = """\
<launch>
  <node pkg="slam_toolbox" exec="async_slam_toolbox_node" name="slam_toolbox">
    <param from="$(find-pkg-share my_pkg)/config/slam.yaml"/>
  </node>
</launch>
"""
SLAM_YAML = """\
slam_toolbox:
  ros__parameters:
    mode: mapping
    resolution: 0.05
    map_frame: map
    use_lifecycle_manager: 'false'
"""


CASES = {
    "DEP120": tuple(
        Example(bad={"my_pkg/talker.py": NESTED.format(name)}, good={}) for name in ("Publisher", "create_publishr")
    ),
    "DEP117": (
        Example(
            bad={
                "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
                "my_pkg/__init__.py": "def __init__(self):\n    super().__init__('a')\n    self.bridge = CvBridge()\n",
                "my_pkg/talker.py": "class A:\n    def __init__(self):\n        super().__init__()\n\n\n"
                "def main():\n    A()\n",
            },
            good={},
        ),
        *(
            Example(
                bad={
                    "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
                    "my_pkg/talker.py": HEIRS.format(top, called).replace("Loud(Talker)", f"Loud({base})"),
                },
                good={},
            )
            for top, base, called in (
                ("import my_base", "Talker", ""),
                ("import my_base", "Talker", " + self.lose()"),
                ("import my_base", "my_base.Talking", ""),
            )
        ),
    ),
    "CMK108": tuple(
        Example(
            bad={
                "CMakeLists.txt": CMAKE.replace("ament_package", NODES.format(more)),
                "package.xml": manifest("  <depend>rclcpp_components</depend>\n", "ament_cmake"),
                "src/talker.cpp": COMPONENT,
            },
            good={},
            on="ament_cmake",
        )
        for more in ("", " EXECUTABLE talker_node")
    ),
    "CMK201": (
        *(
            Example(
                bad={
                    "CMakeLists.txt": CMAKE.replace(
                        "ament_package", f"add_executable(a src/a.cpp)\n{line}\nament_package"
                    ),
                    "src/a.cpp": "#include <ros/ros.h>\nint main() {}\n",
                },
                good={},
                on="ament_cmake",
            )
            for line in ("", "target_include_directories(a PRIVATE /opt/ros/noetic/include)", "link_libraries(roscpp)")
        ),
        *(
            Example(
                bad={
                    "CMakeLists.txt": CMAKE.replace("ament_package", "add_executable(a src/a.cpp)\nament_package"),
                    "include/my_pkg/other.hpp": "#pragma once\n",
                    "src/a.cpp": f'#include "my_pkg/{name}"\nint main() {{}}\n',
                },
                good={},
                on="ament_cmake",
            )
            for name in ("topic.pb.h", "othre.hpp")
        ),
    ),
    "DEP118": (
        Example(
            bad={
                "CMakeLists.txt": CMAKE.replace("ament_package", "add_executable(a src/a.cpp)\nament_package"),
                "src/a.cpp": '#include "/home/ada/ws/src/my_pkg/include/my_pkg/a.hpp"\n',
                "include/my_pkg/a.hpp": "#pragma once\n",
            },
            good={},
            on="ament_cmake",
        ),
        *(
            Example(bad={"my_pkg/talker.py": text, "my_pkg/a.txt": "a\n"}, good={})
            for text in (
                "P = open('/home/ada/ws/src/my_pkg/package.xml')\n",
                "P = open('/home/ada/ws/src/my_pkg/my_pkg/a.txt')\n",
                "P = open('/home/ada/ws/src/my_pkg/my_pkg/out.txt')\n",
                "raise RuntimeError('/home/ada/ws/src/my_pkg/package.xml')\n",
            )
        ),
        *(
            Example(
                bad={
                    "CMakeLists.txt": CMAKE.replace("ament_package", "add_executable(a src/a.cpp)\nament_package"),
                    "src/a.cpp": f'{guard}\n#define DATA "/home/ada/ws/src/my_pkg/package.xml"\n#endif\n',
                },
                good={},
                on="ament_cmake",
            )
            for guard in ("#ifndef DATA", "#ifndef OTHER")
        ),
    ),
    "PRM006": tuple(
        Example(
            bad={
                "CMakeLists.txt": CMAKE.replace(
                    "ament_package", "install(DIRECTORY config launch DESTINATION share/${PROJECT_NAME})\nament_package"
                ),
                "launch/a.launch.xml": SLAM,
                "README.md": f"For ROS 2 {name}\n",
                "config/slam.yaml": SLAM_YAML,
            },
            good={},
            on="config",
        )
        for name in ("Humble", "Jazzy", "Jazzy and Humble")
    ),
    "PRM007": (
        *(Example(bad={"my_pkg/talker.py": ON_REQUEST.format(name)}, good={}) for name in ("load", "loads")),
        *(
            Example(
                bad={
                    "CMakeLists.txt": CMAKE.replace(
                        "ament_package", "add_library(talker src/talker.cpp)\nament_package"
                    ),
                    "src/talker.cpp": LOOPED % name,
                },
                good={},
                on="ament_cmake",
            )
            for name in ("x_p", "x_i")
        ),
    ),
    "PLG003": tuple(Example(bad={"config/nav2.yaml": COSTMAP.format(names)}, good={}, on="config") for names in LISTS),
    "DEP103": tuple(Example(bad={"launch/a.py": text}, good={}) for text in (VIEWER, BY_HAND)),
}
