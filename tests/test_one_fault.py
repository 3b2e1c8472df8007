"""One fault, one finding: the specific rule speaks, and what follows from it keeps quiet."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest, scripts, setup_py
from rospkg_cli.rules.launch import lch011_unknown_component as lch011
from rospkg_cli.testing import lint_files

ENTRY = "    entry_points={'console_scripts': ['talker = my_pkg.talker:main']},\n    license="


def with_launch(clean: dict[str, str]) -> dict[str, str]:
    return {
        **clean,
        "setup.py": clean["setup.py"].replace("    license=", ENTRY),
        "my_pkg/talker.py": "def main():\n    pass\n",
        "launch/a.launch.xml": '<launch>\n  <node pkg="my_pkg" exec="talker"/>\n</launch>\n',
    }


def codes(files: dict[str, str]) -> list[str]:
    return [f.code for f in lint_files(files).findings if f.code.startswith(("SET0", "SET1", "LCH002"))]


def test_an_executable_in_bin_is_no_unknown_one(clean) -> None:
    files = with_launch(clean)
    assert codes(files) == []
    assert codes({path: text for path, text in files.items() if path != "setup.cfg"}) == ["SET001"]
    moved = files["setup.cfg"].replace("install_scripts=$base/lib/my_pkg", "install_scripts=$base/lib/other")
    assert codes({**files, "setup.cfg": moved}) == ["SET002"]


def test_a_name_with_signs_in_it_is_the_same_name(clean) -> None:
    manifest = clean["package.xml"].replace(">Ada<", ">Ada &lt;L&gt; &amp; Co<")
    setup = clean["setup.py"].replace("maintainer='Ada'", "maintainer='Ada <L> & Co'")
    files = {**clean, "package.xml": manifest, "setup.py": setup}
    assert [f.message for f in lint_files(files, ["SET403"]).findings] == []
    other = {**files, "setup.py": setup.replace("& Co", "& Sons")}
    assert [f.code for f in lint_files(other, ["SET403"]).findings] == ["SET403"]


def test_ament_lint_common_stands_for_the_linters_of_cmake() -> None:
    test = "if(BUILD_TESTING)\n  find_package(ament_cmake_flake8 REQUIRED)\nendif()\nament_package()"
    files = {"CMakeLists.txt": CMAKE.replace("ament_package()", test)}

    def missing(depends: str) -> list[str]:
        tree = {**files, "package.xml": manifest(depends, "ament_cmake")}
        return [f.code for f in lint_files(tree, ["DEP104"]).findings]

    assert missing("") == ["DEP104"]
    assert missing("  <test_depend>ament_lint_common</test_depend>\n") == []


def test_an_executable_that_another_package_launches_must_stand_in_lib(clean) -> None:
    def level(launch: str) -> list[str]:
        setup = clean["setup.py"].replace("    license=", ENTRY.replace("talker", "convert"))
        own = {**clean, "setup.py": setup, "my_pkg/convert.py": "def main():\n    pass\n"}
        tree = {f"a/{path}": text for path, text in own.items() if path != "setup.cfg"}
        tree |= {"b/package.xml": manifest(name="bringup"), "b/launch/b.launch.xml": f"<launch>{launch}</launch>"}
        return [f.severity.value for f in lint_files(tree, ["SET001"]).findings]

    assert level("") == ["info"]
    assert level('<node pkg="my_pkg" exec="convert"/>') == ["error"]


def test_what_ends_at_rospy_says_so_first(clean) -> None:
    setup = setup_py(scripts("talker = my_pkg.talker:main"))
    files = {**clean, "setup.py": setup, "my_pkg/talker.py": "import rclpy\n"}

    def said(text: str) -> tuple[str, str]:
        (finding,) = lint_files({**files, "my_pkg/talker.py": text}, ["SET102"]).findings
        return finding.severity.value, finding.message

    assert said("import rospy\n") == (
        "error",
        "`my_pkg/talker.py` imports `rospy` of ROS 1 and has no top-level `main`: `ros2 run my_pkg talker` raises "
        "ModuleNotFoundError; port it, or take this line out",
    )
    assert "raises AttributeError" in said("import rclpy\n")[1]
    assert "raises AttributeError" in said("try:\n    import rospy\nexcept ImportError:\n    rospy = None\n")[1]


def test_all_that_is_left_of_ros1_is_one_finding(clean) -> None:
    one = {**clean, "my_pkg/a.py": "import rospy\n"}
    (finding,) = lint_files(one, ["DEP101"]).findings
    assert finding.message.startswith("`rospy` is a module of ROS 1: this file ends with")
    assert not finding.related
    assert finding.message.endswith("; port it to rclpy, or do not install it")
    (finding,) = lint_files({**one, "my_pkg/b.py": "import roslib\n"}, ["DEP101"]).findings
    assert finding.message.startswith("`rospy` is a module of ROS 1: this file and 1 more end with")
    assert finding.message.endswith("; port them to rclpy, or do not install them")
    assert [(place.path, why) for place, why in finding.related] == [("my_pkg/b.py", "and here")]


def test_another_maintainer_has_another_address(clean) -> None:
    def codes_of(name: str, address: str) -> list[str]:
        text = clean["setup.py"].replace("maintainer='Ada'", f"maintainer='{name}'")
        files = {**clean, "setup.py": text.replace("='ada@example.org'", f"='{address}'")}
        return [f.message.partition(" ")[0] for f in lint_files(files, ["SET403"]).findings]

    assert codes_of("Ada", "ada@example.org") == []
    assert codes_of("Ada, Grace", "grace@example.org, ada@example.org") == []
    assert codes_of("Grace", "grace@example.org") == ["`maintainer`"]
    assert codes_of("Ada", "grace@example.org") == ["`maintainer_email`"]


def test_headers_of_a_package_that_only_tests_are_built_of_are_tests() -> None:
    lines = "find_package(std_msgs REQUIRED)\nadd_executable(t test/t.cpp)\n"
    files = {
        "package.xml": manifest("  <test_depend>std_msgs</test_depend>\n", "ament_cmake"),
        "include/my_pkg/t.hpp": "#include <std_msgs/msg/string.hpp>\n",
        "test/t.cpp": "#include <my_pkg/t.hpp>\n",
    }

    def said(text: str) -> list[str]:
        tree = {**files, "CMakeLists.txt": CMAKE.replace("ament_package", f"{text}ament_package")}
        return [f.code for f in lint_files(tree, ["DEP201", "DEP105"]).findings]

    assert said(lines) == ["DEP201"]
    assert said(f"if(BUILD_TESTING)\n{lines}endif()\n") == []
    assert said(f"if(BUILD_TESTING)\n{lines}target_sources(t PRIVATE ${{UNKNOWN}})\nendif()\n") == []


def test_an_executable_that_is_installed_and_not_made_is_told_once() -> None:
    lines = (
        "find_package(rclcpp REQUIRED)\ntarget_link_libraries(talker rclcpp::rclcpp)\n"
        "install(TARGETS talker DESTINATION lib/${PROJECT_NAME})\n"
        "install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})\n"
    )
    files = {
        "CMakeLists.txt": CMAKE.replace("ament_package", lines + "ament_package"),
        "package.xml": manifest("  <depend>rclcpp</depend>\n", "ament_cmake"),
        "src/node.cpp": "#include <rclcpp/rclcpp.hpp>\nint main(int c, char ** v) {rclcpp::init(c, v);}\n",
        "launch/a.launch.xml": '<launch>\n  <node pkg="my_pkg" exec="talker"/>\n</launch>\n',
    }
    found = lint_files(files, ["CMK110", "CMK202", "LCH002"]).findings
    assert [(f.code, len(f.related)) for f in found] == [("CMK110", 1)]
    made = files["CMakeLists.txt"].replace("target_link", "add_executable(talker src/other.cpp)\ntarget_link")
    files["src/other.cpp"] = "int main() {return 0;}\n"
    assert [f.code for f in lint_files({**files, "CMakeLists.txt": made}, ["CMK202"]).findings] == ["CMK202"]
    into_bin = {**files, "CMakeLists.txt": files["CMakeLists.txt"].replace("lib/${PROJECT_NAME}", "bin")}
    assert "LCH002" in [f.code for f in lint_files(into_bin, ["LCH002"]).findings]


def test_an_executable_that_is_missing_in_several_nodes_is_one_finding(clean) -> None:
    """The node that certainly stops the launch is the finding; a fix renames all."""
    off = '  <arg name="b" default="false"/>\n  <node pkg="my_pkg" exec="taker" if="$(var b)"/>\n'
    nodes = off + '  <node pkg="my_pkg" exec="taker"/>\n  <node pkg="my_pkg" exec="talker"/>\n'
    files = {**with_launch(clean), "launch/a.launch.xml": f"<launch>\n{nodes}</launch>\n"}
    (finding,) = lint_files(files, ["LCH002"]).findings
    assert (finding.severity.value, finding.location.line) == ("error", 4)
    assert [(where.line, text) for where, text in finding.related] == [(3, "and here")]
    assert finding.fix is not None
    assert len(finding.fix.operations) == 2


def test_what_lies_beside_programs_is_not_offered(clean) -> None:
    setup = clean["setup.py"].replace("    data_files=[", "    data_files=[('lib/my_pkg', ['notes.txt']),")
    launch = '<launch>\n  <node pkg="my_pkg" exec="camera"/>\n</launch>\n'
    files = {**with_launch(clean), "notes.txt": "a", "launch/a.launch.xml": launch}
    files["setup.py"] = setup.replace("    license=", ENTRY)
    (finding,) = lint_files(files, ["LCH002"]).findings
    assert "; it installs `talker`; " in finding.message


def test_a_component_that_is_missing_in_several_nodes_is_one_finding() -> None:
    node = '    <composable_node pkg="my_pkg" plugin="my_pkg::Taker" name="{}"/>\n'
    container = '  <node_container pkg="rclcpp_components" exec="component_container" name="c" namespace=""{}>\n'
    off = container.format(' if="$(var b)"') + node.format("z") + "  </node_container>\n"
    on = container.format("") + node.format("a") + node.format("b") + "  </node_container>\n"
    text = f'<launch>\n  <arg name="b" default="false"/>\n{off}{on}</launch>\n'
    (finding,) = lint_files({**lch011.FILES, "launch/a.launch.xml": text}, ["LCH011"]).findings
    assert (finding.severity.value, finding.location.line) == ("error", 7)
    assert [(where.line, text) for where, text in finding.related] == [(8, "and here"), (4, "and here")]
    assert finding.fix is not None
    assert len(finding.fix.operations) == 3


@pytest.mark.parametrize(("name", "hint"), [("Taker", "did you mean `my_pkg::Talker`?"), ("Map", "it registers")])
def test_a_namespace_makes_no_class_alike(name: str, hint: str) -> None:
    text = str(lch011.FILES["launch/a.launch.xml"]).replace("«my_pkg::Taker»", f"my_pkg::{name}")
    (finding,) = lint_files({**lch011.FILES, "launch/a.launch.xml": text}, ["LCH011"]).findings
    assert hint in finding.message
