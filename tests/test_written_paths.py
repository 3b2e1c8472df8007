"""DEP118: a path that code makes or writes by a name, a joined path, a parameter or a function of its own is missed
by nobody.
"""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, SETUP_PY_FOR_ALL, existing_files, manifest, scripts, setup_py
from rospkg_cli.testing import lint_files

PLACE = "/home/ada/ws/src/my_pkg/data"
PYTHON = {
    **existing_files(BACKDROPS["ament_python"]),
    "data/a.txt": "Ada\n",
    "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
}
NODE = """\
import os
import subprocess
from datetime import datetime
from pathlib import Path

import numpy as np
from rclpy.node import Node

{top}

class Talker(Node):
    def __init__(self):
        super().__init__('talker')
{start}

    def keep(self, row):
{keep}
{more}

def main():
    node = Talker()
    node.keep([1])
"""


def indented(lines: str) -> str:
    return "".join(f"        {each}\n" for each in lines.replace("PLACE", PLACE).splitlines()) or "        pass\n"


def python_level(start: str, keep: str, more: str = "", top: str = "") -> str:
    code = NODE.format(start=indented(start), keep=indented(keep), more=more, top=top.replace("PLACE", PLACE))
    (found,) = lint_files({**PYTHON, "my_pkg/talker.py": code}, ["DEP118"]).findings
    return found.severity.value


JOINED = "path = os.path.join(self.folder, 'log.csv')\n"
WRITES = "with open(path, 'a') as file:\n    file.write(str(row))"


@pytest.mark.parametrize(
    ("start", "keep"),
    [
        ("self.folder = 'PLACE'\nos.makedirs(self.folder, exist_ok=True)", JOINED + WRITES),
        ("self.folder = 'PLACE'", JOINED + WRITES),
        ("self.folder = 'PLACE'\nself.get_logger().info(f'writes to {self.folder}')", JOINED + WRITES),
        ("self.folder = Path('PLACE')\nself.folder.mkdir(parents=True, exist_ok=True)", ""),
        ("self.folder = Path('PLACE')", "with (self.folder / f'{row[0]}.csv').open('w') as file:\n    file.write('a')"),
        ("self.folder = Path('PLACE')", "(self.folder / 'a.txt').write_text(str(row))"),
        ("self.folder = 'PLACE'", "np.savetxt(self.folder + '/a.csv', row)"),
        ("self.folder = 'PLACE'", "np.save(f'{self.folder}/a.npy', row)"),
        (
            "self.declare_parameter('folder', 'PLACE')\n"
            "self.folder = self.get_parameter('folder').get_parameter_value().string_value\n"
            "os.makedirs(self.folder, exist_ok=True)",
            JOINED + WRITES,
        ),
        ("self.folder = self.declare_parameter('folder', 'PLACE').value", JOINED + WRITES),
        ("", "path = os.path.join('PLACE', f'{row[0]}.csv')\n" + WRITES),
        (
            "",
            "now = datetime.now()\nwith open(os.path.join('PLACE', f'{now}.csv'), 'w') as file:\n    file.write('')",
        ),
        ("self.folder = 'PLACE'\nself.path = f'{self.folder}/a.csv'\nself.file = open(self.path, mode='w')", ""),
        ("self.folder = 'PLACE'\nos.makedirs(self.folder, exist_ok=True)\nself.recorder = print\n", "use(self.folder)"),
        ("", "subprocess.run(['ros2', 'run', 'nav2_map_server', 'map_saver_cli', '-f', 'PLACE/office'])"),
        ("", "subprocess.Popen(['ros2', 'bag', 'record', '-a', '-o', 'PLACE/first'])"),
        ("", "request = SaveMap.Request()\nrequest.map_url = 'PLACE/office'"),
        ("", "self.map.call_async(SaveMap.Request(map_url='PLACE/office'))"),
        ("", "writer = SequentialWriter()\nwriter.open(StorageOptions(uri='PLACE/bag', storage_id='mcap'))"),
        ("self.map = 'PLACE/office'", "call('ros2 run nav2_map_server map_saver_cli -f %s' % self.map, shell=True)"),
        ("self.map = 'PLACE/office'", "call('ros2 run nav2_map_server map_saver_cli -f {}'.format(self.map))"),
        ("self.folder = 'PLACE'\nfor each in (self.folder, '/tmp/a'):\n    os.makedirs(each, exist_ok=True)", ""),
        ("", "shutil.copy('/tmp/a.txt', 'PLACE/a.txt')"),
        ("self.map = 'PLACE/office'", "os.system(f'ros2 run nav2_map_server map_saver_cli -f {self.map}')"),
    ],
)
def test_what_python_writes(start: str, keep: str) -> None:
    assert python_level(start, keep) == "info"


@pytest.mark.parametrize(
    ("start", "keep"),
    [
        ("self.folder = 'PLACE'", JOINED + "with open(path) as file:\n    file.read()"),
        ("self.folder = 'PLACE'", JOINED + "with open(path, 'r') as file:\n    file.read()"),
        ("self.folder = 'PLACE'\nos.makedirs(self.folder, exist_ok=True)", JOINED + "row = open(path).read()"),
        ("self.folder = 'PLACE'", JOINED + "use(path)"),
        ("self.folder = 'PLACE'", JOINED + WRITES + "\nuse(self.folder)"),
        ("self.folder = Path('PLACE')", "(self.folder / 'a.txt').read_text()"),
        (
            "self.declare_parameter('folder', 'PLACE')\nself.folder = self.get_parameter('folder').value",
            "use(self.folder)",
        ),
        ("self.folder = 'PLACE'", "return self.folder"),
        ("", "subprocess.run(['ros2', 'run', 'nav2_map_server', 'map_server', '-f', 'PLACE/office'])"),
        ("", "request = LoadMap.Request()\nrequest.map_url = 'PLACE/office'"),
        ("", "shutil.copy('PLACE/a.txt', '/tmp/a.txt')"),
        ("self.folder = 'PLACE'\nself.logs = {'a': self.folder}", JOINED + WRITES),
    ],
)
def test_what_python_may_read(start: str, keep: str) -> None:
    assert python_level(start, keep) == "warning"


HELPER = """
    def put(self, row, path):
        with open(path, {mode!r}) as file:
            print(row, file=file)
"""
PATH_OF = """
    def path_of(self, name):
        return os.path.join(self.folder, name)
"""


@pytest.mark.parametrize(
    ("keep", "mode", "expected"),
    [
        ("self.put(row, os.path.join(self.folder, 'a'))", "w", "info"),
        ("self.put(row, path=self.folder + '/a')", "w", "info"),
        ("self.put(row, os.path.join(self.folder, 'a'))", "r", "warning"),
        ("self.put(row, self.path_of('a'))", "w", "info"),
        ("self.put(row, self.path_of('a'))", "r", "warning"),
    ],
)
def test_a_function_of_its_own(keep: str, mode: str, expected: str) -> None:
    more = HELPER.format(mode=mode) + (PATH_OF if "path_of" in keep else "")
    assert python_level("self.folder = 'PLACE'", keep, more) == expected


@pytest.mark.parametrize(("mode", "expected"), [("w", "info"), ("r", "warning")])
def test_a_constant_of_the_module(mode: str, expected: str) -> None:
    keep = f"open(os.path.join(BASE, 'a.csv'), '{mode}')"
    assert python_level("", keep, top="BASE = 'PLACE'") == expected
    keep = f"open(os.path.join(folder, 'a.csv'), '{mode}')"
    more = f"\n    def more(self, folder='{PLACE}'):\n{indented(keep)}"
    assert python_level("self.more()", "", more) == expected


CPP = """\
#include <filesystem>
#include <fstream>
#include <rclcpp/rclcpp.hpp>

class Talker : public rclcpp::Node
{{
public:
  Talker() : Node("talker")
  {{
    {start}
    keep();
  }}

  ~Talker() override
  {{
    if (is_on_) {{
      end();
    }}
  }}

private:
  void keep()
  {{
    {keep}
  }}

  std::string folder_{{"/tmp/talker"}};
}};

int main(int argc, char ** argv)
{{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Talker>());
}}
"""


def cpp_level(start: str, keep: str) -> str:
    build = CMAKE.replace("ament_package", "add_executable(node src/node.cpp)\nament_package")
    code = CPP.format(start=start, keep=keep).replace("PLACE", PLACE)
    files = {"package.xml": manifest("", "ament_cmake"), "CMakeLists.txt": build, "data/a.txt": "Ada\n"}
    (found,) = lint_files({**files, "src/node.cpp": code}, ["DEP118"]).findings
    return found.severity.value


GIVEN = 'folder_ = declare_parameter<std::string>("folder", std::string("PLACE"));\n'
MADE = "std::filesystem::create_directories(folder_);\n"
OPENS = 'const std::string path = folder_ + "/a.csv";\n    std::ofstream out(path);'


@pytest.mark.parametrize(
    ("start", "keep"),
    [
        (GIVEN + MADE, OPENS),
        (GIVEN + MADE + 'RCLCPP_INFO(get_logger(), "to %s", folder_.c_str());', "save(figure, folder_);"),
        (GIVEN, OPENS),
        ('folder_ = "PLACE";', 'std::ofstream out; out.open(folder_ + "/a.csv", std::ios::app);'),
        ('folder_ = "PLACE";', 'std::string path; path = folder_ + "/a.csv"; out = fopen(path.c_str(), "w");'),
        ('declare_parameter("out", "PLACE"); get_parameter("out", folder_);', OPENS),
        ('declare_parameter("out", "PLACE"); folder_ = this->get_parameter("out").as_string();', OPENS),
        ("", 'std::filesystem::path base{"PLACE"}; cv::imwrite((base / "a.png").string(), image);'),
        ("", 'auto a = std::make_shared<nav2_msgs::srv::SaveMap::Request>(); a->map_url = "PLACE/office";'),
        ('folder_ = "PLACE";', 'std::ostringstream name; name << folder_ << "/a.csv"; std::ofstream out(name.str());'),
        ("", 'std::string name("PLACE"); std::cout << name << std::endl; std::ofstream out(name + "/a");'),
    ],
)
def test_what_cpp_writes(start: str, keep: str) -> None:
    assert cpp_level(start, keep) == "info"


@pytest.mark.parametrize(
    ("start", "keep"),
    [
        (GIVEN, 'std::ifstream in(folder_ + "/a.csv");'),
        (GIVEN + MADE, 'std::ifstream in(folder_ + "/a.csv");'),
        (GIVEN, "use(folder_);"),
        ('folder_ = "PLACE";', 'in_ = fopen((folder_ + "/a").c_str(), "r");'),
        ('folder_ = "PLACE";', "return folder_;"),
        ('folder_ = "PLACE";', 'std::stringstream name; name << folder_ << "/a.csv"; use(name.str());'),
        ("", 'std::filesystem::path base{"PLACE"}; auto image = cv::imread((base / "a.png").string());'),
    ],
)
def test_what_cpp_may_read(start: str, keep: str) -> None:
    assert cpp_level(start, keep) == "warning"


LAUNCH = f"""\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess
from launch.substitutions import LaunchConfiguration


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('bag', default_value='{PLACE}'),
        ExecuteProcess(cmd=['ros2', 'bag', COMMAND, LaunchConfiguration('bag')]),
    ])
"""


@pytest.mark.parametrize(("command", "expected"), [("'record', '-a', '-o'", "info"), ("'play'", "warning")])
def test_a_bag_that_launch_records(command: str, expected: str) -> None:
    files = {**PYTHON, "setup.py": SETUP_PY_FOR_ALL, "launch/a.launch.py": LAUNCH.replace("COMMAND", command)}
    (found,) = lint_files(files, ["DEP118"]).findings
    assert found.severity.value == expected


SETTINGS = f"talker:\n  ros__parameters:\n    row: {PLACE}/a.txt\n"
STARTS = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package='my_pkg', executable='talker', parameters=['config/a.yaml'])])
"""


@pytest.mark.parametrize(("mode", "expected"), [("w", "info"), ("r", "warning")])
def test_a_value_of_yaml_at_which_the_node_writes(mode: str, expected: str) -> None:
    start = "self.declare_parameter('row', '')\nself.path = self.get_parameter('row').value"
    code = NODE.format(start=indented(start), keep=indented(f"open(self.path, '{mode}')"), more="", top="")
    files = {**PYTHON, "my_pkg/talker.py": code, "config/a.yaml": SETTINGS, "launch/a.launch.py": STARTS}
    starts = "    entry_points={'console_scripts': ['talker = my_pkg.talker:main']},\n    license"
    setup = SETUP_PY_FOR_ALL.replace("    license", starts)
    found = lint_files({**files, "setup.py": setup}, ["DEP118"]).findings
    assert [each.severity.value for each in found] == [expected]


def test_many_paths_are_not_followed() -> None:
    lines = "".join(f"p{n} = 'PLACE/{n}.txt'\nopen(p{n}, 'w')\n" for n in range(30))
    assert python_level(lines, "") == "warning"
    assert python_level(lines.partition("p20")[0], "") == "info"
