"""What the rules of package.xml say beyond their examples, and where they keep quiet."""

from __future__ import annotations

from itertools import combinations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, manifest
from rospkg_cli.finding import Severity
from rospkg_cli.testing import lint_files

PYTHON = {path: text for path, text in BACKDROPS["ament_python"].items() if text is not None}
INTERFACES = {
    "CMakeLists.txt": CMAKE.replace(
        "ament_package", 'rosidl_generate_interfaces(${PROJECT_NAME} "msg/A.msg")\nament_package'
    ),
    "msg/A.msg": "int32 a\n",
}


def found(body: str = "", files: dict[str, str] | None = None, codes: str = "XML", **changes: str) -> list[str]:
    """The codes for a package whose manifest has `body` as dependencies; `changes` are texts to replace, old=new."""
    text = manifest(body)
    for old, new in changes.items():
        assert old in text
        text = text.replace(old, new)
    results = lint_files({**PYTHON, "package.xml": text, **(files or {})})
    return [f.code for f in results.findings if f.code.startswith(codes)]


def cmake(body: str = "", files: dict[str, str] | None = None, text: str = "") -> list[str]:
    every = {
        "package.xml": text or manifest(body, build_type="ament_cmake"),
        "CMakeLists.txt": CMAKE,
        "LICENSE": "MIT\n",
    }
    return [f.code for f in lint_files({**every, **(files or {})}).findings if f.code.startswith("XML")]


def test_three_faults_are_three_findings() -> None:
    body = "  <exec_depend>a</exec_depend>\n  <exec_depnd>b</exec_depnd>\n  <exec_depend>a</exec_depend>\n"
    results = lint_files(
        {**PYTHON, "package.xml": manifest(body).replace("1.0.0", "1.0")}, ["XML001", "XML103", "XML201"]
    )
    assert [f.code for f in results.findings] == ["XML103", "XML001", "XML201"]
    assert "did you mean `exec_depend`?" in results.findings[1].message


FAULTS = {
    "XML001 missing": lambda t: t.replace("  <license>Apache-2.0</license>\n", ""),
    "XML001 unknown": lambda t: t.replace("  <export>", "  <bogus/>\n  <export>"),
    "XML001 attribute": lambda t: t.replace("<license>", '<license lang="en">'),
    "XML002": lambda t: t.replace("  <version>", "  <author>Bob</author>\n  <version>"),
    "XML101": lambda t: t.replace("<name>my_pkg", "<name>my__pkg"),
    "XML103": lambda t: t.replace("<version>1.0.0", "<version>1.0"),
    "XML104": lambda t: t.replace("Drives my robot", "TODO"),
    "XML105": lambda t: t.replace("ada@example.org", "ada"),
    "XML204": lambda t: t.replace("<exec_depend>", '<exec_depend condition="$ROS_VERSION = 2">'),
    "XML205": lambda t: t.replace("<test_depend>", '<test_depend version_gt="x">'),
    "XML210": lambda t: t.replace("  <export>", "  <depend/>\n  <export>"),
    "XML302": lambda t: t.replace("<build_type>ament_python", "<build_type>ament_pyton"),
}


def test_any_three_faults_are_three_findings() -> None:
    good = manifest("  <exec_depend>rclpy</exec_depend>\n  <test_depend>python3-pytest</test_depend>\n")
    rules = sorted({name.partition(" ")[0] for name in FAULTS})
    for three in combinations(FAULTS, 3):
        text = good
        for name in three:
            text = FAULTS[name](text)
        seen = [f.code for f in lint_files({**PYTHON, "package.xml": text}, rules).findings]
        if {"XML001 missing", "XML001 attribute"} <= set(three):  # the license is gone with its attribute
            seen.append("XML001")
        assert sorted(seen) == sorted(name.partition(" ")[0] for name in three), three


@pytest.mark.parametrize(
    "license",
    [
        "Apache License, Version 2.0", "GPLv2 or later", "BSD 3-Clause License", "MIT OR Apache-2.0", "Proprietary",
        "GPL-2.0-only WITH Classpath-exception-2.0", "Boost Software License 1.0", "GNU General Public License v3",
        "Creative Commons Attribution-NonCommercial-ShareAlike 4.0 International", "BSD",
        'GNU Library or "Lesser" General Public License version 2.1 or any later version',
    ],
)  # fmt: skip
def test_one_license_is_clear(license: str) -> None:
    assert "XML106" not in found(**{"Apache-2.0": license})


@pytest.mark.parametrize(
    "license",
    [
        "BSD, MIT",
        "BSD/Apache 2.0",
        "MIT and Apache-2.0",
        "GPLv2 &amp; LGPL",
        "refer to the file LICENSE",
        "https://x.org/l",
    ],
)
def test_several_licenses_or_a_story_are_unclear(license: str) -> None:
    assert "XML106" in found(**{"Apache-2.0": license})


@pytest.mark.parametrize(
    "description",
    ["Todo lists on a robot", "A package for arms", "The driver package of the my_pkg robot", "Descriptions"],
)
def test_descriptions_that_say_something(description: str) -> None:
    assert "XML104" not in found(**{"Drives my robot": description})


@pytest.mark.parametrize(
    "description", ["TODO", "TODO: Package description", "my_pkg", "The my_pkg package.", "none", "tbd"]
)
def test_descriptions_that_say_nothing(description: str) -> None:
    assert "XML104" in found(**{"Drives my robot": description})


def test_an_empty_description_is_an_error() -> None:
    text = manifest().replace("Drives my robot", " ")
    assert [f.severity for f in lint_files({**PYTHON, "package.xml": text}, ["XML104"]).findings] == [Severity.ERROR]


@pytest.mark.parametrize("inside", ["<p>It drives.</p>", "<![CDATA[It drives]]>", "<img src='a.png'/>"])
def test_xhtml_is_a_description(inside: str) -> None:
    assert found(**{"Drives my robot": inside}) == []


def test_names() -> None:
    def level(name: str, **files: str) -> Severity | None:
        text = manifest(build_type="ament_cmake").replace("my_pkg", name)
        cmake = CMAKE.replace("my_pkg", name).replace("ament_package", f"{files.pop('call', '')}ament_package")
        results = lint_files({"package.xml": text, "CMakeLists.txt": cmake, **files}, ["XML101"])
        return next((f.severity for f in results.findings), None)

    assert level("my-pkg", **{"my-pkg/__init__.py": ""}) is Severity.WARNING
    assert level("my-pkg", **{"my_pkg/__init__.py": ""}) is level("MyPkg", **{"MyPkg/__init__.py": ""}) is Severity.INFO
    assert level("my-pkg") is level("MyPkg") is Severity.INFO
    generated = {"msg/A.msg": "int32 a\n", "call": "rosidl_generate_interfaces(${PROJECT_NAME} msg/A.msg)\n"}
    left = {**generated, "call": f"# {generated['call']}"}
    assert level("my-pkg", **generated) is level("MyPkg", **generated) is Severity.ERROR
    assert level("my-pkg", **left) is level("MyPkg", **left) is Severity.WARNING
    assert [level(name) for name in ("my pkg", "_pkg", "")] == [Severity.ERROR] * 3
    built = ("a", "my__pkg", "my_pkg_", "1pkg")
    assert [level(name) for name in built] == [Severity.INFO] * 4
    assert [level(name, **left) for name in built] == [Severity.INFO] * 4
    for files in ({"tracks.yaml": "tracks: {}\n"}, generated):
        assert [level(name, **files) for name in built] == [Severity.ERROR] * 4
    assert level("m2") is None


@pytest.mark.parametrize(
    "one, other, clash",
    [
        ("", "", True),
        ("", ' condition="$ROS_VERSION == 2"', True),
        (' condition="$ROS_DISTRO == humble"', ' condition="$ROS_DISTRO == jazzy"', False),
        (' condition="$ROS_DISTRO == humble"', ' condition="$ROS_DISTRO != jazzy"', True),
        ("", ' condition="$ROS_VERSION == 1"', False),
        ("", ' condition="$OURS == 1"', False),
        (' condition="$OURS == 1"', ' condition="$OURS == 1"', True),
        (' version_gte="1"', "", True),
    ],
)
def test_depend_beside_one_of_its_parts(one: str, other: str, clash: bool) -> None:
    body = f"  <depend{one}>rclcpp</depend>\n  <exec_depend{other}>rclcpp</exec_depend>\n"
    assert ("XML202" in cmake(body)) is clash


@pytest.mark.parametrize(
    "one, other, level",
    [
        ("", "", "error"),
        (' condition="$OURS == 1"', ' condition="$OURS == 1"', "error"),
        ("", ' condition="$ROS_VERSION == 2"', "info"),
        (' condition="$ROS_DISTRO == humble"', "", "info"),
        (' version_gte="1"', "", "info"),
    ],
)
def test_what_colcon_takes_beside_depend_is_an_info(one: str, other: str, level: str) -> None:
    body = f"  <depend{one}>rclcpp</depend>\n  <exec_depend{other}>rclcpp</exec_depend>\n"
    (finding,) = lint_files({**PYTHON, "package.xml": manifest(body)}, ["XML202"]).findings
    assert finding.severity.value == level
    assert ("colcon takes it" in finding.message) == (level == "info")


@pytest.mark.parametrize(("more", "level"), [({}, "info"), ({"tracks.yaml": "tracks: {}\n"}, "error")])
@pytest.mark.parametrize(
    ("limits", "is_empty"), [('version_gte="2" version_lt="1"', True), ('version_eq="1" version_lt="2"', False)]
)
def test_only_a_release_is_held_to_its_limits(limits: str, is_empty: bool, more: dict[str, str], level: str) -> None:
    body = f"  <exec_depend {limits}>rclpy</exec_depend>\n"
    (finding,) = lint_files({**PYTHON, "package.xml": manifest(body), **more}, ["XML205"]).findings
    assert finding.severity.value == (level if is_empty else "info")


def test_the_fix_of_a_redundant_dependency_loses_nothing() -> None:
    body = '  <depend condition="$ROS_DISTRO == humble">x</depend>\n  <exec_depend>x</exec_depend>\n'
    finding = lint_files({**PYTHON, "package.xml": manifest(body)}, ["XML202"]).findings[0]
    assert finding.fix is None


def test_test_dependencies_may_repeat_others_since_format_2() -> None:
    body = "  <depend>rclcpp</depend>\n  <test_depend>rclcpp</test_depend>\n"
    assert "XML202" not in cmake(body)
    one = manifest("  <build_depend>x</build_depend>\n  <test_depend>x</test_depend>\n", build_type="ament_cmake")
    assert "XML202" in cmake(text=one.replace('format="3"', 'format="1"').replace("format3", "format1"))


def test_the_same_name_with_other_limits_or_conditions_is_no_duplicate() -> None:
    body = (
        '  <exec_depend condition="$ROS_DISTRO == humble">x</exec_depend>\n'
        '  <exec_depend condition="$ROS_DISTRO != humble">x</exec_depend>\n'
        '  <test_depend version_gte="1">y</test_depend>\n  <test_depend version_lt="2">y</test_depend>\n'
    )
    assert found(body) == []


@pytest.mark.parametrize(
    "condition, code",
    [
        ("$ROS_DISTRO >= jazzy", None),
        ("$ROS_VERSION > 1", None),
        ("$ROS_VERSION == '2' and ($ROS_DISTRO == humble or $ROS_DISTRO == &quot;jazzy&quot;)", None),
        ("$ROS_PYTHON_VERSION &lt; 10", "XML204"),
        ("ROS_VERSION == 2", "XML204"),
        ("$ROS_VERSION = 2", "XML204"),
        ("$ROS_VERSION", "XML204"),
        ("", "XML204"),
        ("$USER == me", "XML204"),
    ],
)
def test_conditions(condition: str, code: str | None) -> None:
    assert found(f'  <exec_depend condition="{condition}">x</exec_depend>\n') == ([code] if code else [])


@pytest.mark.parametrize(
    "limits, wrong",
    [
        ('version_gte="1" version_lt="2"', False),
        ('version_gte="1.0" version_lte="1"', False),
        ('version_gt="1.0" version_lte="1"', True),
        ('version_eq="1.2.3"', False),
        ('version_eq="1" version_eq="2"', None),
        ('version_gt="1" version_gte="1" version_lt="3"', True),
        ('version_lt="1.x"', True),
    ],
)
def test_version_limits(limits: str, wrong: bool | None) -> None:
    codes = found(f"  <exec_depend {limits}>x</exec_depend>\n", codes="")
    assert codes == (["RPK001"] if wrong is None else ["XML205"] * wrong)


@pytest.mark.parametrize(
    "name", ["ament_cmake", "ament_cmake_auto", "ament_cmake_ros", "autoware_cmake", "eigen3_cmake_module"]
)
def test_everything_of_cmake_is_a_buildtool(name: str) -> None:
    text = manifest(build_type="ament_cmake").replace("<buildtool_depend>ament_cmake<", f"<buildtool_depend>{name}<")
    assert cmake(text=text) == []


MADE = CMAKE.replace("ament_package", "add_library(a a.cpp)\nament_package")


@pytest.mark.parametrize(
    "files, guess, level, happens",
    [
        ({"setup.py": "from setuptools import setup\nsetup()\n"}, "ament_python", "error", "does not build it"),
        ({"CMakeLists.txt": CMAKE}, "ament_cmake", "info", "only `ros2 pkg list` lacks it"),
        ({"CMakeLists.txt": MADE, "a.cpp": ""}, "ament_cmake", "warning", "no command of `ros2` finds it"),
        ({"CMakeLists.txt": "project(my_pkg)\n"}, "cmake", "info", "though it builds it"),
        ({"CMakeLists.txt": "find_package(our_cmake)\n"}, None, "warning", "Package 'my_pkg' not found"),
        ({}, None, "error", "does not build it"),
    ],
)
def test_the_files_say_which_build_type_is_missing_and_what_fails(
    files: dict[str, str], guess: str | None, level: str, happens: str
) -> None:
    text = manifest().replace("<build_type>ament_python</build_type>", "")
    (finding,) = lint_files({"package.xml": text, **files}, ["XML301"]).findings
    assert (guess is None) is (finding.fix is None)
    assert guess is None or f"`<build_type>{guess}</build_type>`" in finding.message
    assert happens in finding.message
    assert finding.severity.value == level


@pytest.mark.parametrize(("option", "level"), [("--merge-install", "warning"), ("--symlink-install", "error")])
def test_a_build_type_is_missed_less_where_all_is_installed_into_one_folder(option: str, level: str) -> None:
    text = manifest().replace("<build_type>ament_python</build_type>", "")
    lines = "add_executable(a a.cpp)\ninstall(TARGETS a DESTINATION lib/${PROJECT_NAME})\nament_package"
    files = {"package.xml": text, "CMakeLists.txt": CMAKE.replace("ament_package", lines), "a.cpp": ""}
    files["README.md"] = f"colcon build {option}\n"
    (finding,) = lint_files(files, ["XML301"]).findings
    assert finding.severity.value == level
    assert ("but for `--merge-install` (`README.md`); add" in finding.message) is (level == "warning")


def test_packages_of_ros_1_are_left_alone() -> None:
    text = manifest("  <buildtool_depend>catkin</buildtool_depend>\n").replace(
        "<build_type>ament_python</build_type>", ""
    )
    assert (
        lint_files({"package.xml": text, "CMakeLists.txt": "find_package(catkin REQUIRED)\n"}, ["XML301"]).findings
        == ()
    )


def test_build_types_for_two_worlds() -> None:
    types = (
        '<build_type condition="$ROS_VERSION == 1">catkin</build_type>\n'
        '    <build_type condition="$ROS_VERSION == 2">ament_cmake</build_type>'
    )
    body = (
        '  <buildtool_depend condition="$ROS_VERSION == 2">ament_cmake</buildtool_depend>\n'
        '  <buildtool_depend condition="$ROS_VERSION == 1">catkin</buildtool_depend>\n'
    )
    text = manifest(body).replace("<build_type>ament_python</build_type>", types)
    assert cmake(text=text, files={"setup.py": "from setuptools import setup\nsetup()\n"}) == []
    assert "XML303" in cmake(text=text.replace('type condition="$ROS_VERSION == 1"', "type"))


@pytest.mark.parametrize("option", ["SKIP_INSTALL", "SKIP_GROUP_MEMBERSHIP_CHECK"])
def test_interfaces_that_are_kept_at_home_need_no_group(option: str) -> None:
    def says(files: dict[str, str]) -> list[str]:
        results = lint_files({"package.xml": manifest(build_type="ament_cmake"), **files}, ["XML305"])
        return [f.message for f in results.findings]

    assert any("the group is missing" in each for each in says(INTERFACES))
    kept = INTERFACES["CMakeLists.txt"].replace('"msg/A.msg"', f'"msg/A.msg" {option}')
    assert not any("the group is missing" in each for each in says({**INTERFACES, "CMakeLists.txt": kept}))


def test_interfaces_of_tests_need_no_runtime() -> None:
    tests = (
        INTERFACES["CMakeLists.txt"]
        .replace("rosidl_gen", "if(BUILD_TESTING)\nrosidl_gen")
        .replace('.msg")', '.msg")\nendif()')
    )
    results = lint_files(
        {"package.xml": manifest(build_type="ament_cmake"), **INTERFACES, "CMakeLists.txt": tests}, ["XML305"]
    )
    assert ["group" in f.message for f in results.findings] == [True]


def test_interfaces_of_a_package_below_are_its_own() -> None:
    below = {f"msgs/{path}": text for path, text in INTERFACES.items()}
    added = CMAKE.replace("ament_package", "add_subdirectory(msgs)\nament_package")
    files = {"package.xml": manifest(build_type="ament_cmake"), "CMakeLists.txt": added, **below}
    inner = manifest(
        "  <buildtool_depend>rosidl_default_generators</buildtool_depend>\n"
        "  <exec_depend>rosidl_default_runtime</exec_depend>\n"
        "  <member_of_group>rosidl_interface_packages</member_of_group>\n",
        "ament_cmake",
        "msgs",
    )
    assert lint_files({**files, "msgs/package.xml": inner}, ["IDL006", "XML305"]).findings == ()
    assert len(lint_files(files, ["XML305"]).findings) == 3


def test_a_group_in_format_2_brings_format_3_with_it() -> None:
    text = manifest(build_type="ament_cmake").replace('format="3"', 'format="2"').replace("format3", "format2")
    findings = lint_files({"package.xml": text, **INTERFACES}, ["XML305"]).findings
    (fix,) = [f.fix for f in findings if "the group is missing" in f.message]
    assert fix is not None
    assert {getattr(operation, "text", "") for operation in fix.operations} >= {"3"}


def test_a_license_text_may_lie_above_the_package() -> None:
    files = {"src/my_pkg/package.xml": manifest(build_type="ament_cmake"), "src/my_pkg/CMakeLists.txt": CMAKE}
    assert lint_files({**files, "LICENSES/Apache-2.0.txt": "Apache\n"}, ["XML111"]).findings == ()
    assert lint_files({**files, "src/COPYING": "Apache\n"}, ["XML111"]).findings == ()
    assert len(lint_files({**files, "other/LICENSE": "Apache\n"}, ["XML111"]).findings) == 1


def test_something_else_called_package_xml_is_one_finding() -> None:
    results = lint_files({"package.xml": "<launch><node/></launch>\n", "CMakeLists.txt": CMAKE})
    assert [f.code for f in results.findings if f.location.path == "package.xml"] == ["RPK001"]


def test_export_for_ros_1_may_name_what_is_not_there() -> None:
    text = manifest(build_type="ament_cmake")
    line = '<rqt_gui condition="$ROS_VERSION == 1" plugin="${prefix}/plugin.xml"/>'
    assert cmake(text=text.replace("  </export>", f"    {line}\n  </export>")) == []


def test_thousands_of_misplaced_elements_are_placed_by_halving(clean) -> None:
    """Each finding offers the one fix of all, so only the first hundred do."""
    pairs = "  <url>https://example.org</url>\n  <author>Ada</author>\n  <depend>std_msgs</depend>\n" * 2_000
    text = clean["package.xml"].replace("  <license>Apache-2.0</license>\n", f"  <license>MIT</license>\n{pairs}")
    findings = lint_files({**clean, "package.xml": text}, ["XML002"]).findings
    assert len(findings) > 2_000
    assert sum(finding.fix is not None for finding in findings) == 100


def test_a_depend_that_nothing_uses_is_to_be_removed_and_not_changed(clean) -> None:
    lines = "  <depend>nav_msgs</depend>\n  <depend>std_msgs</depend>\n"
    text = clean["package.xml"].replace("  <export>", f"{lines}  <export>")
    files = {**clean, "package.xml": text, "my_pkg/node.py": "import std_msgs.msg\n"}
    found = lint_files(files, ["XML209", "DEP202"]).findings
    assert [(finding.code, finding.message.split("`")[1]) for finding in found] == [
        ("DEP202", "nav_msgs"),
        ("XML209", "std_msgs"),
    ]
