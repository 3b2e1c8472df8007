"""Names behind a `spin` that Ctrl-C leaves by an exception, which no line of the function behind it sees."""

from __future__ import annotations

from rospkg_cli.example import Example, manifest, scripts, setup_py

FILES = {
    "package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n"),
    "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
}
HEAD = "import rclpy\nfrom rclpy.node import Node\n\n\ndef main():\n    rclpy.init()\n    node = Node('talker')\n"


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
    ),
    "DEP120": (
        program("rclpy.spin(node)", "rclpy.«shutdwn»()"),
        program("rclpy.«spinn»(node)", "rclpy.shutdown()"),
    ),
}
