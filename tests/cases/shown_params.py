"""Sentences and silences of the rules for parameter files and definitions of parameters."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example
from rospkg_cli.rules.params import prm009_invalid_parameter_library as prm009

INSTALLED = CMAKE.replace("ament_package", "install(DIRECTORY config DESTINATION share/${PROJECT_NAME})\nament_package")
NODE = "talker:\n  ros__parameters:\n"


def config(text: str) -> Example:
    return Example(bad={"config/robot.yaml": text}, good={}, on="config")


def values(*lines: str) -> Example:
    return config(NODE + "".join(f"    {line}\n" for line in lines))


def called_text(*names: str) -> str:
    return "".join(f"{name}:\n  ros__parameters:\n    a: 1\n" for name in names)


def called(*names: str) -> Example:
    return config(called_text(*names))


CONTROLLED = "controller_manager:\n  ros__parameters:\n    {}: {{type: my_pkg/Wheel}}\n"


def controlled(listed: str, *names: str) -> Example:
    return config(CONTROLLED.format(listed) + called_text(*names))


PARSED = """\
import os

import yaml
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    share = get_package_share_directory('my_pkg')
    with open(os.path.join(share, 'config', 'robot.yaml')) as f:
        values = {}
    return LaunchDescription([Node(package='my_pkg', executable='talker', parameters=[{}])])
"""
PANEL = "talker:\n  ros__parameters:\n    a: 1\npanel:\n  width: 3\n"


def parsed(loads: str, *given: str, text: str = PANEL, file: str = "config/robot.yaml") -> Example:
    """A package whose launch file opens a YAML file, and a node that gets values of it, or a path."""
    entry = "".join(f"share + '{path}'" for path in given) or "values"
    return Example(bad={file: text, "launch/a.launch.py": PARSED.format(loads, entry)}, good={}, on="config")


MIXED = "talker:\n  ros__parameters:\n    a: [1, 2.5]\n"
LOADING = (
    {"launch__a_DOT_launch_DOT_xml": "<launch/>\n"},
    {"launch__a_DOT_launch_DOT_xml": "<launch>\n  <arg name='a' default='config/robot.yaml'/>\n</launch>\n"},
    {"launch__a_DOT_launch_DOT_xml": "<launch>\n  <arg name='a' default='robot'/>\n</launch>\n"},
    {
        "launch__a_DOT_launch_DOT_xml": "<launch>\n  <arg name='a' default='robot'/>\n</launch>\n",
        "launch__b_DOT_launch_DOT_xml": "<launch>\n  <arg name='b' default='$(var a).yaml'/>\n</launch>\n",
    },
    {"launch__a_DOT_launch_DOT_py": "def generate_launch_description():\n    return []  # 'robot.yaml'\n"},
    {"launch__a_DOT_launch_DOT_py": "def generate_launch_description():\n    return [f('robot.yaml')]\n"},
    {"launch__a_DOT_launch_DOT_xml": "<launch/>\n", "README_DOT_md": "Wheels are in config/robot.yaml\n"},
    {"launch__a_DOT_launch_DOT_xml": "<launch/>\n", "README_DOT_md": "ros2 run a b --params-file config/robot.yaml\n"},
    {"my_pkg__a_DOT_py": "DATA = YAML().load(open('robot.yaml'))\n"},
    {"my_pkg__a_DOT_py": "DATA = read(open('robot.yaml'))\n"},
    {
        "my_pkg__a_DOT_py": "DATA = yaml.load(open('robot.yaml'))\n",
        "launch__a_DOT_launch_DOT_xml": "<launch>\n  <arg name='a' default='config/robot.yaml'/>\n</launch>\n",
    },
    {"launch__a_DOT_launch_DOT_xml": "<launch/>\n", "run_DOT_sh": "ros2 param load /talker 'config/robot.yaml'\n"},
)


def launched(**files: str) -> Example:
    """A package that launches something, and has a parameter file that rcl refuses."""
    paths = {name.replace("__", "/").replace("_DOT_", "."): each for name, each in files.items()}
    return Example(bad={"config/robot.yaml": MIXED, **paths}, good={}, on="config")


NUMBERS = (
    "1e-9",
    "1E9",
    "+1e9",
    "-1.e9",
    ".5e3",
    "1.5e+3",
    "1.5e3",
    "nan",
    "Inf",
    "-inf",
    "+INF",
    ".nan",
    ".inf",
    "1_000",
    "0b11",
    "1:30",
    "0x_1",
    "010",
    "-010",
    "+010",
    "00",
    "0",
    "08",
    "-09",
    "0o17",
    "0x1f",
    "0x1F",
    "1.",
    "-.5",
    "e5",
    "01e5",
    "010.5",
    "1_0.5",
    "[1e-9, 1e-8, 2]",
    "[010, 1_0]",
    "'010'",
    "!!str 010",
    "$(var x)",
    "12:30:45",
    "1__0",
    "190:20:30.15",
    "1_000.5",
    "0x1p3",
    "infinity",
    "[1.5, 1e5]",
)


def defined(*lines: str) -> Example:
    text = "talker:\n" + "".join(f"  p{number}: {{{each}}}\n" for number, each in enumerate(lines))
    return library(text)


def library(text: str) -> Example:
    return Example(bad={**prm009.FILES, "src/parameters.yaml": text}, good={}, on="ament_cmake")


TALKER = """\
class Talker : public rclcpp::Node
{
public:
  Talker() : Node("talker")
  {
    declare_parameter("rate", 10.0);
    declare_parameter("depth", 5);
    declare_parameter("global_frame", "map");
    declare_parameter("verbose", false);
    declare_parameter<std::vector<std::string>>("frames", {"map"});
    declare_parameter<std::vector<double>>("gains", {1.0});
    declare_parameter("arm.speed", 1.0);
MORE  }
};
"""
GIVEN = "    verbose: true\n    global_frame: odom\n    frames: [a]\n    arm.speed: 1.0\n"
SEGMENTS = """\
    declare_parameter("segmentation.min_points", 5);
    declare_parameter("segmentation.distance", 5);
    declare_parameter("segmentation.width", 5);
"""
SEGMENTED = "    segmentation.distance: 1\n    segmentation.width: 1\n"
VALUES = (
    "rate: 5", "rate: [1.0]", "rate: '5'", "rate: 5.0", "rate: 0x10", "rate: -5", "rate: $(var x)", "rate:",
    "depth: 5.0",
    "depth: true", "gains: [1, 2]", "gains: [1, 2.5]", "gains: 1", "gains: 1.0", "gains: []", "frames: x",
    "frames: [1]",
    "frames: [[x]]", "arm: {speed: 1}", "rate: [1, 0x2]",
)  # fmt: skip


def talker(*lines: str, code: str = "", given: str = GIVEN) -> Example:
    """A node that declares parameters, and a file that sets some."""
    text = NODE + given + "".join(f"    {line}\n" for line in lines)
    files = {"include/my_pkg/talker.hpp": TALKER.replace("MORE", code), "config/robot.yaml": text}
    return Example(bad=files, good={}, on="config")


def gets(*calls: str, more: str = "") -> Example:
    return talker(code="".join(f"    {call};\n" for call in calls) + more)


def got_elsewhere(*calls: str) -> Example:
    """Another file of the package gets all that this one declares."""
    names = ("rate", "depth", "global_frame", "verbose", "frames", "gains", "arm.speed")
    others = "\n".join(f'  get_parameter("{name}");' for name in names)
    example = gets(*calls)
    other = TALKER.partition("    declare")[0].replace("Talker", "Listener") + others + "\n  }\n};\n"
    return Example(bad={**example.bad, "include/my_pkg/listener.hpp": other}, good={}, on="config")


CASES = {
    "PRM002": (
        values("a: 1", "a: 1", "b: {c: 1}", "b: {d: 1}", "e.f: 1", "e: {f: 2}", "g: 1", "g: '1'", "h: [1]", "h: [1]",
               "i: False", "i: false", "j: False", "j: true", "k: 0", "k: false"),
        config(NODE + "    a: 1\ntalker:\n  ros__parameters:\n    a: 1\n---\n" + NODE + "    a: 2\n"),
        config(NODE + "    a: 1\n/talker:\n  ros__parameters:\n    a: 2\n/**:\n  ros__parameters:\n    a: 3\n"),
    ),
    "PRM006": (
        *(talker(line) for line in VALUES),
        talker("verbose: 1", "global_frame: 5", given=""),
        talker("rate: 5", given=""),
        talker("rate: 5", given="    x: 1\n    y: 2\n"),
    ),
    "PRM007": (
        *(Example(on="ament_cmake", good={}, bad={
            "src/a.cpp": "int main() {return 0;}\n",
            "src/b.cpp": TALKER.replace("MORE", '    get_parameter("verbos");\n'),
            "CMakeLists.txt": CMAKE.replace("ament_package", f"add_executable(a {file})\nament_package"),
        }) for file in ("src/a.cpp", "src/b.cpp")),
        config("controller_server:\n  ros__parameters:\n    goal_checker_plugin: x\n    use_sim_tme: true\n"),
        *(talker(line) for line in ("ratee: 5.0", "rat: 5", "rate: 5.0\n    ratee: 5.0", "gians: 1.0", "gians: [1.0]",
                 "nothing: 1",
                                    "arm.sped: 1.0", "use_sim_time: true", "qos_overrides.x: 1", "depht: x",
                                    "'depht': 1")),
        *(talker(f"segmentation.{name}: 1", code=SEGMENTS, given=SEGMENTED) for name in (
          "min_points_segment", "segmentation_min_points", "segment", "min_points", "max_points_segment",
          "min_seg_points", "segment_min_points_x", "min_points_segment: 1\n    segmentation.min_points")),
        talker("min_points_segment: 1", code=SEGMENTS),
        talker("arm: {sped: 1.0}", given="    verbose: true\n    rate: 1.0\n    depth: 1\n"),
        talker("ratee: 5.0", *(f"/robot{number}/map/x: 1.0" for number in range(9)),
               given="    verbose: true\n    depth: 1\n"),
        gets('get_parameter("verbos", verbose_)', 'get_parameter("rate")'),
        gets('get_parameter("verbos")'),
        *(got_elsewhere(f'get_parameter("{name}")', *more)
          for name, more in (("verbsoe", ()), ("verbosity", ()), ("verbsoe", ('get_parameter("verbose")',)))),
        gets('get_parameter("verbos")', more="    try {} catch (...) {}\n"),
        gets('get_parameter("verbos")', 'has_parameter("verbos")'),
        gets('get_parameter("nothing")'),
        gets(*(f'get_parameter("{name}")' for name in ("rate", "depth", "global_frame", "frames", "gains", "arm.speed",
             "other"))),
        gets('get_parameter("verbos")', more="    options.allow_undeclared_parameters(true);\n"),
    ),
    "PRM001": (
        config("talker:\n  ros_parameters:\n    a: 1\n"
               "listener:\n  ros__paramters: {a: 1}\nother:\n  Ros__Parameters:\n"),
        config("talker:\n  a: 1\n  b:\n    c: 1\n\n  # more\n  d: [1]\n"),
        *(parsed(loads, *more) for loads, *more in (("yaml.safe_load(f)",), ("f.read()",),
          ("yaml.load(f)", "/robot.yaml"), ("safe_load(f)", "/other.yaml"))),
        parsed("yaml.safe_load(f)", file="config/other.yaml"),
        parsed("yaml.safe_load(f)", text="talker:\n  ros_parameters:\n    a: 1\n"),
        config("talker: {a: 1}\nns:\n  talker:\n    a: 1\n"),
        config("talker:   {a: 1,\n  b: 2}\n? [x]\n: 1\ntalker2:\n  a: 1 # one\n"),
    ),
    "PRM004": (
        *(parsed(loads, text="talker:\n  ros__parameters:\n    a: [1, 2.5]\n")
          for loads in ("yaml.safe_load(f)", "f.read()")),
        *(launched(**each) for each in LOADING),
        *(Example(bad={**files, path: NODE + "    a: [1, 2.5]\n"}, good={}, on="ament_cmake") for files, path in (
            ({}, "config/robot.yaml"), ({"CMakeLists.txt": INSTALLED}, "config/robot.yaml"),
            ({"CMakeLists.txt": INSTALLED}, "config/robot_example.yaml"))),
        config("- a\n- b\n"),
        config("just text\n"),
        config("[x]: 1\ntalker:\n  ros__parameters:\n    a: 1\n  after: 1\n"),
        config("ros__parameters:\n  a: 1\n"),
        config(NODE + "    a: 1\n  ros__parameters:\n    b: 1\n"),
        config("talker:\n  ros__parameters:\n"),
        config("talker:\n  ros__parameters: ''\n"),
        config("talker:\n  ros__parameters: [1]\n"),
        config("talker:\n  ros__parameters: {}\n"),
        config("version: 2\nempty:\nanchored: &x 1\naliased: *x\n"
               "talker:\n  a: 1\n  b:\n  ros__parameters:\n    c: 1\n"),
        called("/**", "/*", "**", "*", "/", "a/", "//a", "/a//b", "a//b", "/a/b", "a/b", "9a", "/9/b", "a-b", "/**/a",
               "_a",
               "$(var x)", "a/$(var x)", "n" * 255, "m" * 256, "/ns/" + "k" * 256, '""'),
        config("/ns:\n  talker:\n    ros__parameters:\n      a: 1\n"
               "ns/:\n  talker:\n    ros__parameters:\n      a: 1\n"),
        values("a:", "b: ''", "c: ~", "'': 1", "[x]: 1", "d: {}", "e: {f: {}}", "g: 1"),
        values("a: 1", "b: {}"),
        values("a: &x 1", "b: *x", "c: [*x]", "d: {e: *x}"),
        values("a: []", "b: [1, 2.5]", "c: [1, x]", "d: [1, true]", "e: [1.5, '2']", "f: [true, yes]", "g: [x, 'y']",
               "h: [[1]]", "i: [{a: 1}, {b: 2}]", "j: [1, ]", "k: [1, '']", "l: [$(var x), 1, true]", "m: [1, 0x1f]",
               "n: [2.5, 1]", "o: [true, x]", "p: [1, 2.5, x]", "q: [~, 1]", "r: [y, 1]"),
        values("a:", "- 1", "-", "b:", "- - 1"),
        values("a: [{b: 1}]", "c: [{d: [1, 2.5]}]"),
    ),
    "PRM005": (values(*(f"p{number}: {each}" for number, each in enumerate(NUMBERS))),),
    "PRM003": (
        called("controller_managr", "contoller_server"),
        called("controller_managr", "controller_manager"),
        called("planer_servr", "map_sever", "map_server_2", "amc", "/ns/map_serve", "map_seve$(var x)"),
        *(controlled(listed, *names) for listed, names in (
            ("left_wheel", ("left_whel", "left_wheeel")), ("left_wheel", ("left_wheel", "left_whel")),
            ("arm_1", ("arm_2",)), ("left_wheel", ("right_wheel",)), ("map_servr", ("map_servr",)))),
        Example(bad={"config/robot.yaml": CONTROLLED.format("left_wheel") + called_text("left_whel"),
                     "launch/a.launch.xml": '<launch>\n  <let name="a" value="left_whel"/>\n</launch>\n'},
                good={}, on="config"),
    ),
    "PRM009": (
        defined("default_value: 1", "type: int", "type: int, deflt: 1", "type: itn", "type: something",
                "type: int_array",
                "type: none", "type: int, default_value: 1.5", "type: int, default_value: x",
                "type: double, default_value: 1",
                "type: double, default_value: 1.5", "type: bool, default_value: yes", "type: bool, default_value: y",
                "type: bool, default_value: 'true'", "type: string, default_value: 1",
                "type: string, default_value: '1'",
                "type: string, default_value: on", "type: string, default_value: y", "type: int, default_value: ~",
                "type: int_array, default_value: [1, 2.5, x]", "type: int_array, default_value: 1",
                "type: int_array, default_value: ~", "type: string_array, default_value: [[a]]", "type: bool_array",
                "type: double_array, default_value: [1, 2.5]", "type: int, default_value: [1]",
                "type: string, default_value: ",
                "type: none, default_value: x", "type: string_array, default_value: []",
                "type: double, default_value: '1.5'", "type: int, default_value: !!str 1"),
        defined(*(f"type: double, validation: {{{each}}}" for each in (
            "bounds: [0, 1]", "bounds<>: [0, 1]", "bouds<>: [0, 1]", "gt_eq<>: [0]", "mine: 1", "my_ns::mine: 1",
            "my_ns::boundz<>: 1", "[x]: 1", "not_empty<>: []", "upper_bound<>: 1")),
            "type: int, validation: 1"),
        library("- a\n"),
        library("a: {b: {type: int}}\nc: {d: {type: int}}\n"),
        library("text\n"),
        library(""),
    ),
}  # fmt: skip
