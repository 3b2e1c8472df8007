"""Of several faults that end a run the first one keeps its level; nobody meets those behind it yet."""

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
import rclpy
from rclpy.node import Node
from std_msgs.msg import String
{top}

class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        {start}
        self.create_timer(1.0, self.tick)
        self.create_subscription(String, 'words', self.hear, 1)

    def tick(self):
        msg = String()
        msg.dta = 'a'
        late()

    def hear(self, msg):
        {hear}


def main():
    rclpy.init()
    {main}
    rclpy.spin(Talker())
"""
CODES = ["DEP109", "DEP110", "DEP117", "DEP120", "IDL008", "IDL010", "IDL011"]


def found(files: dict[str, str], **parts: str) -> dict[str, str]:
    """Return the level by the text of the place that is reported."""
    given = {"top": "", "start": "pass", "hear": "heard()", "main": "pass", **parts}
    text = NODE.format(**given)
    findings = lint_files({**PYTHON, "my_pkg/talker.py": text, **files}, CODES).findings
    own = [each for each in findings if each.location.path == "my_pkg/talker.py"]
    return {text[each.location.span.start : each.location.span.end]: each.severity.value for each in own}


def test_what_follows_in_the_same_function() -> None:
    assert found({}) == {"dta": "error", "late": "info", "heard": "warning"}


@pytest.mark.parametrize("import_", ["from my_pkg.«gone» import a", "from my_pkg.«srv» import Go"])
def test_an_import_that_fails_ends_the_file(import_: str) -> None:
    levels = found({}, top=import_.replace("«", "").replace("»", ""), main="glob()")
    assert levels.pop("gone", "") or levels.pop("my_pkg.srv") == "error"
    assert levels == {"glob": "info", "dta": "info", "late": "info", "heard": "info"}


def test_interfaces_that_nothing_generates_end_the_file_that_imports_them() -> None:
    assert set(found({"srv/Go.srv": "---\n"}, top="from my_pkg.srv import Go").values()) == {"info"}


@pytest.mark.parametrize("import_", ["try:\n    import my_pkg.gone\nexcept ImportError:\n    pass", "import json"])
def test_an_import_that_may_fail(import_: str) -> None:
    assert found({}, top=import_)["dta"] == "error"


@pytest.mark.parametrize("place", ["start", "main"])
def test_what_is_led_to_only_behind_the_first_fault(place: str) -> None:
    assert found({}, **{place: "glob()"}) == {"glob": "error", "dta": "info", "late": "info", "heard": "info"}


@pytest.mark.parametrize(
    "start",
    ["self.tick(); glob()", "if self.get_name():\n            glob()", "for a in self.waitables:\n            glob()"],
)
def test_what_is_led_to_before_or_beside_a_fault(start: str) -> None:
    assert found({}, start=start)["dta"] == "error"


@pytest.mark.parametrize(
    ("hear", "level"),
    [
        ("one(); two()", "info"),
        ("if msg:\n            one()\n            two()", "info"),
        ("if msg:\n            one()\n        two()", "warning"),
        ("a = one if msg else None; two()", "warning"),
        ("try:\n            one()\n        except NameError:\n            pass\n        two()", "warning"),
        ("with suppress(NameError):\n            one()\n        two()", "warning"),
        ("with self.lock:\n            one()\n        two()", "info"),
    ],
)
def test_the_rest_of_a_branch(hear: str, level: str) -> None:
    assert found({}, top="from contextlib import suppress", hear=hear)["two"] == level


@pytest.mark.parametrize(
    ("main", "level"),
    [
        ("Talker()\n    behind()", "info"),
        ("helper()\n    behind()", "info"),
        ("try:\n        Talker()\n    except NameError:\n        pass\n    behind()", "error"),
        ("lambda: Talker()\n    behind()", "error"),
        ("items()\n    behind()", "error"),
    ],
)
def test_who_calls_what_fails_fails_too(main: str, level: str) -> None:
    helpers = "\n\ndef helper():\n    return Talker()\n\n\ndef items():\n    yield Talker()\n"
    assert found({}, top=helpers, start="glob()", main=main)["behind"] == level


def test_a_thread_runs_beside_what_fails() -> None:
    start = "Thread(target=self.tick).start()"
    assert found({}, top="from threading import Thread", start=f"{start}; glob()")["dta"] == "error"


@pytest.mark.parametrize(("base", "level"), [("Node", "error"), ("Talker", "info")])
def test_an_heir_that_starts_by_itself(base: str, level: str) -> None:
    start = f"{base}.__init__(self, 'heir')"
    heir = f"class Heir(Talker):\n    def __init__(self):\n        {start}; self.create_timer(1.0, self.tick)\n"
    main = f"self = Heir()\n\n\n{heir}\n\ndef more():\n    rclpy.init()"
    assert found({}, start="glob()", main=main)["dta"] == level


def test_a_name_that_is_used_elsewhere_too() -> None:
    assert found({}, hear="late()")["late"] == "warning"


def test_what_another_file_leads_to() -> None:
    other = "from my_pkg.talker import Talker\n\n\ndef main():\n    Talker()\n"
    setup = {"setup.py": setup_py(scripts("talker = my_pkg.talker:main", "other = my_pkg.other:main"))}
    assert found({**setup, "my_pkg/other.py": other}, main="glob()")["dta"] == "error"


def test_it_says_where_the_run_ends() -> None:
    text = NODE.format(top="", start="glob()", hear="pass", main="pass")
    findings = lint_files({**PYTHON, "my_pkg/talker.py": text}, ["DEP117", "IDL010"]).findings
    (behind,) = (each for each in findings if each.code == "IDL010")
    assert behind.message.endswith("; the run ends before, at another line")
    assert [(at.line, what) for at, what in behind.related] == [(9, "this raises first")]


def test_a_module_whose_own_import_fails_ends_those_that_import_it() -> None:
    files = {"my_pkg/words.py": "from .gone import hello\n", "my_pkg/deep.py": "import my_pkg.words\n"}
    for import_ in ("from .words import hello", "from . import deep"):
        assert set(found(files, top=import_).values()) == {"info"}
    tried = "try:\n    from .words import hello\nexcept ImportError:\n    pass"
    assert found(files, top=tried)["dta"] == "error"


def test_the_import_of_a_test_that_fails() -> None:
    test = "from my_pkg.gone import a\n\n\ndef test_it():\n    lost()\n"
    findings = lint_files({**PYTHON, "my_pkg/talker.py": "", "test/test_it.py": test}, ["DEP109", "DEP117"]).findings
    assert {each.code: each.severity.value for each in findings} == {"DEP109": "warning", "DEP117": "info"}


BASE = """\
class Base:
    def declare(self, name, default=None, *, hint=''):
        print(name, default, hint)

    def ask(self, *names, **more):
        print(names, more)
"""
CALLS = {
    "self.declare('a', value=1)": "info",
    "self.declare('a', 1, 2)": "info",
    "self.declare(default=1)": "info",
    "self.declare('a', hint=1)": "warning",
    "self.declare(*given)": "warning",
    "self.declare(**given)": "warning",
    "self.ask(1, 2, value=3)": "warning",
    "given and self.declare('a', value=1)": "warning",
    "if given:\n            self.declare('a', value=1)": "warning",
    "try:\n            self.declare('a', value=1)\n        except TypeError:\n            pass": "warning",
}
USER = """\
from my_pkg.base import Base


class User(Base):
    def __init__(self, *given):
        {}
        self.tick()

    def tick(self):
        if input():
            late()


def main():
    User(1)
"""


@pytest.mark.parametrize("call", CALLS)
def test_a_call_that_an_own_method_refuses_ends_the_run(call: str) -> None:
    files = {**PYTHON, "my_pkg/base.py": BASE, "my_pkg/talker.py": USER.format(call)}
    findings = [each for each in lint_files(files, ["DEP117"]).findings if "`late`" in each.message]
    assert [each.severity.value for each in findings] == [CALLS[call]]


def test_a_method_that_something_sets_or_an_heir_has_may_take_any_call() -> None:
    text = USER.format("self.declare('a', value=1)")
    heir = text + "\n\nclass Heir(User):\n    def declare(self, *given, **more): ...\n"
    for each in (
        heir,
        text.replace("        self.tick()", "        self.tick()\n\n    def set(self):\n        self.declare = print"),
    ):
        files = {**PYTHON, "my_pkg/base.py": BASE, "my_pkg/talker.py": each}
        findings = [each for each in lint_files(files, ["DEP117"]).findings if "`late`" in each.message]
        assert [each.severity.value for each in findings] == ["warning"]
