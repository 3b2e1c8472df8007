"""Names of plugins inside of the block of another plugin, which reads them or does not (PLG003)."""

from __future__ import annotations

from rospkg_cli.example import Example

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
CASES = {
    "PLG003": tuple(Example(bad={"config/nav2.yaml": text}, good={}, on="config") for text in (NESTED, COSTMAP)),
}
