"""Faults where nothing comes to them: programs among launch files, plugins that no list names."""

from __future__ import annotations

from rospkg_cli.example import Example

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


CASES = {
    "PLG003": tuple(Example(bad={"config/nav2.yaml": COSTMAP.format(names)}, good={}, on="config") for names in LISTS),
    "DEP103": tuple(Example(bad={"launch/a.py": text}, good={}) for text in (VIEWER, BY_HAND)),
}
