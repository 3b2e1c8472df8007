"""DEP118: who meets a path in one person's home, and who has it replaced or never comes to it."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, SETUP_PY_FOR_ALL, existing_files, manifest, scripts, setup_py
from rospkg_cli.testing import lint_files

PACKAGE = {**existing_files(BACKDROPS["ament_python"]), "data/a.txt": "Ada\n"}
PLACE = "/home/ada/ws/src/my_pkg/data/a.txt"
PROGRAMS = setup_py(scripts("talker = my_pkg.talker:main", "trainer = my_pkg.trainer:main"))
TRAINER = f"def main():\n    a = open('{PLACE}')\n    return a\n"
TALKER = "def main():\n    pass\n"
ARGUMENT = f"""\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, LogInfo
from launch.substitutions import LaunchConfiguration


def generate_launch_description():
    model = LaunchConfiguration('model')
    return LaunchDescription([DeclareLaunchArgument('model', default_value='{PLACE}'), LogInfo(msg=model)])
"""
XML = f'<launch>\n  <arg name="model" default="{PLACE}"/>\n  <log message="$(var model)"/>\n</launch>\n'
CALLER = '<launch>\n  <include file="$(find-pkg-share my_pkg)/launch/{}">\n{}  </include>\n</launch>\n'
GIVES = '    <arg name="model" value="$(env MODEL)"/>\n'
RUNS = "Run `ros2 launch my_pkg {}`.\n"


def level(files: dict[str, str]) -> str:
    (found,) = lint_files({**PACKAGE, **files}, ["DEP118"]).findings
    return found.severity.value


@pytest.mark.parametrize(
    ("page", "expected"),
    [
        ("Run `ros2 run my_pkg talker`.\n", "info"),
        ("Run `ros2 run my_pkg trainer`.\n", "warning"),
        ("", "warning"),  # nothing shows how programs are started here
    ],
)
def test_a_program_that_nothing_starts_beside_others(page: str, expected: str) -> None:
    code = {"my_pkg/talker.py": TALKER, "my_pkg/trainer.py": TRAINER}
    assert level({**code, "setup.py": PROGRAMS, "README.md": page}) == expected


def test_what_goes_on_without_the_file() -> None:
    opens = f"    a = open('{PLACE}')\n"
    start = setup_py(scripts("talker = my_pkg.talker:main"))
    guarded = f"    try:\n    {opens}    except OSError:\n        a = None\n    print(a)\n"
    assert level({"setup.py": start, "my_pkg/talker.py": f"def main():\n{guarded}"}) == "info"
    assert level({"setup.py": start, "my_pkg/talker.py": f"def main():\n{opens}    print(a)\n"}) == "warning"


@pytest.mark.parametrize(("name", "text"), [("a.launch.py", ARGUMENT), ("a.launch.xml", XML)])
def test_an_argument_that_all_callers_give(name: str, text: str) -> None:
    own = {"setup.py": SETUP_PY_FOR_ALL, f"launch/{name}": text}
    gives, leaves = CALLER.format(name, GIVES), CALLER.format(name, "")
    assert level(own) == "warning"
    assert level({**own, "launch/b.launch.xml": gives}) == "info"
    assert level({**own, "launch/b.launch.xml": leaves}) == "warning"
    assert level({**own, "launch/b.launch.xml": gives, "README.md": RUNS.format(name)}) == "warning"
    assert level({**own, "README.md": RUNS.format(f"{name} model:=b.pt")}) == "info"


@pytest.mark.parametrize(
    ("setup", "page", "expected"),
    [
        (setup_py(), "", "info"),
        (setup_py(), "Run `ros2 launch launch/a.launch.py`.\n", "warning"),
        (SETUP_PY_FOR_ALL, "", "warning"),
    ],
)
def test_a_launch_file_that_nothing_installs_or_names(setup: str, page: str, expected: str) -> None:
    assert level({"setup.py": setup, "launch/a.launch.py": ARGUMENT, "README.md": page}) == expected


def test_a_twin_in_another_language() -> None:
    own = {"setup.py": SETUP_PY_FOR_ALL, "launch/a.launch.xml": XML, "launch/a.launch.py": "A = 1\n"}
    assert level(own) == "warning"
    assert level({**own, "README.md": RUNS.format("a.launch.py")}) == "info"
    assert level({**own, "README.md": RUNS.format("a.launch.xml")}) == "warning"


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("np.save({}, 1)", "info"),
        ("plt.savefig({})", "info"),
        ("open({}, 'w')", "info"),
        ("open({}, mode='a')", "info"),
        ("logging.FileHandler({})", "info"),
        ("cv2.imwrite(filename={}, img=1)", "info"),
        ("cv2.imread(filename={})", "warning"),
        ("output_dir = {}\n    print(output_dir)", "info"),
        ("self.declare_parameter('log_file', {})", "info"),
        ("place = {}\n    frame.to_csv(place)", "info"),
        ("place = {}\n    frame.to_csv(place)\n    print(place)", "info"),
        ("place = {}\n    frame.to_csv(place)\n    use(place)", "warning"),
        ("np.load({})", "warning"),
        ("open({}, 'r')", "warning"),
        ("catalog = {}\n    print(catalog)", "warning"),
        ("login = {}\n    print(login)", "warning"),
    ],
)
def test_what_is_written_and_not_read(line: str, expected: str) -> None:
    start = setup_py(scripts("talker = my_pkg.talker:main"))
    code = f"def main():\n    {line.format(repr(PLACE))}\n"
    assert level({"setup.py": start, "my_pkg/talker.py": code}) == expected


def test_what_is_written_says_so() -> None:
    start = setup_py(scripts("talker = my_pkg.talker:main"))
    code = f"def main():\n    open('{PLACE}', 'w')\n"
    (found,) = lint_files({**PACKAGE, "setup.py": start, "my_pkg/talker.py": code}, ["DEP118"]).findings
    assert found.message.endswith("; something writes it, and misses no file")


@pytest.mark.parametrize(("name", "text"), [("a.launch.py", ARGUMENT), ("a.launch.xml", XML)])
def test_an_argument_that_nothing_reads(name: str, text: str) -> None:
    own = {"setup.py": SETUP_PY_FOR_ALL}
    unread = text.replace("LogInfo(msg=model)", "").replace("$(var model)", "a").replace("model = L", "other = L")
    assert level({**own, f"launch/{name}": text}) == "warning"
    assert level({**own, f"launch/{name}": unread}) == "info"


def test_a_variable_that_only_an_argument_of_no_use_has() -> None:
    text = ARGUMENT.replace(f"'{PLACE}'", "place").replace("    model =", f"    place = '{PLACE}'\n    model =")
    unread = text.replace(", LogInfo(msg=model)", "")
    for each, expected in ((text, "warning"), (unread, "info"), (unread.replace("[D", "[print(place), D"), "warning")):
        assert level({"setup.py": SETUP_PY_FOR_ALL, "launch/a.launch.py": each}) == expected


def test_what_an_included_file_does_not_take() -> None:
    own = {"setup.py": SETUP_PY_FOR_ALL, "launch/b.launch.xml": XML.replace(PLACE, "a")}
    for name, expected in (("model", "warning"), ("models", "info")):
        gives = f'    <arg name="{name}" value="{PLACE}"/>\n'
        assert level({**own, "launch/a.launch.xml": CALLER.format("b.launch.xml", gives)}) == expected


def test_a_launch_file_that_says_it_is_given_up() -> None:
    for name, expected in (("a.launch.xml", "warning"), ("deprecated_a.launch.xml", "info")):
        assert level({"setup.py": SETUP_PY_FOR_ALL, f"launch/{name}": XML}) == expected


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        ('list(APPEND CMAKE_PREFIX_PATH "/home/ada/ws/install/my_pkg")\n', "info"),
        ("set(CMAKE_PREFIX_PATH ${CMAKE_PREFIX_PATH}\n  /home/ada/ws/install/my_pkg)\n", "info"),
        ("set(model /home/ada/ws/src/my_pkg/src)\n", "warning"),
    ],
)
def test_one_more_place_for_packages(lines: str, expected: str) -> None:
    files = {"package.xml": manifest("", "ament_cmake"), "src/node.cpp": "int main() {return 0;}\n"}
    files |= {"CMakeLists.txt": CMAKE.replace("ament_package", f"{lines}ament_package")}
    (found,) = lint_files(files, ["DEP118"]).findings
    assert found.severity.value == expected


NODE = f"""\
#include <rclcpp/rclcpp.hpp>
class Talker : public rclcpp::Node {{
public:
  Talker() : Node("talker") {{ START }}
  void read() {{ load("{PLACE}"); }}
}};
int main() {{ return 0; }}
"""


@pytest.mark.parametrize(("start", "expected"), [("", "info"), ("read();", "warning")])
def test_a_function_of_a_cpp_node_that_nothing_calls(start: str, expected: str) -> None:
    build = CMAKE.replace("ament_package", "add_executable(node src/node.cpp)\nament_package")
    files = {"package.xml": manifest("", "ament_cmake"), "CMakeLists.txt": build, "data/a.txt": "Ada\n"}
    (found,) = lint_files({**files, "src/node.cpp": NODE.replace("START", start)}, ["DEP118"]).findings
    assert found.severity.value == expected
    assert ("nothing here leads to this function" in found.message) == (expected == "info")
