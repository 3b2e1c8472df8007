"""Files that maps and parameter files name: levels that no example shows."""

from __future__ import annotations

from rospkg_cli.example import Example

MAP = "image: «hal.pgm»\nresolution: 0.05\norigin: [0.0, 0.0, 0.0]\n"
TREE = "bt_navigator:\n  ros__parameters:\n    default_nav_to_pose_bt_xml: $(find-pkg-share my_pkg)/«config/b.xml»\n"
CASES = {
    "PRM010": (
        Example(on="ament_cmake", bad={"maps/office.yaml": MAP, "src/a.py": "open('maps/office.yaml')\n"}, good={}),
        Example(on="config", bad={"config/office.yaml": MAP, "config/hall.pgm": "", "config/nav.yaml": TREE}, good={}),
    )
}
