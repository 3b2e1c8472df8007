"""A callback of a node that nothing spins, and what stands behind the loop of a constructor, is met by nobody."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, manifest, scripts, setup_py
from rospkg_cli.testing import lint_files

PYTHON = {
    **existing_files(BACKDROPS["ament_python"]),
    "package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n  <exec_depend>std_msgs</exec_depend>\n"),
    "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
}
NODE = """\
from functools import partial

import other_pkg
import rclpy
from rclpy.action import ActionClient
from rclpy.node import Node
from std_msgs.msg import String


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.client = ActionClient(self, String, 'go')
        {start}

    def ask(self):
        self.answer = self.client.send_goal_async(1)
        self.answer.add_done_callback(self.tick)

    def tick(self, *given):
        lost()

    def loop(self):
        while rclpy.ok():
            print(1)


def main():
    rclpy.init()
    talker = Talker()
    {end}
"""
SUBSCRIBED = "self.create_subscription(String, 'words', self.tick, 10)"
OTHER = "import rclpy\nfrom my_pkg.talker import Talker\n\n\ndef main():\n    rclpy.spin(Talker())\n"
SPUN = "rclpy.spin(talker)"


def told(start: str = SUBSCRIBED, end: str = "talker.loop()", **files: str) -> tuple[str, str]:
    """Return the level of what is said of `lost`, and the message."""
    more = {f"my_pkg/{name}.py": text for name, text in files.items()}
    text = {"my_pkg/talker.py": NODE.format(start=start, end=end)}
    (found,) = lint_files({**PYTHON, **text, **more}, ["DEP117"]).findings
    return found.severity.value, found.message


@pytest.mark.parametrize(
    "start",
    [
        SUBSCRIBED,
        "self.create_subscription(String, 'words', callback=self.tick, qos_profile=10)",
        "self.create_timer(1.0, self.tick)",
        "self.create_timer(1.0, lambda: self.tick())",
        "self.create_timer(1.0, partial(self.tick, 1))",
        "self.create_service(String, 'words', self.tick)",
        "self.ask()",
    ],
)
def test_callbacks_that_only_an_executor_calls(start: str) -> None:
    level, message = told(start)
    assert (level, "nothing spins the node" in message) == ("info", True)
    assert told(start, SPUN)[0] == "warning"


@pytest.mark.parametrize(
    "start",
    [
        "self.tick()",
        "other_pkg.listen(on_press=self.tick)",
        "self.add_on_set_parameters_callback(self.tick)",
        "other_pkg.pool().submit(print).add_done_callback(self.tick)",
    ],
)
def test_what_others_call(start: str) -> None:
    assert told(start)[0] in ("warning", "error")


@pytest.mark.parametrize(
    "end",
    [
        "rclpy.spin_once(talker)",
        "rclpy.spin_until_future_complete(talker, talker.answer)",
        "while rclpy.ok():\n        rclpy.spin_once(talker)",
        "executor = rclpy.executors.SingleThreadedExecutor()\n    executor.add_node(talker)",
        "other_pkg.run(talker)",
        "other_pkg.run(node=talker)",
        "other_pkg.run([talker])",
        "return talker",
        "other_pkg.nodes = talker",
        "getattr(rclpy, 'spin')(talker)",
        "other_pkg.TransformListener(1, talker, spin_thread=True)",
    ],
)
def test_what_may_spin_it(end: str) -> None:
    assert told(end=end)[0] == "warning"


def test_other_files_may_spin_it() -> None:
    assert told(end="from my_pkg.runs import run\n    run()", runs="def run(): ...\n")[0] == "info"
    spins = "import rclpy\n\n\ndef run():\n    rclpy.spin(node)\n\n\nnode = rclpy.create_node('a')\n"
    assert told(end="from my_pkg.runs import run\n    run()", runs=spins)[0] == "warning"


def test_a_base_of_others_may_spin_it() -> None:
    text = NODE.format(start=SUBSCRIBED, end="talker.loop()").replace("Talker(Node)", "Talker(other_pkg.Navigator)")
    (found,) = lint_files({**PYTHON, "my_pkg/talker.py": text}, ["DEP117"]).findings
    assert found.severity.value == "warning"


def test_another_program_spins_it() -> None:
    files = {
        **PYTHON,
        "setup.py": setup_py(scripts("talker = my_pkg.talker:main", "other = my_pkg.other:main")),
        "my_pkg/talker.py": NODE.format(start=SUBSCRIBED, end="pass"),
        "my_pkg/other.py": OTHER,
    }
    (found,) = lint_files(files, ["DEP117"]).findings
    assert found.severity.value == "warning"


@pytest.mark.parametrize(
    ("code", "line"),
    [
        ("IDL010", "text = String()\n        print(text.dat)"),
        ("DEP120", "self.creat_timer(1, print)"),
        ("DEP109", "import my_pkg.gone"),
        ("IDL011", "from std_msgs.msg import Sting"),
    ],
)
def test_other_rules_say_so_too(code: str, line: str) -> None:
    for end, is_mild in (("pass", True), (SPUN, False)):
        text = (
            NODE.format(start=SUBSCRIBED, end=end)
            .replace("*given", "given")
            .replace("        lost()", f"        {line}")
        )
        (found,) = lint_files({**PYTHON, "my_pkg/talker.py": text}, [code]).findings
        assert (found.severity.value == "info") == is_mild


LOOPS = (
    "while True:\n            print(1)",
    "while rclpy.ok():\n            print(1)",
    "self.loop()",
    "try:\n            self.loop()\n        finally:\n            print(1)",
    "while True:\n            if input():\n                rclpy.shutdown()\n                break",
    "while 1:\n            try:\n                input()\n            except KeyboardInterrupt:\n                break",
)
ENDING = (
    "while True:\n            if input():\n                break",
    "while not self.client:\n            print(1)",
    "if self.client:\n            return\n        self.loop()",
    "print(self.loop)",
)


@pytest.mark.parametrize("loop", LOOPS)
def test_the_loop_of_a_constructor_is_all_the_work(loop: str) -> None:
    assert told(f"{SUBSCRIBED}\n        {loop}", SPUN)[0] == "info"
    text = NODE.format(start=loop, end="lost.talker = Talker()").replace("        lost()", "        pass")
    text = text.replace("talker = Talker()\n    lost", "lost", 1)
    (found,) = lint_files({**PYTHON, "my_pkg/talker.py": text}, ["DEP117"]).findings
    assert (found.severity.value, "once the loop has ended" in found.message) == ("info", True)


@pytest.mark.parametrize("loop", ENDING)
def test_a_loop_that_ends(loop: str) -> None:
    assert told(f"{SUBSCRIBED}\n        {loop}", SPUN)[0] == "warning"
