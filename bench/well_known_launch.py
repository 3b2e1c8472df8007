"""Write the table of the launch files of well-known packages (well_known_launch.txt in ros/tables).

    python -m bench.well_known_launch FOLDER

FOLDER holds bare mirrors, `owner+name/repo` each.  Of every repository the branches of the supported distributions and
the newest one are read as `rospkg lint` reads a workspace; packages of which not all is known are left out.
"""

from __future__ import annotations

import sys
from pathlib import Path

from bench.tables import Origin, write
from bench.well_known import branches, facts_in, mirrored
from bench.well_known_renames import REPOSITORIES

TABLE = "well_known_launch.txt"
ABOUT = {
    TABLE: "Launch files that well-known packages install in the supported distributions: package, then their paths "
    "below its share directory; of packages of which all is known."
}
ORIGIN = Origin(
    "install rules of the repositories that bench/well_known_renames.py and the script list, their branches from "
    "Humble on",
    "Apache-2.0, BSD-2-Clause, BSD-3-Clause, EPL-2.0, LGPL-2.1, LGPL-3.0, MIT",
    "bench/well_known_launch.py",
)
ROBOTS = tuple(
    """
    ROBOTIS-GIT/turtlebot3 ROBOTIS-GIT/turtlebot3_simulations turtlebot/turtlebot4 turtlebot/turtlebot4_simulator
    Slamtec/sllidar_ros2 YDLIDAR/ydlidar_ros2_driver Livox-SDK/livox_ros_driver2 ouster-lidar/ouster-ros
    UniversalRobots/Universal_Robots_ROS2_Driver UniversalRobots/Universal_Robots_ROS2_Description
    moveit/moveit_resources iRobotEducation/create3_sim micro-ROS/micro-ROS-Agent
    """.split()
)
"""Repositories of drivers and robots, beside the common ones."""
ENDINGS = (".launch.py", "_launch.py", ".launch.xml", "_launch.xml", ".launch.yaml", ".launch.yml", ".launch")


def main(folder: Path) -> None:
    found: dict[str, set[str]] = {}
    unknown: set[str] = set()
    mirrors, revision = mirrored(folder, (*REPOSITORIES, *ROBOTS))
    for mirror in mirrors:
        for branch in (branch for branch, is_current in branches(mirror) if is_current):
            for facts in facts_in(mirror, branch):
                unknown |= set() if facts.knows("share_files") else {facts.name}
                files = {each for each in facts.share_files if each.endswith(ENDINGS) and " " not in each}
                found.setdefault(facts.name, set()).update(files)
    rows = (" ".join([name, *sorted(files)]) for name, files in sorted(found.items()) if files - {""})
    known = [row for row in rows if row.split(" ", 1)[0] not in unknown]
    write(TABLE, ABOUT[TABLE], known, ORIGIN, revision)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
