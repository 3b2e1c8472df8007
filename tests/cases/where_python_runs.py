"""What a reader knows of the surroundings: distributions that pages name, platforms, and nodes made elsewhere."""

from __future__ import annotations

from dataclasses import replace

from rospkg_cli.example import Example, scripts, setup_py
from rospkg_cli.rules.depends import dep113_missing_share_file as dep113
from rospkg_cli.rules.depends import dep117_undefined_name as dep117
from rospkg_cli.rules.depends import dep118_personal_path as dep118
from rospkg_cli.rules.depends import dep120_unknown_rclpy_name as dep120

from .setups import python
from .shown_fields import code

PAGES = ("For Humble.\n", "For Humble and Jazzy.\n", "For Jazzy.\n", "For Foxy.\n")
MADE = "\nprint(Status(batery=1))\n"


def below(page: str, text: str) -> Example:
    """A repository with a page beside its packages."""
    given = code(text)
    return replace(given, bad={**given.bad, "README.md": page})


TESTS = (
    "sys.platform == 'win32'",
    "os.name == 'nt'",
    "platform.system() == 'Windows'",
    "sys.platform != 'linux'",
    "sys.platform.startswith('win') and rclpy.ok()",
    "self.platform == 'rover'",
)
"""The last one asks for something else."""
UNDER = "\n\ndef ask(self):\n    if {}:\n        {}\n    else:\n        {}\n"
STARTED = dep117.NODE.replace("    rclpy.spin(", "    ask(None)\n    rclpy.spin(")
ASKING = f"import os\nimport platform\nimport sys\n\n{STARTED}"


def asking(files: dict[str, str | None], line: str, test: str, other: str = "pass") -> Example:
    """A module that does something on one system alone, or on all others."""
    return python({**files, "my_pkg/talker.py": ASKING + UNDER.format(test, line, other)})


SHARE = "from ament_index_python.packages import get_package_share_path"
READS = f"{SHARE}\n        open({dep113.OPENS.format('people')})"
PEOPLE = dep113.PEOPLE | {"setup.py": dep117.FILES["setup.py"]}
OPENS = "open('/home/ada/ws/src/my_pkg/config/robot.yaml')"


def holding(path: str, owner: str, name: str) -> Example:
    """A file with a method that nothing calls, beside a program."""
    text = f"class {owner}:\n    def {name}(self):\n        {OPENS}\n\n\ndef main():\n    {owner.partition('(')[0]}()\n"
    return python({**dep118.FILES, path: text})


METHODS = (
    ("my_pkg/talker.py", "Talker", "test_it"),
    ("my_pkg/talker.py", "TestTalker", "test_it"),
    ("my_pkg/test_talker.py", "Talker", "test_it"),
    ("my_pkg/test_talker.py", "TestTalker", "test_it"),
    ("my_pkg/talker_test.py", "Talker(unittest.TestCase)", "test_it"),
)

HANDED = """\
class Settings:
    def __init__(self, node):
        node.declare_parameter('force_state_choice', '')
        self.force = node.get_parameter('force_state').value
"""
MAKES = """\
from rclpy.node import Node

from .settings import Settings


class Talker(Node):
    def __init__(self):
        super().__init__('talker'{})
        self.settings = Settings(self)


def main():
    Talker()
"""
OPTIONS = ("", ", allow_undeclared_parameters=True", ", automatically_declare_parameters_from_overrides=True")


def handed(options: str) -> Example:
    """A node that hands itself to another module, which gets parameters of it."""
    return python({**dep117.FILES, "my_pkg/settings.py": HANDED, "my_pkg/talker.py": MAKES.format(options)})


PLACES = (
    "path = {}",
    "path = {}\n    print(path)",
    "path = open({})",
    "path: str = {}\n    print(locals())",
    "path = {}\n    path = 'a'\n    print(path)",
)
"""What becomes of a path in a function: nothing, or something."""
MEMBERS = ("", "\n        print(self.robot_file)")


def kept(files: dict[str, str | None], path: str) -> tuple[Example, ...]:
    """Modules that put a path into a variable of a function or a member."""
    share = f"{SHARE}\n\n\n"
    by_name = (f"def main():\n    {each.format(path)}\n" for each in PLACES)
    by_member = (
        f"class Talker:\n    def __init__(self):\n        self.robot_file = {path}{each}\n\n\n"
        "def main():\n    Talker()\n"
        for each in MEMBERS
    )
    return tuple(python({**files, "my_pkg/talker.py": f"{share}{each}"}) for each in (*by_name, *by_member))


GUARDED = "\n\nif __name__ == '__main__':\n    try:\n        main()\n    except {}:\n        pass\n"
OTHER = dep120.FILES | {"setup.py": setup_py(scripts("talker = my_pkg.other:main"))}


def guarded(files: dict[str, str | None], name: str) -> Example:
    """A module that catches something where it is started by its path."""
    other = {"my_pkg/other.py": "from .talker import main\n\nmain()\n"}
    return python({**files, **other, "my_pkg/talker.py": dep120.NODE + GUARDED.format(name)})


CASES = {
    "DEP113": (
        *(asking(PEOPLE, READS, each) for each in TESTS),
        *kept(PEOPLE, dep113.OPENS.format("people")),
    ),
    "DEP117": (
        *(asking(dep117.FILES, "msvcrt.getwch()", each) for each in TESTS),
        *(asking(dep117.FILES, "pass", each, "tty.setraw(0)") for each in TESTS),
    ),
    "DEP118": (
        *(asking(dep118.FILES, OPENS, each) for each in TESTS),
        *(holding(*each) for each in METHODS),
        *kept(dep118.FILES, "'/home/ada/ws/src/my_pkg/config/robot.yaml'"),
    ),
    "DEP120": (
        *(asking(dep120.FILES, "rclpy.spinn()", each) for each in TESTS),
        *(guarded(each, "rclpy.ROSInterruptException") for each in (dep120.FILES, OTHER)),
    ),
    "IDL010": (
        *(below(page, MADE) for page in PAGES),
        below("For Jazzy.\n", f"{MADE}msg = Status()\nmsg.batery = 1\n"),
    ),
    "PRM007": tuple(map(handed, OPTIONS)),
}
