"""Names of plugins that others read, or may have: in blocks of plugins, of any node, of packages elsewhere (PLG003)."""

from __future__ import annotations

from rospkg_cli.example import Example, manifest
from rospkg_cli.rules.plugins import plg003_unknown_plugin as plg003

NESTED = """\
controller_server:
  ros__parameters:
    controller_plugins: [FollowPath, Other, Own]
    FollowPath:
      critics: [BaseObstacle]
      BaseObstacle:
        plugin: "dwb_critics::BaseObstacle"
        scale: 0.02
      plugin: "dwb_core::DWBLocalPlanner"
    Other:
      plugin: nav2_rotation_shim_controller::RotationShimController  # turns first
      primary_controller:
        plugin: dwb_core::DWBLocalPlaner
        BaseObstacle: # below the inner one
          plugin: dwb_critics::BaseObstacle
    Own:
      plugin: our_controllers::Own
      inner:
        plugin: dwb_core::DWBLocalPlaners
"""
COSTMAP = """\
/**:
  ros__parameters:
    plugins: ["all"]
    filters: ["keepout"]
    keepout:
      plugin: "nav2_costmap_2d::KeepoutFiltr"
    all:
      plugin: "nav2_costmap_2d::PluginContainerLayer"
      plugins: ["voxels"]
      voxels:
        plugin: "nav2_costmap_2d::VoxelLayr"
      unused:
        plugin: "nav2_costmap_2d::VoxelLayrs"
"""
NODES = """\
controller_manager:
  ros__parameters:
    arm_controller.type: my_pkg/Nothing
our_node:
  ros__parameters:
    lidar:
      type: my_pkg/Lidar
    system:
      type: my_pkg::GenericSystem
    other:
      type: our_pkgs/Other
    solver_plugin: our_solvers/GenericSystem
    near:
      plugin: my_pgk/GenericSystem
    mock:
      plugin: mock_components/GenericSystem
    needed:
      plugin: simulator/GenericSystem
"""
OURS = {
    **{path: text.replace("my_pkg::Planner", "my_pkg::GenericSystem") for path, text in plg003.FILES.items()},
    "package.xml": manifest("  <depend>our_pkg</depend>\n  <depend>simulator</depend>\n", "ament_cmake"),
    "config/robot.yaml": NODES,
}
OURS["plugins.xml"] = OURS["plugins.xml"].replace("my_pkg/Planner", "my_pkg/GenericSystem")
CASES = {
    "PLG003": (
        *(Example(bad={"config/nav2.yaml": text}, good={}, on="config") for text in (NESTED, COSTMAP)),
        Example(bad=OURS, good={}, on="ament_cmake"),
    ),
}
