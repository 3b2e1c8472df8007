"""What fails for nobody today is an info at most: something declared brings it, or nothing asks for it."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, SETUP_PY, XMLLINT, existing_files, manifest, setup_py
from rospkg_cli.finding import Finding, Safety
from rospkg_cli.rules.cmake import cmk112_script_not_installed as cmk112
from rospkg_cli.rules.cmake import cmk113_missing_export_dependency as cmk113
from rospkg_cli.rules.interfaces import idl007_missing_interface_dependency as idl007
from rospkg_cli.rules.manifest import xml002_element_order as xml002
from rospkg_cli.rules.manifest import xml208_missing_buildtool as xml208
from rospkg_cli.rules.manifest import xml305_missing_interface_group as xml305
from rospkg_cli.testing import lint_files

NATIVE = existing_files(BACKDROPS["ament_cmake"])
LINES = "install(DIRECTORY config launch other DESTINATION share/${PROJECT_NAME})\nament_package"
INSTALLED = {**NATIVE, "CMakeLists.txt": CMAKE.replace("ament_package", LINES)}
PYTHON = existing_files(BACKDROPS["ament_python"])
INTERFACES = existing_files(BACKDROPS["interfaces"])


def found(code: str, on: dict[str, str], files: dict[str, str]) -> list[Finding]:
    return list(lint_files({**on, **files}, [code]).findings)


def levels(code: str, on: dict[str, str], files: dict[str, str]) -> list[str]:
    return [each.severity.value for each in found(code, on, files)]


def needing(tag: str, name: str) -> str:
    return xml208.BAD.replace("  <export>", f"  <{tag}>{name}</{tag}>\n  <export>")


@pytest.mark.parametrize("tag", ["exec_depend", "test_depend"])
def test_what_rosdep_installs_with_ament_cmake_is_lacked_by_releases(tag: str) -> None:
    for more, level in (({}, "info"), ({"tracks.yaml": "tracks: {}\n"}, "warning")):
        (finding,) = found("XML208", NATIVE, {"package.xml": needing(tag, "rclcpp"), **more})
        assert finding.severity.value == level
        assert "on the build farm" in finding.message


@pytest.mark.parametrize(
    ("tag", "name", "level"),
    [
        ("depend", "rclcpp", "info"),
        ("build_depend", "rosidl_default_generators", "info"),
        ("depend", "eigen", "warning"),
    ],
)
def test_ament_cmake_comes_with_what_is_there_to_build(tag: str, name: str, level: str) -> None:
    (finding,) = found("XML208", NATIVE, {"package.xml": needing(tag, name)})
    assert finding.severity.value == level
    assert (f"it comes with `{name}` today" in finding.message) is (level == "info")


@pytest.mark.parametrize(
    ("line", "body", "level"),
    [
        ("group", "", "error"),
        ("generators", "", "warning"),
        ("runtime", "", "warning"),
        ("runtime", "  <depend>std_msgs</depend>\n", "info"),
        ("runtime", "  <build_depend>std_msgs</build_depend>\n", "warning"),
    ],
)
def test_what_an_interface_package_lacks(line: str, body: str, level: str) -> None:
    lines = [each for each in xml305.GOOD.splitlines(keepends=True) if line not in each]
    text = "".join(lines).replace("  <export>", f"{body}  <export>")
    files = {"package.xml": text, "CMakeLists.txt": xml305.CMAKE, "msg/Battery.msg": "float32 level\n"}
    (finding,) = found("XML305", NATIVE, files)
    assert finding.severity.value == level
    assert ("it comes with `std_msgs` today" in finding.message) is (level == "info")


@pytest.mark.parametrize(
    ("tag", "passed_on", "level"),
    [
        ("depend", "depend", "info"),
        ("build_depend", "exec_depend", "info"),
        ("depend", "buildtool_depend", "warning"),
        ("exec_depend", "depend", "warning"),
    ],
)
def test_generators_that_come_with_other_messages(tag: str, passed_on: str, level: str) -> None:
    """They are there where a dependency for building passes them on, not where it only builds with them."""
    lines = "".join(each for each in xml305.GOOD.splitlines(keepends=True) if "generators" not in each)
    text = lines.replace("  <export>", f"  <{tag}>other_msgs</{tag}>\n  <export>")
    files = {"a/package.xml": text, "a/CMakeLists.txt": xml305.CMAKE, "a/msg/Battery.msg": "float32 level\n"}
    body = f"  <{passed_on}>rosidl_default_generators</{passed_on}>\n"
    other = manifest(body, "ament_cmake", "other_msgs")
    found = lint_files(
        {**files, "b/package.xml": other, "b/CMakeLists.txt": CMAKE.replace("my_pkg", "other_msgs")}, ["XML305"]
    )
    (finding,) = found.findings
    assert finding.severity.value == level
    assert ("it comes with `other_msgs` today" in finding.message) is (level == "info")


MODEL = '<?xml-model href="http://download.ros.org/schema/package_format3.xsd" '
XSD = 'schematypens="http://www.w3.org/2001/XMLSchema"?>'


@pytest.mark.parametrize(
    ("model", "level"),
    [
        (MODEL + XSD, "warning"),
        ('<?xml-model href="" ' + XSD, "info"),
        (MODEL + "?>", "info"),
        (MODEL.replace("format3", "format2") + XSD, "info"),
        (MODEL + 'schematypens="http://relaxng.org/ns/structure/1.0"?>', "info"),
    ],
)
def test_an_order_that_ament_xmllint_has_no_schema_for(model: str, level: str) -> None:
    text = xml002.BAD.replace("«", "").replace("»", "")
    assert MODEL + XSD in text
    files = {"package.xml": text.replace(MODEL + XSD, model), "test/test_xmllint.py": XMLLINT}
    (finding,) = found("XML002", PYTHON, files)
    assert finding.severity.value == level
    assert ("names no schema" in finding.message) is (level == "info")


@pytest.mark.parametrize(
    ("setup", "level"),
    [
        (SETUP_PY, "warning"),
        ("from setuptools import setup\nsetup(name='my_pkg', packages=['my_pkg'])\n", "warning"),
        ("from catkin_pkg.python_setup import generate_distutils_setup as g\nsetup(**g(scripts=['a']))\n", "info"),
        ("from catkin_pkg.python_setup import generate_distutils_setup as g\nsetup(**g())\n", "info"),
    ],
)
def test_an_ignored_setup_py_that_installs_nothing(setup: str, level: str) -> None:
    files = {"setup.py": setup, "my_pkg/__init__.py": "", "my_pkg/arm.py": ""}
    (finding,) = found("XML307", NATIVE, files)
    assert finding.severity.value == level
    assert ("which installs nothing" in finding.message) is (level == "info")


def test_an_ignored_setup_py_whose_setup_cfg_starts_modules() -> None:
    cfg = "[options.entry_points]\nconsole_scripts =\n  arm = my_pkg.arm:main\n"
    files = {"setup.py": "import setuptools\nsetuptools.setup()\n", "setup.cfg": cfg, "my_pkg/arm.py": ""}
    assert levels("XML307", NATIVE, files) == ["warning"]
    assert levels("XML307", NATIVE, {**files, "setup.cfg": "[metadata]\nname = my_pkg\n"}) == ["info"]


def exporting(link: str, exported: str, **more: str) -> dict[str, str]:
    lines = cmk113.LINES.replace("${std_msgs_TARGETS}", link).replace("cies(rclcpp)", f"cies({exported})")
    text = cmk113.cmake(lines).replace("«", "").replace("»", "")
    return {**cmk113.FILES, "CMakeLists.txt": text, **more}


@pytest.mark.parametrize(
    ("link", "exported", "expected"),
    [
        ("${std_msgs_TARGETS}", "rclcpp", ["info"]),
        ("std_msgs::std_msgs", "rclcpp", ["info"]),
        ("std_msgs::std_msgs", "rclcpp Eigen3", ["info"]),
        ("${std_msgs_LIBRARIES}", "rclcpp", []),
        ("std_msgs::std_msgs", "rclcpp rmf_traffic", []),
        ("std_msgs::std_msgs", "rclcpp vision_msgs", []),
    ],
)
def test_what_users_of_a_library_must_find(link: str, exported: str, expected: list[str]) -> None:
    assert levels("CMK113", NATIVE, exporting(link, exported)) == expected


@pytest.mark.parametrize(("listed", "expected"), [("action_msgs", ["error"]), ("vision_msgs", []),
                                                  ("rmf_fleet_msgs", ["error"]), ("acme_msgs", [])])  # fmt: skip
def test_dependencies_of_interfaces_are_recursive(listed: str, expected: list[str]) -> None:
    text = idl007.GOOD.replace("DEPENDENCIES std_msgs", f"DEPENDENCIES {listed}")
    assert levels("IDL007", INTERFACES, {**idl007.FILES, "CMakeLists.txt": text}) == expected


def finding_package(name: str, *declared: str) -> Finding:
    body = "".join(f"  <depend>{each}</depend>\n" for each in declared)
    text = CMAKE.replace("ament_package()", f"find_package({name} REQUIRED)\nament_package()")
    (finding,) = found("DEP104", NATIVE, {"CMakeLists.txt": text, "package.xml": manifest(body, "ament_cmake")})
    return finding


def test_a_key_without_a_rule_is_not_asked_for() -> None:
    finding = finding_package("gz-math7")
    assert (finding.severity.value, finding.fix) == ("info", None)
    assert "declare the vendor package that brings it" in finding.message
    installable = finding_package("Eigen3")
    assert installable.severity.value == "warning"
    assert installable.fix is not None
    assert installable.fix.safety is Safety.SAFE


@pytest.mark.parametrize(
    ("declared", "harm"),
    [
        ("ignition-gui6", "it may come with `ignition-gui6`"),
        ("libpcl-all-dev", "it comes with `libpcl-all-dev` today"),
        ("python3-numpy", "on a clean machine the build stops"),
    ],
)
def test_a_library_of_the_system_may_bring_others(declared: str, harm: str) -> None:
    assert harm in finding_package("Qt5", declared).message


ENTRY = "        ('share/' + package_name, ['package.xml']),\n"
GLOB = "from glob import glob\n" + setup_py().replace(
    ENTRY, ENTRY + "        ('share/' + package_name + '/config', glob('config/*.yaml')),\n"
)
CONFIG = {"setup.py": GLOB, "config/a.yaml": "a: 1\n"}


@pytest.mark.parametrize(
    ("files", "level"),
    [
        ({"config/view.rviz": "Panels: []\n"}, "info"),
        ({"config/b.yml": "a: 1\n"}, "info"),
        ({"config/b.yml": "a: 1\n", "my_pkg/a.py": "x = 'b.yml'\n"}, "info"),
        ({"config/view.rviz": "Panels: []\n", "config/b.yml": "a: 1\n", "README.md": "Change b.yml\n"}, "info"),
        ({"config/view.rviz": "Panels: []\n", "launch/a.launch.py": "x = 'view.rviz'\n"}, "info"),
        ({"config/view.rviz": "Panels: []\n", "README.md": "Open view.rviz\n"}, "info"),
        ({"config/view.rviz": "Panels: []\n", "my_pkg/a.py": "x = 'src/my_pkg/config/view.rviz'\n"}, "info"),
        (
            {"config/b.yml": "a: 1\n", "launch/a.launch.xml": "<a b='$(find-pkg-share my_pkg)/config/b.yml'/>"},
            "warning",
        ),
        ({"config/b.yml": "a: 1\n", "launch/a.launch.xml": "<a b='$(find-pkg-share other)/config/b.yml'/>"}, "info"),
        ({"config/b.yml": "a: 1\n", "urdf/a.xacro": "<a b='package://other/config/b.yml'/>"}, "info"),
        ({"config/in/b.yaml": "a: 1\n", "my_pkg/a.py": "x = 'config/in/b.yaml'\n"}, "info"),
        ({"config/in/b.yaml": "a: 1\n", "launch/a.launch.xml": "<a b='$(find-pkg-share other)/in/c.yaml'/>"}, "info"),
    ],
)
def test_a_file_that_nothing_names(files: dict[str, str], level: str) -> None:
    assert levels("SET207", PYTHON, {**CONFIG, **files}) == [level]


@pytest.mark.parametrize(
    ("name", "more", "expected"),
    [
        ("save.sh", {}, []),
        ("save.bash", {}, []),
        ("save.sh", {"README.md": "Run save.sh\n"}, []),
        ("save.sh", {"README.md": "Run `ros2 run my_pkg save.sh`\n"}, ["warning"]),
        ("save.sh", {"README.md": "Run ros2 run my_pkg save.sh.old\n"}, []),
        ("save.py", {}, ["info"]),
        ("save.py", {"launch/a.launch.py": "x = 'save.py'\n"}, ["warning"]),
    ],
)
def test_a_shell_helper_that_nothing_names(name: str, more: dict[str, str], expected: list[str]) -> None:
    files = {"CMakeLists.txt": cmk112.ONE.replace("«", "").replace("»", ""), "scripts/hello.py": cmk112.SCRIPT, **more}
    text = "#!/bin/sh\nros2 topic list\n"
    script = {f"scripts/{name}": text}
    assert levels("CMK112", NATIVE, {**files, **script}) == expected


CONTROLLERS = """\
controller_manager:
  ros__parameters:
    arm:
      type: joint_trajectory_controller/JointTrajectoryController
"""
STARTS = '<launch><node pkg="controller_manager" exec="spawner">{}</node></launch>\n'


@pytest.mark.parametrize(
    ("name", "launch", "level"),
    [
        ("arm", STARTS.format(""), "info"),
        ("arm", STARTS.format('<param from="$(find-pkg-share my_pkg)/config/arm.yaml"/>'), "warning"),
        ("arm", STARTS.format("<!-- arm.yaml -->"), "info"),
        ("arm", STARTS.format("<!-- a --><param from='arm.yaml'/><!-- b -->"), "warning"),
        ("arm_example", STARTS.format(""), "info"),
        ("arm_example", STARTS.format('<param from="$(find-pkg-share my_pkg)/config/arm_example.yaml"/>'), "warning"),
    ],
)
def test_an_example_of_parameters_that_no_launch_file_loads(name: str, launch: str, level: str) -> None:
    files = {"package.xml": manifest("  <exec_depend>controller_manager</exec_depend>\n")}
    files |= {f"config/{name}.yaml": CONTROLLERS, "launch/a.launch.xml": launch}
    assert levels("DEP106", PYTHON, files) == [level]


@pytest.mark.parametrize(("is_metapackage", "level"), [(False, "warning"), (True, "info")])
def test_a_metapackage_opens_no_folder(is_metapackage: bool, level: str) -> None:
    user = manifest("", "ament_cmake", "b").replace("  <export>", "  <exec_depend>my_pkg</exec_depend>\n  <export>")
    files = {"a/package.xml": manifest("", "ament_cmake"), "a/CMakeLists.txt": CMAKE, "a/config/a.txt": "a: 1\n"}
    files |= {"b/package.xml": user, "b/CMakeLists.txt": CMAKE.replace("my_pkg", "b")}
    opens = 'auto path = get_package_share_directory("my_pkg") + "/config/a.txt";\n'
    files |= {} if is_metapackage else {"b/src/b.cpp": opens}
    (finding,) = [each for each in lint_files(files, ["CMK101"]).findings if "config" in each.message]
    assert finding.severity.value == level


@pytest.mark.parametrize(("start", "level"), [("", "error"), ("# ", "info")])
def test_what_is_commented_out_opens_no_folder(start: str, level: str) -> None:
    line = f"{start}path = get_package_share_directory('my_pkg') + '/config/a.yaml'\n"
    files = {"package.xml": manifest("", "ament_cmake"), "CMakeLists.txt": CMAKE, "config/a.yaml": "a: 1\n"}
    found = found_all("CMK101", {**files, "my_pkg/a.py": line, "src/a.cpp": "# x\n"})
    assert [each.severity.value for each in found] == [level]


QT = "macro(qt_wrap_ui)\n  {}(${{ARGN}})\nendmacro()\n"


@pytest.mark.parametrize(("command", "count"), [("qt5_wrap_ui", 0), ("message", 1)])
def test_a_command_of_qt_may_be_defined_by_the_one_of_a_version(command: str, count: int) -> None:
    text = CMAKE.replace("ament_package", QT.format(command) + "ament_package")
    assert len(found_all("CMK116", {"package.xml": manifest("", "ament_cmake"), "CMakeLists.txt": text})) == count


@pytest.mark.parametrize(("path", "count"), [("plugins/own", 0), ("other", 1)])
def test_a_plugin_in_a_submodule_that_is_not_there_is_none_that_is_missing(path: str, count: int) -> None:
    text = manifest("", "ament_cmake").replace(
        "</build_type>\n", '</build_type>\n    <rqt_gui plugin="${prefix}/plugins/own/p.xml"/>\n'
    )
    files = {
        "package.xml": text,
        "CMakeLists.txt": CMAKE,
        ".gitmodules": f'[submodule "a"]\n\tpath = {path}\n\turl = b\n',
    }
    assert len(found_all("XML306", files)) == count


def test_a_text_with_a_line_end_is_no_path_of_a_file() -> None:
    code = (
        "from os.path import join\nfrom ament_index_python.packages import get_package_share_directory\n\n"
        "ALL = join(get_package_share_directory('my_pkg'), 'package.xm')"
    )
    codes = [len(found_all("DEP113", {**PYTHON, "my_pkg/a.py": code + end})) for end in ("\n", " + '\\n'\n")]
    assert codes == [1, 0]


def found_all(code: str, files: dict[str, str]) -> list[Finding]:
    return list(lint_files(files, [code]).findings)


@pytest.mark.parametrize(
    ("path", "line", "level"),
    [
        ("CMakeLists.txt", b"# \xa9\xb6\n", "info"),
        ("CMakeLists.txt", b"#[[\n\xa9\\ ]]\n", "info"),
        ("CMakeLists.txt", b"# \xa9\nmessage(\xa9)\n", "error"),
        ("CMakeLists.txt", b'message("\xa9")\n', "error"),
        ("package.xml", b"<!-- \xa9 -->\n", "error"),
    ],
)
def test_bytes_that_are_no_text_in_comments_of_cmake(path: str, line: bytes, level: str) -> None:
    (finding,) = lint_files({**NATIVE, path: NATIVE[path].encode() + line}, ["RPK001"]).findings
    assert finding.severity.value == level
    assert finding.message.endswith("; CMake reads past these bytes, since only comments hold them") is (
        level == "info"
    )


def test_an_included_file_of_cmake_with_bytes_that_are_no_text() -> None:
    lines = CMAKE.replace("ament_package", "include(cmake/a.cmake)\nament_package")
    found = lint_files({**NATIVE, "CMakeLists.txt": lines, "cmake/a.cmake": b"# \xa9\n"}, ["RPK001"]).findings
    assert [each.severity.value for each in found] == ["info"]


LINTED = "find_package(ament_lint_auto REQUIRED)\nament_lint_auto_find_test_dependencies()\n"


@pytest.mark.parametrize(
    ("depend", "call", "level"),
    [
        ("ament_xmllint", "", "info"),
        ("ament_xmllint", "ament_xmllint()\n", "warning"),
        ("ament_cmake_xmllint", "", "warning"),
    ],
)
def test_what_runs_ament_xmllint_in_cmake(depend: str, call: str, level: str) -> None:
    text = (
        xml002.BAD.replace("«", "")
        .replace("»", "")
        .replace("ament_xmllint", depend)
        .replace("ament_python", "ament_cmake")
    )
    cmake = CMAKE.replace("ament_package", f"{LINTED}{call}ament_package")
    (finding,) = found("XML002", NATIVE, {"package.xml": text, "CMakeLists.txt": cmake})
    assert finding.severity.value == level


@pytest.mark.parametrize(
    ("text", "level"),
    [
        ('<?xml version="1.0"?>\n<!-- all -->\n<library path="a"/>\n<library path="b"/>\n', "info"),
        ("<class_libraries/>\n<library path='b'/>\n", "error"),
        ('<library path="a">\n', "error"),
    ],
)
def test_plugins_without_a_root_around_them(text: str, level: str) -> None:
    lines = CMAKE.replace(
        "ament_package", "pluginlib_export_plugin_description_file(nav2_core plugins.xml)\nament_package"
    )
    found = lint_files({**NATIVE, "CMakeLists.txt": lines, "plugins.xml": text}, ["RPK001"]).findings
    assert [each.severity.value for each in found] == [level]


@pytest.mark.parametrize(("matching", "level"), [("", "error"), (' FILES_MATCHING PATTERN "*.py"', "info")])
def test_a_folder_of_which_only_some_files_are_installed_may_be_missing(matching: str, level: str) -> None:
    line = f"install(DIRECTORY launch/ DESTINATION share/${{PROJECT_NAME}}{matching})\nament_package"
    files = {**NATIVE, "CMakeLists.txt": CMAKE.replace("ament_package", line)}
    assert [each.severity.value for each in lint_files(files, ["CMK102"]).findings] == [level]


@pytest.mark.parametrize(("listed", "count"), [("'my_pkg'", 1), ("'my_pkg', 'my_pkg/inner'", 0)])
def test_a_package_may_be_listed_as_a_path(listed: str, count: int) -> None:
    setup = PYTHON["setup.py"].replace("find_packages(exclude=['test'])", f"[{listed}]")
    files = {**PYTHON, "setup.py": setup, "my_pkg/inner/__init__.py": "", "my_pkg/a.py": "import my_pkg.inner\n"}
    assert len(lint_files(files, ["SET302"]).findings) == count


@pytest.mark.parametrize(("launched", "level"), [("base.yaml", "info"), ("arm.yaml", "error")])
def test_blocks_without_their_key_in_a_file_that_nothing_names(launched: str, level: str) -> None:
    launch = (
        f"<launch><node pkg='a' exec='b'><param from='$(find-pkg-share my_pkg)/config/{launched}'/></node></launch>\n"
    )
    texts = {
        "config/arm.yaml": "a:\n  ros__parameters:\n    x: 1\nb:\n  y: 1\n",
        "config/base.yaml": "/**:\n  ros__parameters: {}\n",
    }
    (found,) = lint_files({**INSTALLED, **texts, "launch/a.launch.xml": launch}, ["PRM001"]).findings
    assert found.severity.value == level


@pytest.mark.parametrize(
    ("launched", "level"), [("other/arm.yaml", "info"), ("config/arm.yaml", "error"), ("arm.yaml", "warning")]
)
def test_a_launch_file_that_names_another_file_of_the_same_name(launched: str, level: str) -> None:
    start = "<launch><node pkg='a' exec='b'><param from='$(find-pkg-share my_pkg)/"
    texts = {
        "config/arm.yaml": "a:\n  ros__parameters:\n  x: 1\n  y: 2\n",
        "other/arm.yaml": "/**:\n  ros__parameters: {}\n",
    }
    files = {**INSTALLED, **texts, "launch/a.launch.xml": f"{start}{launched}'/></node></launch>\n"}
    (found,) = lint_files(files, ["PRM004"]).findings
    assert (found.severity.value, len(found.related)) == (level, 1)
    assert found.message.endswith(": indent them")


def test_an_empty_block_without_values_beside_it() -> None:
    texts = {"config/arm.yaml": "a:\n  ros__parameters:\nb:\n  ros__parameters:\n  x: 1\n"}
    said = [each.message.partition(";")[0] for each in lint_files({**NATIVE, **texts}, ["PRM004"]).findings]
    assert said == ["`ros__parameters` of `a` is empty", "the value of `x` is outside of the `ros__parameters:` of `b`"]
