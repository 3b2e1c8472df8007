"""Single slips in whole packages, where another file or line makes little certain."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, INTERFACES_CMAKE, manifest, scripts, setup_py
from rospkg_cli.testing import lint_files

PLUGIN = "#include <pluginlib/class_list_macros.hpp>\n\nPLUGINLIB_EXPORT_CLASS(a::Arm, a::Base)\n"
DESCRIPTION = '<library path="other">\n  <class name="a/Arm" type="a::Arm" base_class_type="a::Base"/>\n</library>\n'
TESTING = "if(BUILD_TESTING)\n  find_package(ament_lint_auto REQUIRED)\n  {}()\nendif()\n"


def said(files: dict[str, str], *codes: str) -> list[str]:
    """Return codes and levels."""
    return [f"{each.code} {each.severity.value}" for each in lint_files(files, codes).findings]


def cmake(lines: str) -> dict[str, str]:
    text = CMAKE.replace("ament_package", f"{lines}ament_package")
    return {"package.xml": manifest("", "ament_cmake"), "CMakeLists.txt": text}


@pytest.mark.parametrize(
    "name, expected", [("words", []), ("wrods", ["DEP109 error"]), ("sentences", []), ("word", [])]
)
def test_an_own_module_where_the_path_is_changed(clean, name: str, expected: list[str]) -> None:
    talker = f"import sys\n\nfrom my_pkg.{name} import A\n\nsys.path.append('/opt')\n\n\ndef main():\n    print(A)\n"
    setup = {"setup.py": setup_py(scripts("talker = my_pkg.talker:main")), "my_pkg/words.py": "A = 1\n"}
    assert said({**clean, **setup, "my_pkg/talker.py": talker}, "DEP109") == expected


@pytest.mark.parametrize(
    "name, expected",
    [
        ("frame_id", []),
        ("farme_id", ["PRM007 error"]),
        ("frame", ["PRM007 warning"]),
        ("other", ["PRM007 warning"]),
    ],
)
def test_a_parameter_that_another_module_gets(clean, name: str, expected: list[str]) -> None:
    node = (
        "import rclpy.node\n\n\nclass Node(rclpy.node.Node):\n    def __init__(self):\n        super().__init__('a')\n"
        "        self.declare_parameter('frame_id', 'map')\n        self.frame = self.get_parameter('{}').value\n"
    )
    files = {"my_pkg/a.py": node.format(name), "my_pkg/b.py": node.format("frame_id")}
    needed = manifest("  <exec_depend>rclpy</exec_depend>\n")
    assert said({**clean, **files, "package.xml": needed}, "PRM007") == expected


@pytest.mark.parametrize("target, expected", [("talker_lib", []), ("takler_lib", ["CMK108 error"]), ("other", [])])
def test_the_library_of_a_component_where_files_are_unknown(target: str, expected: list[str]) -> None:
    lines = (
        "include(${OTHER_FILE})\nadd_library(talker_lib SHARED a.cpp)\n"
        f'rclcpp_components_register_nodes({target} "a::Talker")\n'
    )
    source = "#include <rclcpp_components/register_node_macro.hpp>\nRCLCPP_COMPONENTS_REGISTER_NODE(a::Talker)\n"
    assert said({**cmake(lines), "a.cpp": source}, "CMK108") == expected


@pytest.mark.parametrize(
    "words, expected",
    [("base arm.xml", ["CMK202 info"]), ("base arm.cpp", []), ("base arm", []), ("base arm.xmlx", [])],
)
def test_a_source_whose_description_is_named(words: str, expected: list[str]) -> None:
    lines = f"add_library(other SHARED other.cpp)\npluginlib_export_plugin_description_file({words})\n"
    files = {**cmake(lines), "other.cpp": "\n", "src/arm.cpp": PLUGIN, "arm.xml": DESCRIPTION}
    assert said(files, "CMK202") == expected


@pytest.mark.parametrize(
    "files, expected",
    [
        ('  "msg/Status.msg"\n  "srv/SetMode.srv"\n', []),
        ("", ["IDL005 error"]),
        ("  ${own_files}\n", []),
        ("  DEPENDENCIES ${PROJECT_NAME}_more\n", ["IDL005 error"]),
    ],
)
def test_a_call_that_names_no_interface(files: str, expected: list[str]) -> None:
    start, _, rest = INTERFACES_CMAKE.partition('  "msg/Status.msg"\n')
    rest = rest.replace('  "srv/SetMode.srv"\n', "")
    text = {"CMakeLists.txt": f"{start}{files}{rest}", "msg/Status.msg": "bool a\n"}
    text["package.xml"] = manifest("", "ament_cmake")
    assert said(text, "IDL005") == expected


@pytest.mark.parametrize(
    "command, expected",
    [
        ("ament_lint_auto_find_test_dependencies", ["CMK003 error"]),
        ("ament_xmllint", ["CMK003 error"]),
        ("add_test", []),
        ("ament_add_gtest", []),
        ("ament_add_gmock", []),
        ("add_launch_test", []),
        ("add_executable", []),
    ],
)
def test_a_package_whose_linters_are_all_that_it_tests(command: str, expected: list[str]) -> None:
    files = cmake(TESTING.format(command).replace(f"{command}()", f"{command}(a a.cpp)"))
    files["CMakeLists.txt"] = files["CMakeLists.txt"].replace("ament_package()\n", "")
    assert said({**files, "a.cpp": ""}, "CMK003") == expected


@pytest.mark.parametrize(
    "use, expected",
    [
        ('Node(package="my_pkg", executable="a.py")', ["CMK105 error"]),
        ("Node(package='my_pkg', executable='a.py')", ["CMK105 error"]),
        ("ExecuteProcess(cmd=['python3', share + 'a.py'])", []),
    ],
)
def test_a_script_that_a_launch_file_starts(use: str, expected: list[str]) -> None:
    files = cmake("install(FILES a.py DESTINATION lib/${PROJECT_NAME})\n")
    launch = f"#!/usr/bin/env python3\n\n\ndef generate_launch_description():\n    return {use}\n"
    more = {"a.py": "#!/usr/bin/env python3\nprint(1)\n", "launch/a.launch.py": launch}
    assert said({**files, **more}, "CMK105") == expected


@pytest.mark.parametrize(
    "parameter, used, expected",
    [
        ("frame", "frame", []),
        ("frame", "farme", ["LCH008 warning"]),
        ("other", "farme", ["LCH008 warning"]),
        ("frame", "frames", ["LCH008 warning"]),
    ],
)
def test_an_argument_beside_a_parameter_of_its_name(clean, parameter: str, used: str, expected: list[str]) -> None:
    text = (
        '<launch>\n  <arg name="frame"/>\n  <include file="$(find-pkg-share who_knows)/a.launch.xml"/>\n'
        f'  <node pkg="joy" exec="joy_node"><param name="{parameter}" value="$(var {used})"/></node>\n</launch>\n'
    )
    found = said({**clean, "launch/a.launch.xml": text}, "LCH008")
    assert [each.split()[0] for each in found] == [each.split()[0] for each in expected]


def test_an_argument_beside_a_key_of_its_name(clean) -> None:
    text = (
        "from launch import LaunchDescription\nfrom launch.actions import DeclareLaunchArgument\n"
        "from launch.substitutions import LaunchConfiguration\nfrom launch_ros.actions import Node\n\n\n"
        "def generate_launch_description():\n    more = some_nodes()\n    return LaunchDescription([\n"
        "        DeclareLaunchArgument('frame', default_value='map'),\n        *more,\n        Node(package='joy',"
        " executable='joy_node', parameters=[{{'frame': LaunchConfiguration('{}')}}]),\n    ])\n"
    )
    for used, expected in (("frame", []), ("farme", ["LCH008 warning"])):
        assert said({**clean, "launch/a.launch.py": text.format(used)}, "LCH008") == expected


@pytest.mark.parametrize(
    "name, expected",
    [("max_torque", []), ("max_trque", ["PRM007 warning"]), ("min_torque", []), ("torque", []), ("max_force", [])],
)
def test_one_of_two_parameters_is_a_slip(clean, name: str, expected: list[str]) -> None:
    node = (
        "import rclpy.node\n\n\nclass Node(rclpy.node.Node):\n    def __init__(self):\n        super().__init__('a')\n"
        "        self.declare_parameter('max_force', 1.0)\n        self.declare_parameter('max_torque', 1.0)\n"
    )
    values = f"/**:\n  ros__parameters:\n    max_force: 5.0\n    {name}: 5.0\n"
    files = {**clean, "my_pkg/a.py": node, "config/a.yaml": values}
    assert said(files, "PRM007") == expected


@pytest.mark.parametrize(
    "name, expected",
    [
        ("PROJECT_NAME", []),
        ("PROJECTNAME", ["CMK115 info"]),
        ("PROJECT_NAMES", ["CMK115 info"]),
        ("PROJECT_SOURCEDIR", []),
        ("OTHER", []),
    ],
)
def test_the_name_of_the_project_where_files_are_unknown(name: str, expected: list[str]) -> None:
    lines = f"include(${{OTHER_FILE}})\ninstall(DIRECTORY launch DESTINATION share/${{{name}}})\n"
    files = {**cmake(lines), "launch/a.launch.xml": "<launch/>\n"}
    assert said(files, "CMK115") == expected
    told = {**files, "CMakeLists.txt": files["CMakeLists.txt"].replace("install(", f"set({name} a)\ninstall(")}
    assert said(told, "CMK115") == []


@pytest.mark.parametrize("child, count", [("b", 0), ("a", 1), ("x_a", 0)])
def test_a_joint_to_itself_in_a_part_of_a_robot(child: str, count: int) -> None:
    robot = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="r">\n'
    joint = f'  <joint name="j" type="fixed"><parent link="a"/><child link="{child}"/></joint>\n'
    other = f'  <link name="{child}"/>\n' if child != "a" else ""
    launch = '<launch>\n  <arg name="a" default="$(find-pkg-share my_pkg)/urdf/whole.urdf.xacro"/>\n</launch>\n'
    files = {
        **cmake("install(DIRECTORY urdf launch DESTINATION share/${PROJECT_NAME})\n"),
        "urdf/part.urdf.xacro": f'{robot}  <link name="a"/>\n{other}{joint}</robot>\n',
        "urdf/whole.urdf.xacro": f'{robot}  <xacro:include filename="part.urdf.xacro"/>\n</robot>\n',
        "launch/a.launch.xml": launch,
    }
    found = lint_files(files, ["URD001"]).findings
    assert ["joins `a` to itself" in each.message for each in found] == [True] * count


@pytest.mark.parametrize("name, expected", [("other", []), ("otehr", ["CMK117 error"]), ("outer", []), ("others", [])])
def test_a_slip_of_a_package_that_is_found_elsewhere(name: str, expected: list[str]) -> None:
    lines = f"find_package(other REQUIRED)\nfind_package({name} REQUIRED)\n"
    mine = {f"my_pkg/{path}": text for path, text in cmake(lines).items()}
    mine["my_pkg/package.xml"] = manifest("  <depend>other</depend>\n", "ament_cmake")
    theirs = {
        "other/package.xml": manifest("", "ament_cmake", "other"),
        "other/CMakeLists.txt": CMAKE.replace("my_pkg", "other"),
    }
    assert said({**mine, **theirs}, "CMK117") == expected
