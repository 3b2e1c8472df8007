"""Names behind a `spin` that Ctrl-C leaves by an exception, which no line of the function behind it sees."""

from __future__ import annotations

from rospkg_cli.example import Example, manifest, scripts, setup_py

FILES = {
    "package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n"),
    "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
}
HEAD = "import rclpy\nfrom rclpy.node import Node\n\n\ndef main():\n    rclpy.init()\n    node = Node('talker')\n"
OWN = """\
import rclpy
from rclpy.node import Node


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.create_timer(1.0, self.tick)

    def tick(self):
        «first».tick()

    def close(self):
        «last».close()


def stop(node):
    node.close()


def main():
    rclpy.init()
    node = Talker()
    {}
"""


def program(*lines: str) -> Example:
    return Example(bad={**FILES, "my_pkg/talker.py": HEAD + "".join(f"    {line}\n" for line in lines)}, good={})


CASES = {
    "DEP117": (
        program("rclpy.spin(node)", "«talker».destroy_node()", "rclpy.shutdown()"),
        program("with node:", "    rclpy.spin(node)", "«talker».destroy_node()"),
        program("try:", "    rclpy.spin(node)", "finally:", "    «talker».destroy_node()"),
        program("try:", "    rclpy.spin(node)", "except KeyboardInterrupt:", "    pass", "«talker».destroy_node()"),
        program("try:", "    rclpy.spin(node)", "except OSError:", "    pass", "«talker».destroy_node()"),
        program("while rclpy.ok():", "    rclpy.spin_once(node)", "«talker».destroy_node()"),
        program("while True:", "    if input():", "        break", "«talker».destroy_node()"),
        program("rclpy.spin_once(node)", "«talker».destroy_node()"),
        *(
            Example(bad={**FILES, "my_pkg/talker.py": OWN.format("\n    ".join(lines))}, good={})
            for lines in (
                ("rclpy.spin(node)", "node.close()"),
                ("rclpy.spin(node)", "stop(node)"),
                ("try:", "    rclpy.spin(node)", "finally:", "    node.close()"),
                ("node.close()", "rclpy.spin(node)", "node.close()"),
                ("node.create_timer(1.0, node.close)", "rclpy.spin(node)", "stop(node)"),
            )
        ),
    ),
    "DEP120": (
        program("rclpy.spin(node)", "rclpy.«shutdwn»()"),
        program("rclpy.«spinn»(node)", "rclpy.shutdown()"),
    ),
}
