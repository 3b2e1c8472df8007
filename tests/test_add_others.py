"""`rospkg add launch`, `params`, `msg`, `srv`, `action`, `test` and `dependency`, and their removal."""

from __future__ import annotations

import pytest
from adding import added, cmake_package, comes_back, new_findings, put, python_package, shares, taken, text

from rospkg_cli.addition.wanted import Wanted
from rospkg_cli.change import ChangeError, NotUnderstoodError
from rospkg_cli.change.draft import Draft
from rospkg_cli.scaffold import ScaffoldError
from rospkg_cli.tree import MemoryTree

SETUP = """\
from setuptools import setup

package_name = 'my_pkg'

setup(
    name=package_name,
    version='0.1.0',
    packages=[package_name],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/my_pkg']),
        ('share/my_pkg', ['package.xml']),
    ],
    maintainer='Ada',
    maintainer_email='ada@example.org',
    description='Drives my robot',
    license='Apache-2.0',
    entry_points={'console_scripts': ['old = my_pkg.old:main']},
)
"""
GLOB = SETUP.replace("from setup", "from glob import glob\n\nfrom setup")
CMAKE = """\
cmake_minimum_required(VERSION 3.20)
project(my_pkg)

find_package(ament_cmake REQUIRED)

add_executable(old src/old.cpp)
install(TARGETS old
  DESTINATION lib/${PROJECT_NAME})

ament_package()
"""
PLACES = {
    "a name": (
        SETUP,
        "        ('share/my_pkg', ['package.xml']),\n        ('share/' + package_name + '/launch', "
        "['launch/up.launch.py']),\n",
    ),
    "a glob": (GLOB, "        ('share/' + package_name + '/launch', glob('launch/*.py')),\n"),
    "glob.glob": (GLOB.replace("from glob import glob", "import glob"), "'/launch', glob.glob('launch/*.py')),\n"),
    "a list of files": (
        SETUP.replace("ml']),", "ml']),\n        ('share/my_pkg/launch', ['launch/a.launch.py']),"),
        "        ('share/my_pkg/launch', ['launch/a.launch.py', 'launch/up.launch.py']),\n",
    ),
    "none yet": (
        SETUP.replace(SETUP[SETUP.index("    data_files") : SETUP.index("    maintainer=")], ""),
        "    data_files=[('share/' + package_name + '/launch', ['launch/up.launch.py'])],\n)\n",
    ),
}


@pytest.mark.parametrize("place", PLACES)
def test_a_launch_file_is_installed_by_setup_py(place: str) -> None:
    setup, expected = PLACES[place]
    files = python_package(setup)
    if place == "a list of files":
        files["launch/a.launch.py"] = "from launch import LaunchDescription\n"
    draft = added(files, "launch", "up")
    assert expected in text(draft, "setup.py")
    assert "launch/up.launch.py" in shares(draft)
    assert "executable='old'" in text(draft, "launch/up.launch.py")
    assert "<exec_depend>launch_ros</exec_depend>" in text(draft, "package.xml")
    if place != "a list of files":
        comes_back(files, draft, "launch", "up")


def test_a_glob_that_finds_it_is_enough() -> None:
    setup = GLOB.replace("['package.xml']),", "['package.xml']),\n        ('share/my_pkg/launch', glob('launch/*')),")
    files = python_package(setup) | {"launch/a_launch.py": "", "launch/b_launch.py": ""}
    draft = added(files, "launch", "up")
    assert text(draft, "setup.py") == setup
    assert "launch/up_launch.py" in shares(draft)


def test_data_files_that_are_computed_are_left_to_a_person() -> None:
    computed = SETUP.replace("data_files=[", "data_files=find_them() + [")
    with pytest.raises(NotUnderstoodError, match="can't be put among the data files") as refused:
        added(python_package(computed), "launch", "up")
    assert refused.value.details[1] == "    ('share/my_pkg/launch', ['launch/up.launch.py']),"


RULES = {
    "a new rule": (CMAKE, "\ninstall(DIRECTORY launch\n  DESTINATION share/${PROJECT_NAME}\n)\n\nament_package()"),
    "the rule of others": (
        CMAKE.replace(
            "\nament_package", "\ninstall(DIRECTORY config DESTINATION share/${PROJECT_NAME})\n\nament_package"
        ),
        "install(DIRECTORY config launch DESTINATION share/${PROJECT_NAME})",
    ),
    "automatic": (
        "cmake_minimum_required(VERSION 3.20)\nproject(my_pkg)\nfind_package(ament_cmake_auto REQUIRED)\n"
        "ament_auto_add_executable(old src/old.cpp)\nament_auto_package()\n",
        "ament_auto_package(\n  INSTALL_TO_SHARE\n    launch\n)\n",
    ),
    "automatic with folders": (
        "cmake_minimum_required(VERSION 3.20)\nproject(my_pkg)\nfind_package(ament_cmake_auto REQUIRED)\n"
        "ament_auto_add_executable(old src/old.cpp)\nament_auto_package(INSTALL_TO_SHARE config)\n",
        "ament_auto_package(INSTALL_TO_SHARE config launch)\n",
    ),
}


@pytest.mark.parametrize("rule", RULES)
@pytest.mark.parametrize("form", ["py", "xml", "yaml"])
def test_a_launch_file_is_installed_by_cmake(rule: str, form: str) -> None:
    cmake, expected = RULES[rule]
    files = cmake_package(cmake, **{"config/a.yaml": "/**:\n  ros__parameters:\n    a: 1\n"})
    draft = added(files, "launch", f"up:{form}")
    assert expected in text(draft, "CMakeLists.txt")
    assert f"launch/up.launch.{form}" in shares(draft)
    comes_back(files, draft, "launch", f"up:{form}")


def test_which_nodes_a_launch_file_starts() -> None:
    setup = SETUP.replace("['old = ", "['up = my_pkg.old:main', 'old = ")
    files = python_package(setup)
    assert text(added(files, "launch", "up"), "launch/up.launch.py").count("executable=") == 1
    assert text(added(files, "launch", "all"), "launch/all.launch.py").count("executable=") == 2
    draft = added(files, "launch", "both", nodes=("old", "demo_nodes_cpp/talker"))
    assert "package='demo_nodes_cpp',\n            executable='talker'" in text(draft, "launch/both.launch.py")
    assert "<exec_depend>demo_nodes_cpp</exec_depend>" in text(draft, "package.xml")
    comes_back(files, draft, "launch", "both")
    with pytest.raises(ChangeError, match=r"no executable `odl` \(did you mean `old`\?\)"):
        added(files, "launch", "up", nodes=("odl",))
    nothing = python_package(SETUP.replace("    entry_points={'console_scripts': ['old = my_pkg.old:main']},\n", ""))
    assert "Nothing is started yet" in text(added(nothing, "launch", "up"), "launch/up.launch.py")


def test_names_and_formats_of_launch_files() -> None:
    files = python_package(SETUP)
    assert "launch/up.launch.xml" in added(files, "launch", "up.launch.xml").changes
    assert "launch/up_launch.py" in added(files, "launch", "up_launch.py").changes
    assert "cfg/a.yaml" in added(files, "params", "cfg/a").changes
    yaml = {**files, "launch/a.launch.yaml": "launch: []\n"}
    assert "launch/up.launch.yaml" in added(yaml, "launch", "up").changes
    with pytest.raises(ChangeError, match="no launch files in `toml`"):
        added(files, "launch", "up:toml")
    with pytest.raises(ChangeError, match=r"`a/b` can't be the name of a launch file"):
        added(files, "launch", "a/b")
    with pytest.raises(ChangeError, match=r"there is no `launch/up.launch.py`"):
        taken(added(files, "launch", "other"), "launch", "up")


def test_parameters_are_installed_with_what_the_code_declares() -> None:
    code = "import rclpy\n\n\nclass A:\n    def __init__(self, node):\n        node.declare_parameter('rate', 1.0)\n"
    files = python_package(SETUP, my_pkg__deep=code) | {"my_pkg/deep.py": code}
    draft = added(files, "params", "robot")
    assert text(draft, "config/robot.yaml") == (
        "/**:\n  ros__parameters:\n    use_sim_time: false  # whether time comes from the topic /clock\n"
        "    # What the package's code declares; take the `#` away to set one:\n    # rate:\n"
    )
    assert "config/robot.yaml" in shares(draft)
    comes_back(files, draft, "params", "robot")
    other = added(cmake_package(CMAKE, **{"params/a.yaml": "a: 1\n"}), "params", "robot.yaml")
    assert "install(DIRECTORY params\n" in text(other, "CMakeLists.txt")
    with pytest.raises(ChangeError, match="can't be the name of a file of parameters"):
        added(files, "params", "a b")
    with pytest.raises(ChangeError, match="can't be the name of a file of parameters"):
        added(files, "params", "launch/a")


INTERFACES = """\
cmake_minimum_required(VERSION 3.20)
project(my_pkg)
find_package(ament_cmake REQUIRED)
find_package(rosidl_default_generators REQUIRED)

rosidl_generate_interfaces(${PROJECT_NAME}
  "msg/Able.msg"
  "msg/Zeal.msg"
)

ament_package()
"""
LISTS = {
    "one a line": (
        INTERFACES,
        '  "msg/Able.msg"\n  "msg/Status.msg"\n  "msg/Zeal.msg"\n  DEPENDENCIES builtin_interfaces\n)',
    ),
    "in a variable": (
        INTERFACES.replace(
            'rosidl_generate_interfaces(${PROJECT_NAME}\n  "msg/Able.msg"\n  "msg/Zeal.msg"\n)',
            "set(files\n  msg/Able.msg\n  msg/Zeal.msg)\nrosidl_generate_interfaces(${PROJECT_NAME} ${files})",
        ),
        "  msg/Able.msg\n  msg/Status.msg\n  msg/Zeal.msg)\n",
    ),
    "in one line": (
        INTERFACES.replace('\n  "msg/Able', ' "msg/Able').replace(
            '\n  "msg/Zeal.msg"\n', ' "msg/Zeal.msg" DEPENDENCIES std_msgs'
        ),
        '"msg/Able.msg" "msg/Status.msg" "msg/Zeal.msg" DEPENDENCIES std_msgs)',
    ),
    "another on the last line": (
        INTERFACES.replace('\n  "msg/Zeal.msg"\n', '\n  "msg/Able2.msg" DEPENDENCIES std_msgs'),
        '  "msg/Able2.msg"\n  "msg/Status.msg" DEPENDENCIES std_msgs)',
    ),
    "a pattern": (
        INTERFACES.replace(
            'rosidl_generate_interfaces(${PROJECT_NAME}\n  "msg/Able.msg"\n  "msg/Zeal.msg"\n)',
            "file(GLOB files RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} msg/*.msg)\n"
            "rosidl_generate_interfaces(${PROJECT_NAME} ${files})",
        ),
        "rosidl_generate_interfaces(${PROJECT_NAME} ${files}\n  DEPENDENCIES builtin_interfaces)",
    ),
}
DECLARED = (
    "  <buildtool_depend>ament_cmake</buildtool_depend>\n"
    "  <buildtool_depend>rosidl_default_generators</buildtool_depend>\n"
    "  <exec_depend>rosidl_default_runtime</exec_depend>\n"
    "  <test_depend>ament_lint_auto</test_depend>\n"
    "  <member_of_group>rosidl_interface_packages</member_of_group>\n"
)


def interfaces_package(cmake: str) -> dict[str, str]:
    from rospkg_cli.example import manifest

    files = cmake_package(cmake, **{"msg/Able.msg": "int32 a\n", "msg/Zeal.msg": "int32 a\n"})
    return {**files, "package.xml": manifest(DECLARED, build_type="ament_cmake")}


@pytest.mark.parametrize("form", LISTS)
def test_a_message_is_listed_with_what_its_types_need(form: str) -> None:
    cmake, expected = LISTS[form]
    files = interfaces_package(cmake)
    draft = added(files, "msg", "Status")
    assert expected in text(draft, "CMakeLists.txt")
    assert "find_package(builtin_interfaces REQUIRED)\n" in text(draft, "CMakeLists.txt")
    assert "<depend>builtin_interfaces</depend>" in text(draft, "package.xml")
    comes_back(files, draft, "msg", "Status")


def test_services_actions_and_messages_of_the_same_package() -> None:
    files = interfaces_package(INTERFACES)
    draft = added(files, "srv", "Ask:Able who --- bool done")
    assert text(draft, "srv/Ask.srv") == "Able who\n---\nbool done\n"
    assert '  "msg/Zeal.msg"\n  "srv/Ask.srv"\n)' in text(draft, "CMakeLists.txt")
    assert new_findings(files, draft) == []
    comes_back(files, draft, "srv", "Ask")
    comes_back(files, added(files, "action", "Go"), "action", "Go")
    with pytest.raises(ScaffoldError, match="there is no message `Nobody` here"):
        added(files, "msg", "Status:Nobody who")
    with pytest.raises(ChangeError, match=r"there is no `msg/Status.msg`"):
        taken(draft, "msg", "Status")


def test_a_package_without_interfaces_says_how_to_have_some() -> None:
    files = cmake_package(CMAKE)
    with pytest.raises(
        ChangeError, match=r"`rospkg new my_pkg_interfaces --type interfaces --msg Status`, or give --here"
    ):
        added(files, "msg", "Status")
    draft = added(files, "msg", "Status", here=True)
    assert (
        'rosidl_generate_interfaces(${PROJECT_NAME}\n  "msg/Status.msg"\n  DEPENDENCIES builtin_interfaces\n)'
        in text(draft, "CMakeLists.txt")
    )
    manifest = text(draft, "package.xml")
    assert manifest.index("<member_of_group>") > manifest.index("<exec_depend>rosidl_default_runtime")
    assert new_findings(files, draft) == []
    comes_back(files, draft, "msg", "Status")
    taken_name = cmake_package(
        CMAKE.replace("add_executable(old", "add_library(my_pkg src/old.cpp)\nadd_executable(old")
    )
    assert "rosidl_generate_interfaces(${PROJECT_NAME}_interfaces\n" in text(
        added(taken_name, "msg", "Status", here=True), "CMakeLists.txt"
    )
    with pytest.raises(ChangeError, match="only packages of type ament_cmake can generate interfaces"):
        added(python_package(SETUP), "msg", "Status", here=True)
    with pytest.raises(ChangeError, match="the generated one has the same name"):
        added(
            cmake_package(CMAKE.replace("add_exec", "ament_python_install_package(my_pkg)\nadd_exec")),
            "msg",
            "Status",
            here=True,
        )
    files["package.xml"] = files["package.xml"].replace('format="3"', 'format="1"')
    with pytest.raises(ChangeError, match="no groups before format 3"):
        added(files, "msg", "Status", here=True)


def test_format_2_becomes_3_where_a_group_is_needed() -> None:
    files = cmake_package(CMAKE.replace("add_exec", "ament_python_install_package(a)\nadd_exec"))
    old = files["package.xml"].replace('format="3"', 'format="2"').replace("package_format3", "package_format2")
    draft = Draft(MemoryTree.of({**files, "package.xml": old}))
    put(draft, Wanted("msg", ("Status",), here=True))
    whole = text(added(files, "msg", "Status", here=True), "package.xml")
    assert text(draft, "package.xml") == whole


def test_a_test_in_python() -> None:
    files = python_package(SETUP)
    draft = added(files, "test", "old")
    assert "from my_pkg import old\n" in text(draft, "test/test_old.py")
    assert "    extras_require={'test': ['pytest']},\n)" in text(draft, "setup.py")
    assert "<test_depend>python3-pytest</test_depend>" in text(draft, "package.xml")
    assert new_findings(files, draft) == []
    comes_back(files, draft, "test", "old")
    logic = added(python_package(SETUP), "node", "talker:publisher")
    with_logic = {path: text(logic, path) for path in logic.tree.files()}
    assert "Greeting('Hello').say() == 'Hello 1'" in text(
        added(with_logic, "test", "greeting"), "test/test_greeting.py"
    )
    assert "def test_nothing_yet() -> None:" in text(added(files, "test", "nothing_yet"), "test/test_nothing_yet.py")
    with pytest.raises(ChangeError, match="no tests in C"):
        added(files, "test", "old:cpp")


TESTS = {
    "no block yet": (
        CMAKE,
        "if(BUILD_TESTING)\n  find_package(ament_cmake_gtest REQUIRED)\n"
        "  ament_add_gtest(test_planner test/test_planner.cpp)\nendif()\n\nament_package()\n",
    ),
    "a block": (
        CMAKE.replace(
            "ament_package", "if(BUILD_TESTING)\n  find_package(ament_lint_auto REQUIRED)\nendif()\n\nament_package"
        ),
        "  find_package(ament_lint_auto REQUIRED)\n  find_package(ament_cmake_gtest REQUIRED)\n"
        "  ament_add_gtest(test_planner test/test_planner.cpp)\nendif()\n",
    ),
    "looked for above": (
        CMAKE.replace("\nadd_exec", "find_package(ament_cmake_gtest REQUIRED)\n\nadd_exec"),
        "if(BUILD_TESTING)\n  ament_add_gtest(test_planner test/test_planner.cpp)\nendif()\n\nament_package()\n",
    ),
    "other tests": (
        CMAKE.replace(
            "ament_package",
            "if(BUILD_TESTING)\n  find_package(ament_cmake_gtest REQUIRED)\n"
            "  ament_add_gtest(test_old src/old.cpp)\nendif()\n\nament_package",
        ),
        "  ament_add_gtest(test_old src/old.cpp)\n  ament_add_gtest(test_planner test/test_planner.cpp)\nendif()\n",
    ),
}


@pytest.mark.parametrize("form", TESTS)
def test_a_test_in_cpp(form: str) -> None:
    cmake, expected = TESTS[form]
    files = cmake_package(cmake)
    if "gtest" in cmake:  # then it stays declared, as long as CMake uses it
        gtest = "  <test_depend>ament_cmake_gtest</test_depend>\n"
        files["package.xml"] = files["package.xml"].replace("  <export>", f"{gtest}  <export>")
    draft = added(files, "test", "planner")
    assert expected in text(draft, "CMakeLists.txt")
    assert "TEST(planner, does_what_it_should)" in text(draft, "test/test_planner.cpp")
    assert new_findings(files, draft) == []
    if form == "looked for above":  # a dependency that nothing else names goes
        after, _ = taken(draft, "test", "planner")
        assert text(after, "CMakeLists.txt") == cmake
        return
    comes_back(files, draft, "test", "planner")


def test_a_test_of_a_header_finds_it() -> None:
    files = cmake_package(CMAKE)
    logic = added(files, "node", "talker:publisher")
    draft = added({path: text(logic, path) for path in logic.tree.files()}, "test", "greeting")
    assert "target_include_directories(test_greeting PRIVATE src)" in text(draft, "CMakeLists.txt")
    assert "EXPECT_EQ(greeting.say()" in text(draft, "test/test_greeting.cpp")
    python = added(files, "test", "shape:python")
    assert "ament_add_pytest_test(test_shape_py test/test_shape.py)" in text(python, "CMakeLists.txt")
    with pytest.raises(ChangeError, match="no tests in `rust`"):
        added(files, "test", "shape:rust")
    with pytest.raises(NotUnderstoodError, match=r"no ament_package\(\)"):
        added(cmake_package(CMAKE.replace("ament_package()", "")), "test", "planner")


def depends(files: dict[str, str], key: str, **options: object) -> str:
    """Return the line that a dependency gets in package.xml."""
    draft = added(files, "dependency", key, **options)
    [line] = [each.strip() for each in text(draft, "package.xml").split("\n") if f">{key}<" in each]
    return line


def test_the_tag_follows_from_the_build_type_and_from_the_use() -> None:
    python, cmake = python_package(SETUP), cmake_package(CMAKE)
    assert depends(python, "std_msgs") == "<exec_depend>std_msgs</exec_depend>"
    assert depends(python, "python3-pytest") == "<test_depend>python3-pytest</test_depend>"
    assert depends({**python, "test/test_a.py": "import yaml_thing\n"}, "yaml_thing").startswith("<test_depend>")
    assert depends(cmake, "std_msgs") == "<depend>std_msgs</depend>"
    assert depends(cmake, "ament_cmake_gtest") == "<test_depend>ament_cmake_gtest</test_depend>"
    assert depends(cmake, "ament_cmake_python") == "<buildtool_depend>ament_cmake_python</buildtool_depend>"
    assert depends(cmake, "python3-numpy") == "<exec_depend>python3-numpy</exec_depend>"
    assert depends(cmake, "std_msgs", tag="build_depend") == "<build_depend>std_msgs</build_depend>"
    launch = {**cmake, "launch/a.launch.py": "Node(package='demo_nodes_cpp')\n"}
    assert depends(launch, "demo_nodes_cpp") == "<exec_depend>demo_nodes_cpp</exec_depend>"
    old = {**cmake, "package.xml": cmake["package.xml"].replace('format="3"', 'format="1"')}
    assert "<run_depend>std_msgs</run_depend>" in text(added(old, "dependency", "std_msgs"), "package.xml")
    with pytest.raises(ChangeError, match=r"no tag <exec>.*; known: "):
        depends(cmake, "std_msgs", tag="exec")
    with pytest.raises(ScaffoldError, match="neither the name of a ROS package nor a rosdep key"):
        depends(cmake, "a b")


LINKS = {
    "nothing linked": ("", "add_executable(old src/old.cpp)\ntarget_link_libraries(old PRIVATE ${std_msgs_TARGETS})\n"),
    "linked": (
        "target_link_libraries(old PUBLIC\n  rclcpp::rclcpp\n)\n",
        "target_link_libraries(old PUBLIC\n  rclcpp::rclcpp\n  ${std_msgs_TARGETS}\n)\n",
    ),
    "the old way": ("ament_target_dependencies(old rclcpp)\n", "ament_target_dependencies(old rclcpp std_msgs)\n"),
}


@pytest.mark.parametrize("form", LINKS)
def test_what_cpp_includes_is_looked_for_and_linked(form: str) -> None:
    link, expected = LINKS[form]
    files = cmake_package(CMAKE.replace("install(", f"{link}install(", 1))
    files["src/old.cpp"] = '#include "std_msgs/msg/string.hpp"\nint main() {return 0;}\n'
    draft = added(files, "dependency", "std_msgs")
    assert expected in text(draft, "CMakeLists.txt")
    assert "find_package(std_msgs REQUIRED)\n" in text(draft, "CMakeLists.txt")
    with pytest.raises(ChangeError, match="files of the package still name `std_msgs`; --force"):
        taken(draft, "dependency", "std_msgs")


def test_a_dependency_that_nothing_names_goes() -> None:
    files = cmake_package(CMAKE)
    draft = added(files, "dependency", "std_msgs", "nav_msgs")
    comes_back(files, draft, "dependency", "std_msgs", "nav_msgs")
    with pytest.raises(ChangeError, match=r"package\.xml does not declare `nobody`"):
        taken(draft, "dependency", "nobody")
    used = python_package(SETUP) | {"my_pkg/old.py": "import std_msgs\n"}
    after, _ = taken(added(used, "dependency", "std_msgs"), "dependency", "std_msgs", force=True)
    assert text(after, "package.xml") == used["package.xml"]


def test_a_launch_file_is_removed_by_its_name_alone() -> None:
    files = python_package(GLOB)
    for form in ("py", "xml", "yaml"):
        comes_back(files, added(files, "launch", f"up:{form}"), "launch", "up")
    after, _ = taken(added(files, "launch", "up:xml", "up:yaml"), "launch", "up:yaml")
    assert after.package("").files.below("launch") == ("launch/up.launch.xml",)


def test_the_second_launch_file_leaves_what_the_first_needs() -> None:
    for one, other in (("xml", "xml"), ("yaml", "yaml"), ("xml", "py"), ("py", "yaml")):
        first = added(python_package(GLOB), "launch", f"first:{one}")
        files = {path: text(first, path) for path in first.tree.files()}
        comes_back(files, added(files, "launch", f"up:{other}"), "launch", "up")
