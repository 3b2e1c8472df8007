"""Names of rclpy and of nodes: what no example shows."""

from __future__ import annotations

from rospkg_cli.example import Example
from rospkg_cli.rules.depends import dep120_unknown_rclpy_name as dep120


def node(*lines: str, bases: str = "Node", head: str = "", path: str = "my_pkg/talker.py") -> Example:
    body = "".join(f"        {line}\n" for line in lines)
    text = dep120.NODE.replace("        self.get_logger().info('here')\n", body)
    text = head + text.replace("(Node)", f"({bases})")
    return Example(
        bad={**dep120.FILES, "my_pkg/talker.py": dep120.NODE, path: text.replace("«", "").replace("»", "")}, good={}
    )


FOREIGN = "from rclpy.lifecycle import LifecycleNode as RosNode\nfrom other.node import LifecycleNode\n"
CASES = {
    "DEP120": (
        node("rclpy.«loginfo»('a')", "self.get_loger", "self.«get_loger»().info('b')", "rclpy.«Rate»(10)"),
        node("self.«Publisher»('a')", "rclpy.anything()", "self.anything()", "rclpy.wait_for_message.a()"),
        node("self.creat_timer()", bases="Node, Other", head="from other import Other\n"),
        node("self.creat_timer()", head="class Base:\n    def creat_timer(self):\n        pass\n\n\n"),
        node("rclpy.loginfo('a')", head="rclpy = None\n"),
        node("self.creat_timer()", head=FOREIGN, bases="LifecycleNode"),
        node("self.«creat_timer»()", head=FOREIGN, bases="RosNode"),
        node("setattr(self, name, 1)", "self.creat_timer()"),
        node(
            "self.get_logger.«info»('a')",
            "self.get_clock.«now»()",
            "self.get_logger.__doc__",
            "other.get_logger.info('b')",
        ),
        node("self.get_logger.info('a')", head="class Base:\n    def get_logger(self):\n        pass\n\n\n"),
        node(
            "while not self.tick:", "    rclpy.«sleep»(1)", "try:", "    pass", "except OSError:", "    rclpy.«Rate»(1)"
        ),
        node("rclpy.«loginfo»('a')", path="my_pkg/idle.py"),
        node("rclpy.«loginfo»('a')", path="test/test_talker.py"),
    )
}
