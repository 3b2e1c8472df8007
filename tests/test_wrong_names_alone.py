"""A dependency under a wrong name is one finding: what it stands for counts as declared, and is there."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, INTERFACES_CMAKE, existing_files, manifest
from rospkg_cli.finding import Finding
from rospkg_cli.testing import lint_files

ASKED = ["DEP001", "DEP104", "DEP105", "DEP203", "XML001", "XML208"]


def found(depends: str, codes: list[str], cmake: str) -> tuple[Finding, ...]:
    text = CMAKE.replace("ament_package", cmake + "ament_package")
    return lint_files({"CMakeLists.txt": text, "package.xml": manifest(depends, "ament_cmake")}, codes).findings


def told(depends: str, *needed: str) -> list[tuple[str, str]]:
    """Return the codes of what is said of a package that needs some others, each with what brings them."""
    lines = "".join(f"find_package({name} REQUIRED)\n" for name in needed)
    return [(each.code, each.message.rpartition(" with ")[2]) for each in found(depends, ASKED, lines)]


@pytest.mark.parametrize(
    "line, code, needed",
    [
        ("<depend>std-msgs</depend>", "DEP001", ["std_msgs"]),
        ("<depend>std_msgs, nav_msgs</depend>", "DEP001", ["std_msgs", "nav_msgs"]),
        ("<depend>roscpp</depend>", "DEP203", ["rclcpp"]),
        ("<dpeend>tf2_ros</dpeend>", "XML001", ["tf2_ros"]),
        ("<depend>Eigen3</depend>", "DEP001", ["Eigen3"]),
        ("<depend>OpenCV</depend>", "DEP001", ["OpenCV"]),
    ],
)
def test_what_is_meant_is_declared(line: str, code: str, needed: list[str]) -> None:
    assert [each for each, _ in told(f"  {line}\n", *needed)] == [code]
    assert [each for each, _ in told(f"  {line}\n", *needed, "rosbag2_cpp")] in ([code, "DEP104"], ["DEP104", code])


@pytest.mark.parametrize(
    "line", ["<depend>nav-msgs</depend>", "<depend>nav_msgs, tf2</depend>", "<dpeend>nav_msgs</dpeend>"]
)
def test_what_is_meant_brings_its_own(line: str) -> None:
    (bringer,) = [bringer for code, bringer in told(f"  {line}\n", "geometry_msgs") if code == "DEP104"]
    assert bringer.startswith("`nav_msgs` today")


def test_what_nobody_knows_may_bring_anything() -> None:
    assert ("DEP104", "`acme_thing`; declare what you use") in told("  <depend>acme_thing</depend>\n", "std_msgs")


def test_a_package_of_ros1_in_the_workspace_is_itself() -> None:
    text = CMAKE.replace("ament_package", "find_package(rclcpp REQUIRED)\nament_package")
    here = {"a/package.xml": manifest("  <depend>roscpp</depend>\n", "ament_cmake"), "a/CMakeLists.txt": text}
    ported = {"b/package.xml": manifest(build_type="ament_cmake", name="roscpp"), "b/CMakeLists.txt": CMAKE}
    assert [each.code for each in lint_files({**here, **ported}, ["DEP104", "DEP203"]).findings] == ["DEP104"]


def test_a_misspelt_build_tool_is_no_missing_one() -> None:
    wrong = manifest(build_type="ament_cmake").replace("depend>ament_cmake<", "depend>ament-cmake<")
    files = {"CMakeLists.txt": CMAKE, "package.xml": wrong}
    assert [each.code for each in lint_files(files, ["DEP001", "XML208"]).findings] == ["DEP001"]


def test_a_misspelt_runtime_is_no_missing_one() -> None:
    lines = (
        "  <buildtool_depend>rosidl_default_generators</buildtool_depend>\n"
        "  <exec_depend>rosidl-default-runtime</exec_depend>\n"
        "  <member_of_group>rosidl_interface_packages</member_of_group>\n"
    )
    files = {"CMakeLists.txt": INTERFACES_CMAKE, "msg/Status.msg": "bool ok\n"}
    tree = {**files, "package.xml": manifest(lines, "ament_cmake")}
    assert [each.code for each in lint_files(tree, ["DEP001", "XML305"]).findings] == ["DEP001"]


def test_a_misspelt_name_of_the_package_is_no_missing_dependency() -> None:
    """Its folder, and the project, have the right one."""
    text = INTERFACES_CMAKE.replace("project(my_pkg)", "project(robot_msgs)")
    lines = "  <member_of_group>rosidl_interface_packages</member_of_group>\n"

    def codes(name: str, folder: str) -> list[str]:
        files = {"CMakeLists.txt": text, "msg/Status.msg": "robot_msgs/Other other\n", "msg/Other.msg": "bool ok\n"}
        files["package.xml"] = manifest(lines, "ament_cmake", name=name)
        tree = {f"src/{folder}/{path}": text for path, text in files.items()}
        return [each.code for each in lint_files(tree, ["CMK001", "DEP108", "IDL007"]).findings]

    assert codes("robot_mgs", "robot_msgs") == ["CMK001"]
    assert codes("robot_mgs", "messages") == ["CMK001", "DEP108"]
    assert codes("arm_messages", "robot_msgs") == ["CMK001", "DEP108"]


def test_a_group_is_no_package_that_may_bring_others() -> None:
    launch = '<launch><node pkg="joy" exec="joy_node"/></launch>\n'
    files = {**existing_files(BACKDROPS["ament_python"]), "launch/a.launch.xml": launch}
    files["package.xml"] = manifest("  <group_depend>parts</group_depend>\n")
    assert [finding.severity.value for finding in lint_files(files, ["DEP103"]).findings] == ["warning"]


@pytest.mark.parametrize(
    ("name", "advice"),
    [
        ("tkinter", "write `python3-tk`"),
        ("python3-tkinter", "write `python3-tk`"),
        ("python3-json", "remove the line"),
    ],
)
def test_what_debian_leaves_out_of_python_is_a_key(name: str, advice: str) -> None:
    files = {**existing_files(BACKDROPS["ament_python"]), "package.xml": manifest(f"  <depend>{name}</depend>\n")}
    (finding,) = lint_files(files, ["DEP001"]).findings
    assert finding.message.endswith(advice)


def test_a_short_name_behind_lib_is_no_slip() -> None:
    files = {**existing_files(BACKDROPS["ament_python"]), "package.xml": manifest("  <depend>libpcl</depend>\n")}
    assert not lint_files(files, ["DEP001"]).findings
