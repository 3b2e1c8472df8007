"""What stands behind a wait in a constructor for what only a callback sets is met by nobody: nothing spins the node."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, manifest, scripts, setup_py
from rospkg_cli.testing import lint_files

PYTHON = {
    **existing_files(BACKDROPS["ament_python"]),
    "package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n  <exec_depend>std_msgs</exec_depend>\n"),
    "setup.py": setup_py(scripts("talker = my_pkg.talker:main", "caller = my_pkg.caller:main")),
}
NODE = """\
import time
from threading import Thread

import rclpy
from rclpy.action import ActionClient
from rclpy.node import Node
from std_msgs.msg import String


class {owner}:
    def __init__(self):
        super().__init__('talker')
        {first}
        {start}
        while {test}:
            {body}
        lost()

    def hear(self, msg):
        self.words = msg

    def tell(self):
        self.hear(1)

    def reset(self):
        self.create_timer(1.0, self.tell)


def main():
    rclpy.init()
    rclpy.spin(Talker())
"""
CALLER = """\
import rclpy
from {home} import Talker


def main():
    rclpy.init()
    talker = Talker()
    lost(talker)
"""
HEARS = "self.create_subscription(String, 'words', self.hear, 1)"


def level(
    test: str = "not self.words",
    first: str = "self.words = None",
    start: str = HEARS,
    body: str = "time.sleep(0.1)",
    owner: str = "Talker(Node)",
) -> str:
    text = NODE.format(test=test, first=first, start=start, body=body, owner=owner)
    (found,) = lint_files({**PYTHON, "my_pkg/talker.py": text}, ["DEP117"]).findings
    assert ("a wait before it never ends" in found.message) == (found.severity.value == "info")
    return found.severity.value


@pytest.mark.parametrize(
    "test, first",
    [
        ("not self.words", "self.words = None"),
        ("not self.words", "self.words = []"),
        ("self.words is None", "self.words = None"),
        ("rclpy.ok() and self.words is None", "self.words = None"),
        ("self.words is None or self.get_name()", "self.words = None"),
        ("len(self.words) == 0", "self.words = []"),
        ("self.words < 3", "self.words = 0"),
        ("self.words", "self.words = True"),
    ],
)
def test_a_wait_that_nothing_ends(test: str, first: str) -> None:
    assert level(test, first) == "info"


@pytest.mark.parametrize(
    "test, first",
    [
        ("not self.words", "self.words = True"),
        ("not self.words", "self.words = time.time()"),
        ("not self.words", "self.words = None; self.words = [1]"),
        ("not self.words", "pass"),
        ("self.words is not None", "self.words = None"),
        ("self.words is None and self.get_name()", "self.words = None"),
        ("len(self.words) > 0", "self.words = []"),
        ("len(self.words) == 0", "self.words = [1]"),
        ("self.get_name()", "self.words = None"),
    ],
)
def test_a_wait_of_which_that_is_not_known(test: str, first: str) -> None:
    assert level(test, first) != "info"


@pytest.mark.parametrize(
    "start",
    [
        "self.tell()",
        "self.reset(); self.create_service(String, 'a', callback=self.tell)",
        "Thread(target=self.tell).start()",
        "Thread(target=rclpy.spin, args=(self,)).start()",
        "self.words_too = self.words",
        "self.words.append(1)",
        "self.client = ActionClient(self, String, 'a')",
        "if self.get_name():\n            return",
        "self.on_parameters = self.hear",
    ],
)
def test_what_may_end_it_before(start: str) -> None:
    harmless = start.startswith(("self.client", "self.reset"))
    assert (level(start=start) == "info") == harmless


@pytest.mark.parametrize(
    "body", ["rclpy.spin_once(self)", "self.tell()", "if self.get_name():\n                break", "self.words = 1"]
)
def test_a_loop_that_does_more_than_wait(body: str) -> None:
    assert level(body=body) != "info"


def test_other_classes_may_be_spun_by_others() -> None:
    assert level(owner="Talker(Node, dict)") != "info"


@pytest.mark.parametrize("home", ["my_pkg.talker", ".talker"])
def test_who_makes_such_a_node(home: str) -> None:
    text = NODE.format(test="not self.words", first="self.words = None", start=HEARS, body="pass", owner="Talker(Node)")
    files = {**PYTHON, "my_pkg/talker.py": text.replace("lost()", "pass"), "my_pkg/caller.py": CALLER.format(home=home)}
    (found,) = lint_files(files, ["DEP117"]).findings
    assert found.severity.value == "info"
    assert [(at.path, at.line, what.partition(",")[0]) for at, what in found.related] == [
        ("my_pkg/caller.py", 7, "nothing spins the node here")
    ]
    files["my_pkg/talker.py"] = text.replace("lost()", "pass").replace("not self.words", "self.words")
    (found,) = lint_files(files, ["DEP117"]).findings
    assert found.severity.value == "error"
