"""What classes read of themselves and nothing sets (DEP117): how bad it is, and what may set it after all."""

from __future__ import annotations

from rospkg_cli.example import Example

from .undefined_names import talker

NODE = "import rclpy\nfrom rclpy.node import Node\n\n\n"
START = "\n\ndef main():\n    rclpy.init()\n    rclpy.spin({}())\n"


def node(
    *lines: str, head: str = "", name: str = "Talker", base: str = "(Node)", then: str = "", **files: str
) -> Example:
    """A node that is started, with these lines in its methods."""
    body = "".join(f"    {line}\n" for line in lines)
    return talker(f"{NODE}{head}class {name}{base}:\n{body}{START.format(name)}{then}", **files)


INIT = "def __init__(self):"
SUPER = "    super().__init__('talker')"
TICK = "def tick(self):"

FOREIGN = "from rclpy.lifecycle import LifecycleNode as RosNode\nfrom other.node import LifecycleNode\n\n\n"
OWN = "from .b import Base as B\n\n\n"
TOLD = (
    node(INIT, SUPER, "    self.say()", head=FOREIGN, base="(RosNode)"),
    node(INIT, SUPER, "    self.say()", head=OWN, base="(B)", my_pkg__b="class Base: ...\n"),
    node(INIT, SUPER, "    self.create_timer(1.0, self.tik)", TICK, "    print(self.speed, self.rate)"),
    node(INIT, SUPER, "    self.create_timer(1.0, self.tick)", TICK, "    self.count += 1", "    print(self.count)"),
    node(INIT, "    self.create_timer(1.0, self.tick)", TICK, "    self.get_logger().info('a')", base=""),
    node(INIT, SUPER, "    self.say()", head="class Base(Node):\n    def speak(self): ...\n\n\n", base="(Base)"),
    node(INIT, SUPER, "    self.say()", head="from .base import Base\n\n\n", base="(Base)",
         my_pkg__base="from rclpy.node import Node\n\n\nclass Base(Node):\n    def speak(self): ...\n"),
    node(INIT, SUPER, "    self.create_client_of_arm()", "    self.timer_callback()"),
    node(INIT, SUPER, "    Buffer(self)", "    self.say()", head="from tf2_ros import Buffer\n\n\n"),
    node(INIT, SUPER, "def idle(self):", "    print(self.speed)"),
    node(
        INIT, SUPER, "    self.create_timer(1.0, self.tick)", TICK, "    if self.tick:", "        print(self.speed)",
        "    while not self.tick:", "        self.rate.sleep()", "    while rclpy.ok():", "        print(self.mode)",
    ),
    node(INIT, SUPER, "    print(self.speed and self.tick, self.mode or self.rate)"),
    node(INIT, SUPER, "    self.mode = self.Mode()", "class Mode:", "    def on(self):", "        return self.off"),
)  # fmt: skip
QUIET = (
    node(INIT, SUPER, "    self.say()", head=FOREIGN, base="(LifecycleNode)"),
    node(
        INIT,
        SUPER,
        "    self.say()",
        head=f"from other import Other as Base\n{OWN}",
        base="(Base)",
        my_pkg__b="class Base: ...\n",
    ),
    node(INIT, SUPER, "    self.say()", base="(Other)", head="from other import Other\n\n\n"),
    node(INIT, SUPER, "    self.say()", then="\n\nclass Loud(Talker):\n    def say(self): ...\n"),
    node(INIT, SUPER, "    self.say()", my_pkg__b="from .talker import Talker\n\n\nTalker.say = print\n"),
    node(INIT, SUPER, "    setattr(self, input(), 1)", "    print(self.speed)"),
    node(INIT, SUPER, "    print(self.speed)", my_pkg__b="def fill(Talker, name):\n    setattr(Talker, name, 1)\n"),
    node(INIT, SUPER, "    if hasattr(self, 'speed'):", "        print(self.speed)"),
    node(INIT, SUPER, "    try:", "        print(self.speed)", "    except AttributeError:", "        pass"),
    node(INIT, SUPER, "    self.m = t.Machine(model=self)", "    self.say()", head="import transitions as t\n\n\n"),
    node(INIT, SUPER, "    ui.load.loadUi('a.ui', self)", "    self.say()", head="import ui.load\n\n\n"),
    node(INIT, SUPER, "    self.get_clients_info_by_service('a')", "    print(self._parameters)"),
    node(INIT, SUPER, "    for self.speed, self.rate in ((1, 2),):", "        print(self.speed, self.rate)"),
    node(
        INIT,
        SUPER,
        "    print(self.speed, self.rate, self.say)",
        "if input():",
        "    speed = 1",
        "rate: int",
        "say = print",
    ),
    node(INIT, SUPER, "    print(self.speed)", head="import other\n\n\n@other.filled\n"),
    node(
        INIT,
        SUPER,
        "@staticmethod",
        "def say(self):",
        "    print(self.speed)",
        "def hear(own):",
        "    print(own.speed)",
    ),
    talker(NODE + "class Base(Node):\n    def tick(self):\n        self.say()\n\n\ndef main(): ...\n"),
)

CASES = {"DEP117": (*TOLD, *QUIET)}
