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

CASES = {
    "DEP103": tuple(Example(bad={"launch/a.py": text}, good={}) for text in (VIEWER, BY_HAND)),
}
