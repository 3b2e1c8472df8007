"""What nobody uses any more, what is left out on purpose, and what an option must ask for: no fault, or an info."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, INTERFACES_CMAKE, SETUP_PY, existing_files, manifest, scripts, setup_py
from rospkg_cli.package.file_role import is_set_aside
from rospkg_cli.testing import lint_files

NATIVE = existing_files(BACKDROPS["ament_cmake"])
PYTHON = existing_files(BACKDROPS["ament_python"])
INTERFACES = existing_files(BACKDROPS["interfaces"])
LEFT_OUT = "# Generate {}\nrosidl_generate"
SNIPPET = "    node.declare_parameter('rate', 1.0)\n"
VARIANTS = INTERFACES_CMAKE.replace('  "msg/Status.msg"\n', '  "msg/${DEVICE}/Diag.msg"\n')
XACRO = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="r">{}</robot>\n'
INCLUDE = '<xacro:include filename="$(find ur_description)/urdf/ur.xacro"/>'
INSTALLED = CMAKE.replace("ament_package", "install(DIRECTORY urdf DESTINATION share/${PROJECT_NAME})\nament_package")
LIBRARY = CMAKE.replace("ament_package", "add_library(a src/a.cpp)\nament_package")
TESTER = "project(my_pkg_test)\nadd_executable(talker a.cpp)\ninstall(TARGETS talker DESTINATION lib/{})\n"
STARTED = '<launch>\n  <node pkg="tof_driver_cpp" exec="tof"/>\n</launch>\n'


def levels(code: str, on: dict[str, str], files: dict[str, str]) -> list[str]:
    return [each.severity.value for each in lint_files({**on, **files}, [code]).findings]


@pytest.mark.parametrize(
    ("path", "is_aside"),
    [
        ("_legacy/arm/package.xml", True),
        ("src/Deprecated/", True),
        ("depricated/", True),
        ("old_nodes/a.py", True),
        ("urdf/old_version/a.urdf", True),
        ("old_town/a.world", False),
        ("a/backup/b.py", True),
        ("msg/Flags_backup.msg", True),
        ("msg/Flags.old.msg", False),
        ("threshold/a.py", False),
        ("backup_camera/package.xml", False),
        ("msg/Backup.msg", False),
        ("my_backup/", False),
        ("urdf_backup/arm.urdf", True),
        ("launch_old/a.launch.py", True),
        ("urdf copy/arm.urdf", True),
        ("src/arm copy 2/package.xml", True),
        ("urdf - Copy/arm.urdf", True),
        ("launch - Copy (2)/a.launch.py", True),
        ("deep copy tools/a.py", False),
        ("copy/a.py", False),
        ("file_copy/a.py", False),
        ("src/not_in_use/arm/", True),
        ("src/NotUsed/arm/", True),
        ("dont_use/a.py", True),
        ("do-not-use/a.py", True),
        ("unused_arm/a.py", True),
        ("launch_unused/a.py", True),
        ("not working/a.py", True),
        ("broken/a.py", True),
        ("my_pkg/arm_unused.py", True),
        ("launch/deprecated_arm.launch.py", True),
        ("launch/arm_deprecated.launch.py", True),
        ("launch/deprecated.launch.py", True),
        ("launch/legacy_arm.launch.py", True),
        ("launch/unused-arm.launch.py", True),
        ("launch/obsolete.launch.xml", True),
        ("launch/archive/arm.launch.py", True),
        ("config/arm_OUTDATED.yaml", True),
        ("src/WIP_arm.cpp", True),
        ("wip/arm.py", True),
        ("launch/wipe.launch.py", False),
        ("launch/archive.launch.py", False),
        ("launch/old_town.launch.py", False),
        ("launch/retired_arm.launch.py", False),
        ("used/a.py", False),
        ("trash/package.xml", False),
        ("broken_line_detector/package.xml", False),
        ("arm_in_use/package.xml", False),
    ],
)
def test_what_is_set_aside_by_its_name(path: str, is_aside: bool) -> None:
    assert is_set_aside(path) is is_aside


@pytest.mark.parametrize(("folder", "level"), [("{{cookiecutter.name}}", "info"), ("arm", "error")])
def test_a_package_of_a_template(folder: str, level: str) -> None:
    """Nobody builds it before the folder has its name."""
    (finding,) = lint_files({f"{folder}/package.xml": manifest("", "ament_cmake", "{{name}}")}, ["XML101"]).findings
    assert finding.severity.value == level


@pytest.mark.parametrize(("folder", "level"), [("_legacy/arm", "info"), ("arm", "warning")])
def test_placeholders_of_packages_that_are_set_aside(folder: str, level: str) -> None:
    text = manifest().replace("Drives my robot", "TODO: Package description").replace("Apache-2.0", "TODO")
    text = text.replace("ada@example.org", "ada@todo.todo").replace(
        "<maintainer ", '<author email="b@c.de">TODO</author>\n<maintainer '
    )
    assert levels("XML104", {}, {f"{folder}/package.xml": text}) == [level]


@pytest.mark.parametrize(
    ("folder", "importer", "level"),
    [("old", "", "info"), ("old", "import my_pkg.old.words\n", "warning"), ("speech", "", "info")],
)
def test_a_folder_of_old_modules_is_not_installed(folder: str, importer: str, level: str) -> None:
    files = {f"my_pkg/{folder}/words.py": "A = 1\n", "my_pkg/talker.py": importer}
    assert levels("SET301", PYTHON, files) == [level]


@pytest.mark.parametrize(
    ("path", "text", "other", "level"),
    [
        ("my_pkg/add.py", SNIPPET, "", "info"),
        ("my_pkg/add.py", SNIPPET, "from my_pkg import add\n", "error"),
        ("my_pkg/add.py", SNIPPET, "from my_pkg.add import x\n", "error"),
        ("my_pkg/add.py", SNIPPET, "a.adder = 'add.txt'\n", "info"),
        ("my_pkg/add.py", SNIPPET, "a.adder = 'my_pkg/add.py'\n", "error"),
        ("my_pkg/add.py", SNIPPET, "adder = added\n", "info"),
        ("my_pkg/add.py", SNIPPET, "import my_pkg.third\n", "error"),
        ("my_pkg/add.py", SNIPPET, "thirds = third_\n", "info"),
        ("my_pkg/talker.py", SNIPPET, SNIPPET, "error"),
        ("my_pkg/add.py", f"{SNIPPET}if __name__ == '__main__':\n", "", "info"),
        ("my_pkg/add.py", f"def main():\n{SNIPPET}  a\n", "", "info"),
        ("my_pkg/add.py", "# a\n\nprint 1\n", "", "info"),
        ("my_pkg/add_old.py", "print 1\n", "", "info"),
        ("my_pkg/__init__.py", SNIPPET, "", "error"),
        ("test/test_add.py", SNIPPET, "", "error"),
        ("setup.py", SNIPPET, "", "error"),
    ],
)
def test_a_snippet_that_nothing_imports(path: str, text: str, other: str, level: str) -> None:
    third = {"my_pkg/third.py": "import my_pkg.add\n"} if "third" in other else {}
    setup = {"setup.py": setup_py(scripts("talker = my_pkg.talker:main"))}
    assert levels("RPK001", PYTHON, {**setup, "my_pkg/talker.py": other, **third, path: text}) == [level]


@pytest.mark.parametrize(
    ("line", "level"),
    [
        ("install(PROGRAMS scripts/add.py DESTINATION lib/my_pkg)\n", "error"),
        ("install(DIRECTORY launch scripts/ DESTINATION lib/my_pkg)\n", "error"),
        ("install(DIRECTORY ${PROJECT_SOURCE_DIR}/scripts DESTINATION lib/my_pkg)\n", "error"),
        ("file(GLOB FOUND scripts/*.py)\ninstall(PROGRAMS ${FOUND} DESTINATION lib/my_pkg)\n", "error"),
        ("ament_python_install_package(scripts)\ninstall(DIRECTORY scripts_more DESTINATION lib/my_pkg)\n", "info"),
    ],
)
def test_a_script_that_cmake_installs(line: str, level: str) -> None:
    text = CMAKE.replace("ament_package", f"{line}ament_package")
    files = {"CMakeLists.txt": text, "scripts/add.py": "print 1\n", "scripts/__init__.py": ""}
    assert levels("RPK001", NATIVE, files) == [level]


@pytest.mark.parametrize(
    ("comment", "name", "level"),
    [
        ("messages (only the working ones)", "Zone", "info"),
        ("messages\n# that are not broken", "Zone", "info"),
        ("messages", "Zone", "warning"),
        ("only these\nset(A 1)", "Zone", "warning"),
        ("messages", "Zone_backup", "info"),
    ],
)
def test_interfaces_that_are_left_out_on_purpose(comment: str, name: str, level: str) -> None:
    text = INTERFACES_CMAKE.replace("rosidl_generate", LEFT_OUT.format(comment), 1) if comment else INTERFACES_CMAKE
    files = {**INTERFACES, "CMakeLists.txt": text, f"msg/{name}.msg": "int8 a\n", "README.md": "my_pkg/msg/Zone\n"}
    (found,) = lint_files(files, ["IDL005"]).findings
    assert (found.severity.value, found.fix is None) == (level, level == "info")


def test_a_comment_among_the_interfaces_says_that_one_is_left_out() -> None:
    text = INTERFACES_CMAKE.replace('  "srv/', '  # Zone is disabled\n  "srv/')
    assert levels("IDL005", INTERFACES, {"CMakeLists.txt": text, "msg/Zone.msg": "int8 a\n"}) == ["info"]


def test_variants_of_a_message_are_one_info() -> None:
    files = {"CMakeLists.txt": VARIANTS, "msg/Status.msg": "int8 a\n"}
    files |= {f"msg/{each}/Diag.msg": "int8 a\n" for each in ("a", "b")}
    assert levels("IDL002", INTERFACES, files) == ["info"]


@pytest.mark.parametrize(
    ("first", "second", "count"),
    [
        ("#if PYTHON\n{}#endif\n", "", 0),
        ("#if PYTHON\n{}#endif\n", "{}", 1),
        ("#if PYTHON\n{}#endif\n", "#if A\n{}#endif\n", 0),
        ("{}", "", 1),
        ("", "", 1),
    ],
)
def test_a_header_that_all_include_under_a_condition(first: str, second: str, count: int) -> None:
    header = "#include <boost/python.hpp>\n"
    include = '#include "my_pkg/bridge.hpp"\n'
    files = {
        "CMakeLists.txt": LIBRARY.replace("src/a.cpp", "src/a.cpp src/b.cpp"),
        "include/my_pkg/bridge.hpp": header,
        "src/a.cpp": first.format(include) + "int a;\n",
        "src/b.cpp": second.format(include) + "int b;\n",
    }
    assert len(levels("DEP105", NATIVE, files)) == count


@pytest.mark.parametrize(
    ("robot", "level"),
    [
        (INCLUDE, "warning"),
        (f'<xacro:arg name="gz" default="false"/><xacro:if value="$(arg gz)">{INCLUDE}</xacro:if>', "info"),
        (f'<xacro:arg name="gz" default="true"/><xacro:if value="$(arg gz)">{INCLUDE}</xacro:if>', "warning"),
        (f'<xacro:arg name="gz" default="true"/><xacro:unless value="$(arg gz)">{INCLUDE}</xacro:unless>', "info"),
        (f'<xacro:arg name="gz" default="false"/><xacro:unless value="$(arg gz)">{INCLUDE}</xacro:unless>', "warning"),
    ],
)
def test_a_robot_needs_a_package_where_an_argument_asks_for_it(robot: str, level: str) -> None:
    files = {"CMakeLists.txt": INSTALLED, "urdf/robot.xacro": XACRO.format(robot)}
    files["README.md"] = "    xacro urdf/robot.xacro > robot.urdf\n"
    assert levels("DEP106", NATIVE, files) == [level]


def test_a_robot_includes_what_needs_a_package_where_an_argument_asks_for_it() -> None:
    part = '<xacro:include filename="$(find my_pkg)/urdf/part.xacro"/>'
    top = f'<xacro:arg name="gz" default="false"/><xacro:if value="$(arg gz)">{part}</xacro:if>'
    files = {"urdf/robot.xacro": XACRO.format(top), "urdf/part.xacro": XACRO.format(INCLUDE).replace(' name="r"', "")}
    assert levels("DEP106", NATIVE, {"CMakeLists.txt": INSTALLED, **files}) == ["info"]


@pytest.mark.parametrize(("place", "found"), [("${PROJECT_NAME}", []), ("other", ["info"])])
def test_a_project_of_its_own_below(place: str, found: list[str]) -> None:
    files = {"CMakeLists.txt": CMAKE.replace("ament_package", "add_subdirectory(test)\nament_package")}
    files |= {"test/CMakeLists.txt": TESTER.format(place), "test/a.cpp": "int main() {}\n"}
    assert levels("CMK104", NATIVE, files) == found


@pytest.mark.parametrize(
    ("readme", "level"),
    [
        ("Install https://github.com/ada/tof-driver#readme first.\n", "info"),
        ("Install https://github.com/ada/tof-driver-cpp.git first.\n", "info"),
        ("Install https://github.com/ada/lidar-driver first.\n", "warning"),
        ("Clone https://github.com/ada/my_p here.\n", "warning"),
    ],
)
def test_a_readme_says_where_an_unknown_package_comes_from(readme: str, level: str) -> None:
    body = manifest("  <exec_depend>ros2launch</exec_depend>\n")
    files = {"package.xml": body, "launch/a.launch.xml": STARTED, "README.md": readme}
    assert levels("DEP103", PYTHON, files) == [level]
    above = {f"src/{path}": text for path, text in {**PYTHON, **files}.items() if path != "README.md"}
    assert levels("DEP103", {}, {**above, "README.md": readme}) == [level]


@pytest.mark.parametrize(
    ("module", "body", "level"),
    [
        ("yaml", "", "info"),
        ("numpy", "", "warning"),
        ("PyQt5", "  <exec_depend>rqt_gui</exec_depend>\n", "info"),
        ("PyQt5", "  <exec_depend>rclpy</exec_depend>\n", "warning"),
    ],
)
def test_what_is_there_wherever_rosdep_runs(module: str, body: str, level: str) -> None:
    files = {"package.xml": manifest(body), "my_pkg/viewer.py": f"import {module}\n"}
    assert levels("DEP101", PYTHON, files) == [level]


VIEW = '<launch>\n  <node pkg="rviz2" exec="rviz2" args="-d $(find-pkg-share my_pkg)/{}"{}/>\n</launch>\n'
LAUNCHED = CMAKE.replace(
    "ament_package", "install(DIRECTORY launch {}DESTINATION share/${{PROJECT_NAME}})\nament_package"
)


@pytest.mark.parametrize(
    ("code", "path", "more", "level"),
    [
        ("CMK101", "rviz/robot.rviz", "", "warning"),
        ("CMK101", "maps/robot.yaml", "", "error"),
        ("LCH004", "rviz/robot.rviz", "FILES rviz/b.rviz DESTINATION share/${PROJECT_NAME}/rviz", "warning"),
        ("LCH004", "maps/robot.yaml", "FILES maps/b.yaml DESTINATION share/${PROJECT_NAME}/maps", "warning"),
    ],
)
def test_rviz_starts_without_its_config(code: str, path: str, more: str, level: str) -> None:
    install = (
        LAUNCHED.format("") if not more else LAUNCHED.format("").replace("install(", f"install({more})\ninstall(", 1)
    )
    folder = path.partition("/")[0]
    files = {path: "a: 1\n", f"{folder}/b.{path.rpartition('.')[2]}": "a: 1\n", "CMakeLists.txt": install}
    body = manifest("  <exec_depend>ros2launch</exec_depend>\n  <exec_depend>rviz2</exec_depend>\n", "ament_cmake")
    files |= {"package.xml": body, "launch/a.launch.xml": VIEW.format(path, "")}
    assert levels(code, NATIVE, files) == [level]
    if code == "LCH004":
        off = VIEW.format(path, ' if="$(var rviz)"').replace(
            "<launch>", '<launch>\n  <arg name="rviz" default="false"/>'
        )
        assert levels(code, NATIVE, {**files, "launch/a.launch.xml": off}) == ["info"]


@pytest.mark.parametrize(
    ("folder", "expected"),
    [("old", ["info"] * 5), ("src/not_in_use", ["info"] * 5), ("gold", ["error"] * 3 + ["warning", "error"])],
)
def test_a_package_in_a_folder_laid_aside_is_milder(folder: str, expected: list[str]) -> None:
    """Nobody starts it."""
    files = {
        f"{folder}/my_pkg/launch/a.launch.xml": '<launch>\n  <node pkg="my_pkg" exec="b"/>\n</launch>\n',
        "other/package.xml": manifest("", "cmake", "other"),
        **{f"{folder}/my_pkg/{path}": text for path, text in PYTHON.items()},
        f"{folder}/my_pkg/setup.py": setup_py(
            scripts("a = my_pkg.gone:main", "ears = my_pkg.ears:main", "talker = my_pkg.talker:main")
        ).replace("['package.xml'])", "['package.xml']), ('share/my_pkg/launch', ['launch/a.launch.xml'])"),
        f"{folder}/my_pkg/my_pkg/talker.py": "import cv2\n\n\ndef main():\n    json.loads('{}')\n",
        f"{folder}/my_pkg/my_pkg/ears.py": "import my_pkg.lost\n\n\ndef main():\n    pass\n",
    }
    codes = ["SET101", "LCH002", "DEP117", "DEP101", "DEP109"]
    found = {each.code: each.severity.value for each in lint_files(files, codes).findings}
    assert [found[code] for code in codes] == expected


@pytest.mark.parametrize("folder", ["old", "gold"])
def test_what_stops_the_build_stops_it_in_a_folder_laid_aside_too(folder: str) -> None:
    files = {f"{folder}/my_pkg/{path}": text for path, text in NATIVE.items()}
    files[f"{folder}/my_pkg/CMakeLists.txt"] = CMAKE.replace(
        "ament_package", "add_executable(a src/gone.cpp)\nament_package"
    )
    files["other/package.xml"] = manifest("", "cmake", "other")
    assert levels("CMK110", {}, files) + levels("CMK102", {}, files) == ["error"]


@pytest.mark.parametrize(
    ("code", "path", "text", "expected"),
    [
        ("LCH002", "launch/{}/a.launch.xml", '<launch>\n  <node pkg="my_pkg" exec="a"/>\n</launch>\n', "info"),
        ("PRM001", "config/{}/a.yaml", "talker:\n  ros_parameters:\n    rate: 1\n", "info"),
    ],
)
def test_a_file_laid_aside_within_a_package(code: str, path: str, text: str, expected: str) -> None:
    start = {"launch/start.launch.py": "PATH = share + '/config/real/a.yaml'\n"}
    kept = levels(code, PYTHON, {path.format("real"): text, **start})
    assert len(kept) == 1
    assert kept != ["info"]
    assert levels(code, PYTHON, {path.format("old"): text}) == [expected]


@pytest.mark.parametrize(
    ("path", "text", "level"),
    [
        ("urdf/arm.urdf", "<robot name='r'>", "info"),
        ("urdf/arm.urdf", " ", "info"),
        ("urdf/leg.urdf", "<robot name='r'>", "error"),
    ],
)
def test_a_robot_of_a_name_that_others_have_too(path: str, text: str, level: str) -> None:
    """Who has a file of that name may mean its own."""
    part = '<xacro:include filename="$(find my_pkg)/urdf/{}.urdf"/>'
    top = XACRO.format(part.format("leg") + '<xacro:include filename="$(optenv X arm.urdf)"/>')
    files = {f"my_pkg/{each}": body for each, body in {**NATIVE, path: text}.items()}
    files |= {"b/package.xml": manifest("", "ament_cmake", "b"), "b/CMakeLists.txt": CMAKE.replace("my_pkg", "b")}
    files |= {"b/urdf/top.xacro": top, "b/urdf/arm.urdf": "<robot name='r'/>"}
    files["my_pkg/src/a.cpp"] = '#include "arms/arm.hpp"\n'
    assert levels("RPK001", {}, files) == ["info"]
    files["b/launch/show.launch.py"] = "MODEL = get_package_share_directory('b') + '/urdf/top.xacro'\n"
    assert levels("RPK001", {}, files) == [level]


@pytest.mark.parametrize(("included", "level"), [("urdf/parts/leg.urdf", "info"), ("urdf/leg.urdf", "error")])
def test_a_robot_of_a_name_that_another_folder_has_too(included: str, level: str) -> None:
    top = XACRO.format(f'<xacro:include filename="$(find my_pkg)/{included}"/>')
    files = {**NATIVE, "urdf/top.xacro": top, "urdf/leg.urdf": "<robot name='r'>"}
    assert levels("RPK001", {}, {**files, "urdf/parts/leg.urdf": "<robot name='r'/>"}) == ["info"]
    files["launch/show.launch.py"] = "MODEL = share + '/urdf/top.xacro'\n"
    assert levels("RPK001", {}, {**files, "urdf/parts/leg.urdf": "<robot name='r'/>"}) == [level]


@pytest.mark.parametrize(("name", "level"), [("game_backup", "info"), ("game", "error")])
def test_a_module_called_a_backup_is_asked_mildly_about_fields(name: str, level: str) -> None:
    code = "from std_msgs.msg import String\n\n\ndef say():\n    text = String()\n    text.dta = 'a'\n"
    setup = SETUP_PY.replace(
        "    license=", "    entry_points={'console_scripts': ['a = my_pkg.a:main']},\n    license="
    )
    main = f"from my_pkg.{name} import say\n\n\ndef main():\n    say()\n"
    files = {"setup.py": setup, "my_pkg/a.py": main, f"my_pkg/{name}.py": code}
    assert levels("IDL010", PYTHON, {**files, "package.xml": manifest("  <exec_depend>std_msgs</exec_depend>\n")}) == [
        level
    ]


@pytest.mark.parametrize(
    ("path", "importer", "count"),
    [
        ("my_pkg/launch/view.launch.py", "", 0),
        ("my_pkg/launch/view.launch.py", "from my_pkg.launch import view\n", 1),
        ("my_pkg/speech/view.py", "", 1),
    ],
)
def test_a_folder_of_launch_files_is_no_python_package(path: str, importer: str, count: int) -> None:
    assert len(levels("SET301", PYTHON, {path: "A = 1\n", "my_pkg/talker.py": importer})) == count


NAV = (
    "planner_server:\n  ros__parameters:\n    planner_plugins: [GridBase]\n    GridBased:\n"
    "      plugin: nav2_navfn_planner/NavfnPlanner\n"
)


@pytest.mark.parametrize(("name", "count"), [("nav2_params_foxy", 0), ("nav2_params", 1)])
def test_lists_of_plugins_for_a_distribution_that_is_gone(name: str, count: int) -> None:
    assert len(levels("PRM008", NATIVE, {f"config/{name}.yaml": NAV})) == count


@pytest.mark.parametrize(("other", "found"), [("A", []), ("B", ["info"])])
def test_a_class_that_what_is_compiled_registers_too(other: str, found: list[str]) -> None:
    macro = "RCLCPP_COMPONENTS_REGISTER_NODE(my_pkg::{})\n"
    files = {"CMakeLists.txt": LIBRARY, "src/a.cpp": macro.format("A"), "src/b.cpp": macro.format(other)}
    assert levels("CMK202", NATIVE, files) == found


@pytest.mark.parametrize(("text", "count"), [("", 0), ("\n", 0), ("<launch/>\n", 1)])
def test_an_empty_launch_file_is_a_placeholder(text: str, count: int) -> None:
    assert len(levels("CMK101", NATIVE, {"launch/a.launch.xml": text})) == count


EARS = """\
from std_msgs.msg import String

from .device import Device


class Ears(Device):
    def __init__(self, node):
        super().__init__(node)
        self.ready = hasattr(self, 'stream'){}

    def hear(self):
        text = String()
        text.dta = 'a'

    def start(self):
        self._node.create_timer(1.0, self.hear)
"""
DEVICE = "class Device:\n    def __init__(self, node):\n        self._node = node{}\n"
MAKES = """\
import rclpy

from .ears import Ears


def turn(node):
    rclpy.spin(node)


def main():
    ears = Ears(None)
{}"""


@pytest.mark.parametrize(
    ("ears", "device", "makes", "level"),
    [
        ("", "", "", "info"),
        ("", "", "    return [ears]\n", "info"),
        ("", "", "    ears.start()\n", "error"),
        ("", "", "    Ears(None).start()\n", "error"),
        ("", "", "\n\nclass More(Ears):\n    pass\n", "info"),
        ("; self.hear()", "", "", "error"),
        ("; self.start()", "", "", "error"),
        ("; node.add(self)", "", "", "info"),
        ("", "; self.start()", "", "error"),
        ("", "; node.add(self)", "", "info"),
        ("", "\n\n\nclass Other:\n    pass", "", "info"),
    ],
)
def test_a_method_of_an_object_that_is_made_and_never_used(ears: str, device: str, makes: str, level: str) -> None:
    files = {
        "package.xml": manifest("  <exec_depend>std_msgs</exec_depend>\n"),
        "setup.py": setup_py(scripts("a = my_pkg.a:main")),
        "my_pkg/a.py": MAKES.format(makes),
        "my_pkg/ears.py": EARS.format(ears),
        "my_pkg/device.py": DEVICE.format(device),
    }
    assert levels("IDL010", PYTHON, files) == [level]
    foreign = {**files, "my_pkg/ears.py": EARS.format(ears).replace("from .device", "from devices")}
    is_called = "start" in makes or "self.hear" in ears or "self.start" in ears  # what a foreign base does is not shown
    assert levels("IDL010", PYTHON, {**foreign, "my_pkg/device.py": ""}) == ["error" if is_called else "info"]
