"""PRM007: a value that is dropped and is the default of the parameter that is meant changes nothing for anybody."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest, scripts, setup_py
from rospkg_cli.testing import lint_files

LAUNCH = """\
<launch>
  <node pkg="{}" exec="{}">
    <param from="$(find-pkg-share my_pkg)/config/a.yaml"/>
  </node>
</launch>
"""
CODE = """\
import rclpy
from rclpy.node import Node


def main():
    rclpy.init()
    node = Node('talker')
    rate = node.declare_parameter('rate', {rate}).value
    frame = node.declare_parameter('frame_id', 'map').value
    depth = node.declare_parameter('queue_depth', 5).value
    print(rate, frame, depth)
    rclpy.spin(node)
"""
BRINGUP = """\
<launch>
  <include file="$(find-pkg-share nav2_bringup)/launch/navigation_launch.py">
    <arg name="params_file" value="$(find-pkg-share my_pkg)/config/a.yaml"/>
  </include>
</launch>
"""
INSTALLED = (
    "['package.xml']), ('share/my_pkg/config', ['config/a.yaml']), ('share/my_pkg/launch', ['launch/a.launch.xml']"
)
YAML = "talker:\n  ros__parameters:\n    rate: 2.0\n    queue_depth: 3\n    {}: {}\n"


@pytest.mark.parametrize(
    ("name", "value", "level"),
    [("frame_di", "map", "info"), ("frame_di", "odom", "warning"), ("frame_di", '"map"', "info")],
)
def test_a_default_of_the_code(name: str, value: str, level: str) -> None:
    files = {
        "package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n"),
        "setup.py": setup_py(scripts("talker = my_pkg.talker:main")).replace("['package.xml']", INSTALLED),
        "resource/my_pkg": "",
        "my_pkg/__init__.py": "",
        "my_pkg/talker.py": CODE.format(rate=1.0),
        "config/a.yaml": YAML.format(name, value),
        "launch/a.launch.xml": LAUNCH.format("my_pkg", "talker"),
    }
    (found,) = lint_files(files, ["PRM007"]).findings
    assert found.severity.value == level
    assert ("and nothing differs: it is the default of `frame_id`; did you mean" in found.message) is (level == "info")


@pytest.mark.parametrize(("value", "level"), [("map", "info"), ("odom", "warning"), ("$(var frame)", "warning")])
def test_a_default_in_a_launch_file(value: str, level: str) -> None:
    given = "".join(f'<param name="{n}" value="{v}"/>' for n, v in (("rate", "2.0"), ("frame_di", value)))
    files = {
        "package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n"),
        "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
        "my_pkg/__init__.py": "",
        "my_pkg/talker.py": CODE.format(rate=1.0),
        "start.sh": "ros2 launch launch/a.launch.xml\n",
        "launch/a.launch.xml": f'<launch><node pkg="my_pkg" exec="talker">{given}</node></launch>\n',
    }
    (found,) = lint_files(files, ["PRM007"]).findings
    assert found.severity.value == level


@pytest.mark.parametrize(("value", "level"), [("20.0", "info"), ("20", "info"), ("10.0", "warning")])
def test_a_default_of_a_node_that_everybody_uses(value: str, level: str) -> None:
    given = f"ontroller_frequency: {value}\n    min_x_velocity_threshold: 0.01\n    failure_tolerance: 0.3\n"
    files = {
        "package.xml": manifest("  <exec_depend>nav2_bringup</exec_depend>\n", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace(
            "ament_package", "install(DIRECTORY config launch DESTINATION share/${PROJECT_NAME})\nament_package"
        ),
        "config/a.yaml": f"controller_server:\n  ros__parameters:\n    {given}",
        "launch/a.launch.xml": LAUNCH.format("nav2_controller", "controller_server"),
    }
    (found,) = lint_files(files, ["PRM007"]).findings
    assert found.severity.value == level


PLUGIN = ("wait_at_waypoint", "info"), ("photo_at_waypoint", "warning")


@pytest.mark.parametrize(("value", "level"), PLUGIN)
def test_a_default_that_is_a_text_in_the_code(value: str, level: str) -> None:
    given = f"loop_rate: 20\n    stop_on_failure: false\n    waypoint_task_execturo_plugin: {value}\n"
    files = {
        "package.xml": manifest("  <exec_depend>nav2_bringup</exec_depend>\n", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace(
            "ament_package", "install(DIRECTORY config launch DESTINATION share/${PROJECT_NAME})\nament_package"
        ),
        "config/a.yaml": f"waypoint_follower:\n  ros__parameters:\n    {given}",
        "launch/a.launch.xml": LAUNCH.format("nav2_waypoint_follower", "waypoint_follower"),
    }
    (found,) = lint_files(files, ["PRM007"]).findings
    assert found.severity.value == level


@pytest.mark.parametrize(
    ("code", "value", "level"),
    [
        ('std::string("map")', "map", "info"),
        ('rclcpp::ParameterValue(std::string("map"))', "map", "info"),
        ('std::string{"map"}', "odom", "warning"),
        ("first_frame()", "map", "warning"),
    ],
)
def test_a_default_that_is_a_string_of_cpp(code: str, value: str, level: str) -> None:
    source = (
        "#include <rclcpp/rclcpp.hpp>\nint main(int argc, char ** argv)\n{\n  rclcpp::init(argc, argv);\n"
        '  auto node = std::make_shared<rclcpp::Node>("talker");\n  node->declare_parameter("rate", 1.0);\n'
        f'  node->declare_parameter("queue_depth", 5);\n  node->declare_parameter("frame_id", {code});\n'
        "  rclcpp::spin(node);\n}\n"
    )
    build = "find_package(rclcpp REQUIRED)\nadd_executable(talker src/talker.cpp)\n"
    build += "target_link_libraries(talker rclcpp::rclcpp)\n"
    build += "install(TARGETS talker DESTINATION lib/${PROJECT_NAME})\n"
    files = {
        "package.xml": manifest("  <depend>rclcpp</depend>\n", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace(
            "ament_package", build + "install(DIRECTORY config launch DESTINATION share/${PROJECT_NAME})\nament_package"
        ),
        "src/talker.cpp": source,
        "config/a.yaml": YAML.format("frame_di", value),
        "launch/a.launch.xml": LAUNCH.format("my_pkg", "talker"),
    }
    (found,) = lint_files(files, ["PRM007"]).findings
    assert found.severity.value == level


LIBRARY = """\
talker:
  rate: {type: double, default_value: 1.0}
  queue_depth: {type: int, default_value: 5}
  frame_id: {type: string, default_value: map}
"""


@pytest.mark.parametrize(("value", "level"), [("map", "info"), ("odom", "warning")])
def test_a_default_of_a_generated_library(value: str, level: str) -> None:
    build = "find_package(generate_parameter_library REQUIRED)\n"
    build += "generate_parameter_library(talker_parameters src/talker.yaml)\n"
    files = {
        "package.xml": manifest("  <depend>generate_parameter_library</depend>\n", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace(
            "ament_package", build + "install(DIRECTORY config launch DESTINATION share/${PROJECT_NAME})\nament_package"
        ),
        "src/talker.yaml": LIBRARY,
        "config/a.yaml": YAML.format("frame_di", value),
        "launch/a.launch.xml": LAUNCH.format("my_pkg", "talker"),
    }
    (found,) = lint_files(files, ["PRM007"]).findings
    assert found.severity.value == level


@pytest.mark.parametrize(("plugins", "level"), [("[Grid, Fine]", "warning"), ("[Fine]", "info")])
@pytest.mark.parametrize(("code", "value"), [("PRM007", "tolerence: 1.0"), ("PRM006", "tolerance: 1")])
def test_a_plugin_that_no_list_names_is_not_loaded(code: str, value: str, plugins: str, level: str) -> None:
    planners = (
        f"planner_server:\n  ros__parameters:\n    planner_plugins: {plugins}\n    Grid:\n"
        f"      plugin: nav2_navfn_planner::NavfnPlanner\n      {value}\n"
        "    Fine:\n      plugin: nav2_smac_planner::SmacPlannerHybrid\n"
    )
    files = {
        "package.xml": manifest("  <exec_depend>nav2_planner</exec_depend>\n", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace(
            "ament_package", "install(DIRECTORY config launch DESTINATION share/${PROJECT_NAME})\nament_package"
        ),
        "config/a.yaml": planners,
        "launch/a.launch.xml": LAUNCH.format("nav2_planner", "planner_server"),
    }
    (found,) = lint_files(files, [code]).findings
    assert found.severity.value == level


@pytest.mark.parametrize(("value", "level"), [("true", "info"), ("True", "info"), ("false", "warning")])
def test_a_default_of_a_plugin_that_everybody_uses(value: str, level: str) -> None:
    layers = (
        "local_costmap:\n  local_costmap:\n    ros__parameters:\n      plugins: [static_layer]\n      static_layer:\n"
        f"        plugin: nav2_costmap_2d::StaticLayer\n        nabled: {value}\n"
        "        map_subscribe_transient_local: true\n        transform_tolerance: 0.2\n"
    )
    files = {
        "package.xml": manifest("  <exec_depend>nav2_bringup</exec_depend>\n", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace(
            "ament_package", "install(DIRECTORY config launch DESTINATION share/${PROJECT_NAME})\nament_package"
        ),
        "config/a.yaml": layers,
        "launch/a.launch.xml": BRINGUP,
    }
    (found,) = lint_files(files, ["PRM007"]).findings
    assert found.severity.value == level


NODE = """\
<launch><node pkg="{}" exec="{}">{}</node></launch>
"""
PROBABLY = "where it is the default of `{}`, as such a value mostly is"


def of_known(package: str, program: str, **values: str) -> tuple[str, str]:
    """Return level and message of the one slip among values that a launch file gives a well-known node."""
    given = "".join(f'<param name="{name}" value="{value}"/>' for name, value in values.items())
    files = {
        "package.xml": manifest(f"  <exec_depend>{package}</exec_depend>\n", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace(
            "ament_package", "install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})\nament_package"
        ),
        "launch/a.launch.xml": NODE.format(package, program, given),
    }
    (found,) = lint_files(files, ["PRM007"]).findings
    return found.severity.value, found.message


@pytest.mark.parametrize(("value", "level"), [("false", "info"), ("true", "warning")])
def test_a_default_that_the_table_of_joy_has(value: str, level: str) -> None:
    found, message = of_known("joy", "joy_node", deadzone="0.5", device_id="0", sticky_button=value)
    assert found == level
    assert ("and nothing differs: it is the default of `sticky_buttons`" in message) is (level == "info")


@pytest.mark.parametrize(("value", "level"), [("0.0", "info"), ("0", "info"), ("2.5", "warning")])
def test_what_mostly_is_a_default_is_taken_for_one_that_is_not_known(value: str, level: str) -> None:
    found, message = of_known("robot_localization", "ekf_node", frequency="30.0", map_frame="map", sensor_timeot=value)
    assert found == level
    assert (PROBABLY.format("sensor_timeout") in message) is (level == "info")


def test_a_known_default_is_believed_before_what_mostly_is_one() -> None:
    assert (
        of_known("robot_localization", "ekf_node", frequency="30.0", map_frame="map", publis_tf="false")[0] == "warning"
    )
    assert of_known("robot_localization", "ekf_node", frequency="30.0", map_frame="map", publis_tf="true")[0] == "info"


@pytest.mark.parametrize(
    ("value", "level"), [("false", "info"), ("[]", "info"), ('""', "info"), ("", "info"), ("[1]", "warning")]
)
def test_empty_values_of_a_parameter_file(value: str, level: str) -> None:
    files = {
        "package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n"),
        "setup.py": setup_py(scripts("talker = my_pkg.talker:main")).replace("['package.xml']", INSTALLED),
        "resource/my_pkg": "",
        "my_pkg/__init__.py": "",
        "my_pkg/talker.py": CODE.format(rate=1.0).replace("'map'", "default_of('frame')"),
        "config/a.yaml": YAML.format("frame_di", value),
        "launch/a.launch.xml": LAUNCH.format("my_pkg", "talker"),
    }
    (found,) = lint_files(files, ["PRM007"]).findings
    assert found.severity.value == level


@pytest.mark.parametrize(("value", "level"), [("false", "info"), ("true", "warning"), ("$(var sim)", "warning")])
def test_a_slip_of_use_sim_time_is_lost_where_it_is_true(value: str, level: str) -> None:
    files = {
        "package.xml": manifest("  <exec_depend>turtlesim</exec_depend>\n"),
        "setup.py": setup_py("[]"),
        "my_pkg/__init__.py": "",
        "launch/a.launch.xml": '<launch><arg name="sim" default="false"/><node pkg="turtlesim" exec="turtlesim_node">'
        f'<param name="use_sim_tim" value="{value}"/></node></launch>\n',
    }
    (found,) = lint_files(files, ["PRM007"]).findings
    assert found.severity.value == level


@pytest.mark.parametrize(
    ("values", "level"),
    [
        ("sticky_buttons: false\n    deadzone: 0.05", "info"),
        ("sticky_buttons: false\n    deadzone: 0.5", "warning"),
        ("use_sim_time: false\n    sticky_buttons: false", "info"),
        ("use_sim_time: true", "warning"),
    ],
)
@pytest.mark.parametrize("key", ["joy_nod", "rear/joy_node"])
def test_a_block_that_holds_defaults_alone(key: str, values: str, level: str) -> None:
    start = NODE.format("joy", "joy_node", '<param from="$(find-pkg-share my_pkg)/config/a.yaml"/>')
    start = start.replace('exec="joy_node"', 'exec="joy_node" name="joy_node"')
    if "/" in key:
        start = start.replace('name="joy_node"', 'name="joy_node" namespace="front"')
    files = {
        "package.xml": manifest("  <exec_depend>joy</exec_depend>\n", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace(
            "ament_package", "install(DIRECTORY config launch DESTINATION share/${PROJECT_NAME})\nament_package"
        ),
        "config/a.yaml": f"{key}:\n  ros__parameters:\n    {values}\n",
        "launch/a.launch.xml": start,
    }
    (found,) = lint_files(files, ["PRM003"]).findings
    assert found.severity.value == level
    assert ("nothing differs: the values are the defaults, or mostly are" in found.message) is (level == "info")


def bringup(launch: str, yaml: str) -> dict[str, str]:
    return {
        "package.xml": manifest("  <exec_depend>nav2_bringup</exec_depend>\n", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace(
            "ament_package", "install(DIRECTORY config launch DESTINATION share/${PROJECT_NAME})\nament_package"
        ),
        "config/a.yaml": yaml,
        "launch/a.launch.xml": launch,
    }


@pytest.mark.parametrize(("value", "level"), [("camera_depth_frame", "info"), ("camera_link", "warning")])
def test_a_default_of_a_driver(value: str, level: str) -> None:
    yaml = f"scanner:\n  ros__parameters:\n    scan_height: 10\n    range_max: 8.0\n    output_frame_id: {value}\n"
    launch = LAUNCH.format("depthimage_to_laserscan", 'depthimage_to_laserscan_node" name="scanner')
    (found,) = lint_files(bringup(launch, yaml), ["PRM007"]).findings
    assert found.severity.value == level


@pytest.mark.parametrize(
    ("switch", "level", "said"),
    [
        ("use_control: false\n", "info", "while `use_control` is false; did"),
        ("two_d_mode: true\n", "info", "while `use_control` is false, as by default; did"),
        ("use_control: true\n", "warning", "the value is dropped; did"),
        ("use_control: $(var control)\n", "warning", "the value is dropped; did"),
    ],
)
def test_a_value_whose_switch_is_off(switch: str, level: str, said: str) -> None:
    given = f"frequency: 30.0\n    odom_frame: odom\n    {switch}    control_timeour: 0.2\n"
    launch = LAUNCH.format("robot_localization", 'ekf_node" name="ekf_filter_node')
    (found,) = lint_files(bringup(launch, f"ekf_filter_node:\n  ros__parameters:\n    {given}"), ["PRM007"]).findings
    assert found.severity.value == level
    assert said in found.message


@pytest.mark.parametrize(("enabled", "level"), [("false", "info"), ("true", "warning")])
def test_a_layer_of_a_costmap_that_is_off(enabled: str, level: str) -> None:
    yaml = "local_costmap:\n  local_costmap:\n    ros__parameters:\n      plugins: [inflation_layer]\n"
    yaml += '      inflation_layer:\n        plugin: "nav2_costmap_2d::InflationLayer"\n'
    yaml += f"        enabled: {enabled}\n        inflation_radis: 0.9\n        cost_scaling_factor: 3.0\n"
    (found,) = lint_files(bringup(LAUNCH.format("nav2_controller", "controller_server"), yaml), ["PRM007"]).findings
    assert found.severity.value == level


CPP = """\
#include <rclcpp/rclcpp.hpp>
class Talker : public rclcpp::Node {{
public:
  Talker() : Node("talker") {{
    declare_parameter("rate", 1.0);
    declare_parameter("queue_depth", 5);
    // the frame; of the map
    this->declare_parameter<std::string>("frame_id", "map");
    rate_ = get_parameter("rate").as_double();
    {}
  }}
private:
  double rate_;
  std::string frame_;
}};
int main() {{ rclcpp::spin(std::make_shared<Talker>()); }}
"""
READS = (
    ('this->get_parameter("frame_id", frame_);', "info"),
    ('frame_ = this->get_parameter("frame_id").as_string();', "info"),
    ('this->get_parameter("frame_id", frame_); use(frame_);', "warning"),
    ('frame_ = this->get_parameter("frame_id").as_string(); use(frame_);', "warning"),
    ('use(this->get_parameter("frame_id").as_string());', "warning"),
    ("use(get_parameters({names}));", "warning"),
)


@pytest.mark.parametrize(("read", "level"), READS)
def test_a_parameter_that_cpp_never_uses(read: str, level: str) -> None:
    build = "find_package(rclcpp REQUIRED)\nadd_executable(talker src/talker.cpp)\n"
    build += "target_link_libraries(talker rclcpp::rclcpp)\n"
    build += "install(TARGETS talker DESTINATION lib/${PROJECT_NAME})\n"
    given = bringup(LAUNCH.format("my_pkg", "talker"), YAML.format("frame_di", "odom"))
    files = {
        **given,
        "package.xml": manifest("  <depend>rclcpp</depend>\n", "ament_cmake"),
        "CMakeLists.txt": given["CMakeLists.txt"].replace("install(DIR", build + "install(DIR"),
        "src/talker.cpp": CPP.format(read),
    }
    (found,) = lint_files(files, ["PRM007"]).findings
    assert found.severity.value == level
    assert ("nothing differs, as no code uses `frame_id`; did" in found.message) is (level == "info")


@pytest.mark.parametrize(("after", "level"), [("", "info"), ("print(node.frame)", "warning")])
def test_a_parameter_that_python_never_uses(after: str, level: str) -> None:
    lines = ["import rclpy", "from rclpy.node import Node", "", "", "class Talker(Node):", "    def __init__(self):"]
    lines += ["        super().__init__('talker')", "        print(self.declare_parameter('rate', 1.0).value)"]
    lines += ["        print(self.declare_parameter('queue_depth', 5).value)"]
    lines += ["        self.declare_parameter('frame_id', 'map')"]
    lines += ["        self.frame = self.get_parameter('frame_id').value", "", "", "def main():", "    rclpy.init()"]
    lines += ["    node = Talker()", f"    {after}", "    rclpy.spin(node)", ""]
    files = {
        "package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n"),
        "setup.py": setup_py(scripts("talker = my_pkg.talker:main")).replace("['package.xml']", INSTALLED),
        "my_pkg/__init__.py": "",
        "my_pkg/talker.py": "\n".join(lines),
        "config/a.yaml": YAML.format("frame_di", "odom"),
        "launch/a.launch.xml": LAUNCH.format("my_pkg", "talker"),
    }
    (found,) = lint_files(files, ["PRM007"]).findings
    assert found.severity.value == level
