"""Names of packages that everybody uses: misspelt, removed, right."""

from __future__ import annotations

from rospkg_cli.example import Example, manifest

from .shown_launch import xml
from .shown_launch_calls import python

PROGRAMS = xml(
    '<node pkg="controller_manager" exec="spawner"/>',
    '<node pkg="controller_manager" exec="spawner.py"/>',
    '<node pkg="controller_manager" exec="spawnr"/>',
    '<node pkg="nav2_recoveries" exec="recoveries_server"/>',
    '<node pkg="nav2_util" exec="dump_params"/>',
    '<node pkg="nav2_controller" exec="controler_server"/>',
    '<node pkg="nav2_controller" exec="something_else"/>',
    '<node pkg="tf2_ros" exec="static_transform_publsher" if="false"/>',
    '<node pkg="somebodys_package" exec="spawnr"/>',
    '<node exec="robot_state_publisher"/>',
    '<node exec="rviz2"/>',
    '<node exec="mux"/>',
    '<node pkg="slam_toolbox" exec="sync_sllam_toolbox_node"/>',
)
COMPONENTS = xml(
    '<node_container pkg="rclcpp_components" exec="component_container" name="c" namespace="">',
    '<composable_node pkg="image_proc" plugin="image_proc::RectifyNode" name="a"/>',
    '<composable_node pkg="image_proc" plugin="image_proc::RectifyNod" name="a"/>',
    '<composable_node pkg="moveit_servo" plugin="moveit_servo::ServoServer" name="a"/>',
    '<composable_node pkg="image_proc" plugin="image_proc::SomethingElse" name="a"/>',
    '<composable_node pkg="rtabmap_ros" plugin="rtabmap_ros::CoreWrapper" name="a"/>',
    '</node_container>',
)  # fmt: skip
OWN = "".join(
    f"<node pkg='{package}' exec='{name}'/>"
    for package, name in (("controller_manager", "spawnr"), ("controller_manager", "spawner.py"))
)
PLUGINS = """\
planner_server:
  ros__parameters:
    planner_plugins: [a, b, c, d, e, f, g]
    a:
      plugin: nav2_navfn_planner::NavfnPlanner
    b:
      plugin: nav2_navfn_planner::NavfnPlaner
    c:
      plugin: nav2_navfn_planner/NavfnPlaner
    d:
      plugin: nav2_navfn_planner::SomethingElse
    e:
      plugin: nav2_recoveries/Spin
    f:
      plugin: nav2_costmap_2d/StaticLayer
    g:
      plugin: stomp_moveit/StompSmoothingAdapter
    h:
      plugin: nav2_navfn_planner::navfnplanner
    i:
      plugin: nav2_recoveries/Wait
    j:
      plugin: nav2_costmap_2d::ObstacleCostmapPlugin
    k:
      plugin: nav2_costmap_2d::SocialLayer
    l:
      plugin: nav2_costmap_2d::SocialLayer
    m:
      plugin: nav2_controller::ControllerServer
    n:
      plugin: rviz_default_plugins/Something
    o:
      plugin: effort_controllers/JointPositionController
    p:
      plugin: nav2_costmap_2d::Plugin
    q:
      plugin: somebodys_layers::ObstacleCostmapPlugin
"""
YAML = Example(
    on="config",
    bad={"config/nav2.yaml": PLUGINS},
    good={},
)
HERE = Example(
    on="",
    bad={
        "nav2_navfn_planner/package.xml": manifest("", "ament_cmake", "nav2_navfn_planner"),
        "user/package.xml": manifest("", "ament_cmake", "user"),
        "user/config/nav2.yaml": PLUGINS,
    },
    good={},
)
CASES = {
    "LCH002": (
        PROGRAMS,
        Example(
            bad={
                "controller_manager/package.xml": manifest("", "ament_cmake", "controller_manager"),
                "user/package.xml": manifest("", "ament_cmake", "user"),
                "user/launch/a.launch.xml": f"<launch>{OWN}</launch>\n",
            },
            good={},
            on="",
        ),
    ),
    "LCH011": (
        COMPONENTS,
        python(
            "ComposableNodeContainer(package='rclcpp_components', executable='component_container', name='c', "
            "namespace='', composable_node_descriptions=[ComposableNode(package='moveit_servo', "
            "plugin='moveit_servo::ServoServer')], condition=IfCondition('false'))",
        ),
    ),
    "PLG003": (YAML, HERE),
}
