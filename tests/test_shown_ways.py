"""A fault in Python code is loud where a program is shown to come to it, under one condition at most."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, existing_files, manifest, scripts, setup_py
from rospkg_cli.testing import lint_files

PYTHON = {
    **existing_files(BACKDROPS["ament_python"]),
    "package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n  <exec_depend>std_msgs</exec_depend>\n"),
    "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
}
NODE = """\
from functools import partial

import rclpy
from rclpy.node import Node


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        {start}

    def tick(self, *given):
        {tick}


{more}
def main():
    rclpy.init()
    rclpy.spin(Talker())
"""


def level(text: str, **files: str) -> str:
    """Return the level of what is said of `lost`, wherever it stands."""
    more = {path.replace("__", "/") + ".py": each for path, each in files.items()}
    found = lint_files({**PYTHON, "my_pkg/talker.py": text, **more}, ["DEP117", "DEP120"]).findings
    return next((each.severity.value for each in found if "`lost`" in each.message), "")


def node(start: str, tick: str = "lost()", more: str = "") -> str:
    return NODE.format(start=start, tick=tick, more=more)


CALLBACKS = (
    "self.create_timer(1.0, self.tick)",
    "self.create_timer(1.0, callback=lambda: self.tick())",
    "self.create_timer(1.0, partial(self.tick, 1))",
    "try:\n            self.create_timer(1.0, self.tick)\n        except ValueError:\n            pass",
    "while rclpy.ok():\n            self.tick()",
    "for each in range(3):\n            self.tick()",
    "if self.get_name():\n            self.create_timer(1.0, self.tick)",
    "helper = Helper()\n        helper.go(self)",
    "self.helper = Helper()\n        self.helper.go(self)",
    "Helper.go(None, self)",
    "client = print\n        client.on_message = self.tick",
    "getattr(self, 'tick')()",
    "self.ways = {'tick': self.tick}",
)
HELPER = (
    "class Helper:\n    def go(self, node):\n        node.create_timer(1.0, node.tick_all)\n        lost_too()\n\n\n"
)
CALLS = HELPER.replace("node.create_timer(1.0, node.tick_all)\n        lost_too()", "lost()")


@pytest.mark.parametrize("start", CALLBACKS)
def test_a_callback_of_a_node_that_a_program_makes(start: str) -> None:
    is_of_helper = "Helper" in start
    text = node(start, "pass", CALLS) if is_of_helper else node(start)
    assert level(text) == "warning"


SELDOM = (
    "if self.get_name():\n            if self.handle:\n                self.create_timer(1.0, self.tick)",
    "if self.get_name():\n            pass\n        elif self.handle:\n            self.create_timer(1.0, self.tick)",
    "if not self.get_name():\n            return\n        if self.handle:\n            self.tick()",
    "while self.wait():\n            self.handle and self.tick()",
)


@pytest.mark.parametrize("start", SELDOM)
def test_several_conditions_on_the_way(start: str) -> None:
    assert level(node(start)) == "info"


@pytest.mark.parametrize(
    "tick", ["if given:\n            lost()", "try:\n            pass\n        except E:\n            lost()"]
)
def test_the_conditions_of_the_line_count(tick: str) -> None:
    assert (
        level(node("if self.x:\n            self.create_timer(1.0, self.tick)".replace("x", "handle"), tick)) == "info"
    )


UNSHOWN = ("tick = 1\n        print(tick)", "print('tick')", "other.tick", "tick = {'tick': 1}")


@pytest.mark.parametrize("start", UNSHOWN)
def test_a_name_alone_is_no_call(start: str) -> None:
    assert level(node(start)) == "info"


def test_an_object_of_another_class_with_the_only_method_of_the_name() -> None:
    calls = "\n\ndef use(any_node):\n    any_node.work_hard()\n\n"
    text = node("use(self)", "pass", calls).replace("def tick", "def work_hard(self):\n        lost()\n\n    def tick")
    assert level(text) == "warning"
    assert level(text.replace("use(self)", "pass")) == "info"


def test_an_heir_is_called_through_its_base() -> None:
    base = "class Base:\n    def __init__(self):\n        self.go_on()\n\n    def go_on(self): ...\n\n\n"
    heir = base + "class Heir(Base):\n    def go_on(self):\n        lost()\n\n\n"
    assert level(node("Heir()", "pass", heir)) == "warning"
    assert level(node("Base()", "pass", heir)) == "info"


@pytest.mark.parametrize("import_", ["from .way import go", "from my_pkg.way import go", "from my_pkg import way"])
def test_a_function_of_another_module(import_: str) -> None:
    call = "way.go()" if import_.endswith("way") else "go()"
    way = "def go():\n    lost()\n\n\ndef rest():\n    go()\n"
    assert level(f"{import_}\n\n\ndef main():\n    {call}\n", my_pkg__way=way) == "warning"


DEAD = ("if __name__ == '__main__':\n    {}\n", "if False:\n    {}\n", "if True:\n    pass\nelse:\n    {}\n")


@pytest.mark.parametrize("dead", DEAD)
def test_what_an_import_of_a_module_does_not_run(dead: str) -> None:
    way = "def go(): ...\n\n\n"
    main = "from my_pkg import way\n\n\ndef main():\n    way.go()\n"
    assert level(main, my_pkg__way=way + "lost()\n") == "error"
    assert level(main, my_pkg__way=way + dead.format("lost()")) in ("info", "")


def test_a_property_runs_where_it_is_read() -> None:
    text = node("print(self.speed)", "pass").replace(
        "    def tick", "    @property\n    def speed(self):\n        lost()\n\n    def tick"
    )
    assert level(text) == "warning"


TEST = "from my_pkg.talker import main\n\n\ndef test_it():\n    lost()\n\n\ndef helper():\n    main()\n"


def test_what_pytest_collects() -> None:
    main = "def main(): ...\n"
    assert level(main, test__test_it=TEST) == "warning"
    assert level(main, test__test_it=TEST.replace("test_it", "try_it")) == "info"


def test_a_test_that_no_command_of_cmake_registers() -> None:
    files = {
        "package.xml": manifest("  <test_depend>ament_cmake_pytest</test_depend>\n", "ament_cmake"),
        "test/test_it.py": TEST.replace("from my_pkg.talker import main\n", "").replace("main()", "print()"),
    }
    line = "find_package(ament_cmake_pytest REQUIRED)\nament_add_pytest_test(it test/test_it.py)\nament_package()"
    for cmake, expected in ((CMAKE, "info"), (CMAKE.replace("ament_package()", line), "warning")):
        found = lint_files({**files, "CMakeLists.txt": cmake}, ["DEP117"]).findings
        assert [each.severity.value for each in found] == [expected]


FIELD = (
    "from std_msgs.msg import String\n\n\nclass Talker:\n    def tick(self):\n"
    "        msg = String()\n        msg.dta = 1\n"
)
MAINS = {
    "Talker().tick()": "error",
    "talker = Talker()\n    talker.tick()": "error",
    "if input():\n        Talker().tick()": "warning",
    "if input():\n        if input():\n            Talker().tick()": "info",
    "print(Talker(), tick)": "info",
}


@pytest.mark.parametrize("main", MAINS)
def test_fields_of_messages(main: str) -> None:
    files = {**PYTHON, "my_pkg/talker.py": f"{FIELD}\n\ndef main():\n    {main}\n"}
    assert [each.severity.value for each in lint_files(files, ["IDL010"]).findings] == [MAINS[main]]


def test_a_file_with_a_main_that_is_no_program_beside_programs() -> None:
    text = f"{FIELD}\n\nif __name__ == '__main__':\n    Talker().tick()\n"
    pages = {"README.md": "See `way.py`.\n", "start.sh": "python3 my_pkg/way.py\n"}
    for page, expected in (("README.md", "info"), ("start.sh", "warning")):
        files = {**PYTHON, "my_pkg/talker.py": "def main(): ...\n", "my_pkg/way.py": text, page: pages[page]}
        assert [each.severity.value for each in lint_files(files, ["IDL010"]).findings] == [expected], page


GUARDED = "def go(): ...\n\n\nif __name__ == '__main__':\n    lost()\n"


@pytest.mark.parametrize("entries", [setup_py(), setup_py(scripts("talker = my_pkg.talker:main"), "scripts=found(),")])
@pytest.mark.parametrize(("importer", "expected"), [("my_pkg/talker", "info"), ("test/test_it", "warning")])
def test_a_main_of_a_module_that_others_import_where_no_program_is_known(
    entries: str, importer: str, expected: str
) -> None:
    files = {**PYTHON, "setup.py": entries, "my_pkg/talker.py": "def main(): ...\n", "my_pkg/way.py": GUARDED}
    files[f"{importer}.py"] = "from my_pkg.way import go\n\n\ndef main():\n    go()\n"
    found = lint_files(files, ["DEP117"]).findings
    assert [each.severity.value for each in found] == [expected]


@pytest.mark.parametrize(("user", "expected"), [("", "info"), ("from my_pkg.words import Talker\n", "error")])
def test_a_library_is_used_where_another_package_takes_something_of_it(user: str, expected: str) -> None:
    start = "\n    def __init__(self):\n        self.tick()\n"
    own = {**PYTHON, "setup.py": setup_py(), "my_pkg/words.py": FIELD.replace("class Talker:", f"class Talker:{start}")}
    other = {**PYTHON, "my_pkg/talker.py": f"{user}\n\ndef main(): ...\n"}
    files = {f"a/{path}": text for path, text in own.items()}
    files |= {f"b/{path.replace('my_pkg', 'user')}": text.replace("my_pkg", "user") for path, text in other.items()}
    files["b/user/talker.py"] = other["my_pkg/talker.py"]
    assert [each.severity.value for each in lint_files(files, ["IDL010"]).findings] == [expected]


REPLACED = """
class Base:
    def go_on(self):
        self.step()

    def step(self):
        lost()


class Heir(Base):
    def step(self): ...


"""


def test_what_each_object_replaces() -> None:
    assert level(node("Heir().go_on()", "pass", REPLACED)) == "info"
    assert level(node("Base().go_on()", "pass", REPLACED)) == "warning"
    assert level(node("Heir().go_on()\n        Base()", "pass", REPLACED)) == "warning"
    assert level(node("Heir().go_on()", "pass", REPLACED.replace("def step(self): ...", "pass"))) == "warning"


NOTHING = (
    "while False:\n            lost()",
    "for each in []:\n            lost(each)",
    "for each in range(0):\n            lost(each)",
    "given = 1 if True else lost()",
    "given = True or lost()",
    "given = False and lost()",
    "assert given, lost()",
    "raise ValueError(lost)",
    "if not rclpy.ok():\n            lost()",
)


@pytest.mark.parametrize("tick", NOTHING)
def test_what_a_line_never_comes_to_or_after_a_failure_alone(tick: str) -> None:
    assert level(node("self.create_timer(1.0, self.tick)", tick)) == "info"


SOMETHING = ("for each in [1]:\n            lost(each)", "given = given or lost()", "while given:\n            lost()")


@pytest.mark.parametrize("tick", SOMETHING)
def test_what_a_line_may_come_to(tick: str) -> None:
    assert level(node("self.create_timer(1.0, self.tick)", tick)) == "warning"
