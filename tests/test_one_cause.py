"""One cause, one finding: a name that is a slip is told once, and what follows from it keeps quiet."""

from __future__ import annotations

import pytest

from rospkg_cli.engine.selection import EVERYTHING
from rospkg_cli.example import CMAKE, INTERFACES_CMAKE, manifest, scripts, setup_py
from rospkg_cli.finding import Edit
from rospkg_cli.rules.plugins import plg003_unknown_plugin as plg003
from rospkg_cli.rules.plugins import plg005_wrong_plugin_base as plg005
from rospkg_cli.testing import lint_files

TALKER = "int main() {return 0;}\n"
LAUNCH = '<launch>\n  <node pkg="my_pkg" exec="{}"/>\n</launch>\n'
ALL = "share/${PROJECT_NAME}"


def told(files: dict[str, str], *families: str) -> list[tuple[str, int]]:
    """Return the codes of some families, each with the number of places besides its own."""
    chosen = [code for code in EVERYTHING.codes() if code.startswith(families)]
    return sorted((each.code, len(each.related)) for each in lint_files(files, chosen).findings)


def codes(files: dict[str, str], *families: str) -> list[str]:
    return [code for code, _ in told(files, *families)]


def cmake(lines: str, depends: str = "") -> dict[str, str]:
    text = CMAKE.replace("ament_package", lines + "ament_package")
    return {"CMakeLists.txt": text, "package.xml": manifest(depends, "ament_cmake")}


def test_a_misspelt_folder_to_install() -> None:
    for folder, expected in (("launhc", ["CMK102"]), ("other", ["CMK101", "CMK102"])):
        files = cmake(f"install(DIRECTORY {folder} DESTINATION {ALL})\n")
        assert codes({**files, "launch/a.launch.xml": "<launch/>\n"}, "CMK1") == expected
    (finding,) = lint_files(
        {**cmake(f"install(DIRECTORY launhc DESTINATION {ALL})\n"), "launch/a": ""}, ["CMK102"]
    ).findings
    assert "`launhc` does not exist (did you mean `launch`?)" in finding.message


def test_a_misspelt_script_to_install() -> None:
    def found(script: str) -> list[str]:
        rules = f"install(PROGRAMS scripts/{script} DESTINATION lib/${{PROJECT_NAME}})\n"
        files = cmake(f"{rules}install(DIRECTORY launch DESTINATION {ALL})\n")
        more = {"scripts/talk.py": "#!/usr/bin/env python3\n", "launch/a.launch.xml": LAUNCH.format("talk.py")}
        return codes({**files, **more}, "CMK102", "LCH002")

    assert found("takl.py") == ["CMK102"]
    assert found("listen_to_all.py") == ["CMK102", "LCH002"]


@pytest.mark.parametrize(
    "place, expected", [("lib", [("CMK104", 1)]), ("bin", [("CMK104", 1)]), (f"lib/{ALL[6:]}", [])]
)
def test_executables_of_one_rule_in_the_wrong_folder(place: str, expected: list[tuple[str, int]]) -> None:
    lines = "add_executable(a src/a.cpp)\nadd_executable(b src/a.cpp)\n"
    rules = f"install(TARGETS a b DESTINATION {place})\ninstall(DIRECTORY launch DESTINATION {ALL})\n"
    files = {
        "src/a.cpp": TALKER,
        "launch/a.launch.xml": LAUNCH.format("a").replace("</", '<node pkg="my_pkg" exec="b"/>\n</'),
    }
    assert told({**cmake(lines + rules), **files}, "CMK104", "LCH002") == expected


@pytest.mark.parametrize(
    "word, expected",
    [
        ("DESTINATION", []),
        ("DESTINTION", ["CMK120", "CMK120"]),
        ("DESTIN", ["CMK102", "CMK104", "CMK110", "CMK110"]),
    ],
)
def test_a_misspelt_keyword_of_install_is_read_as_it_is_meant(word: str, expected: list[str]) -> None:
    lines = "add_executable(a src/a.cpp)\ninstall(TARGETS a KEY lib/${PROJECT_NAME})\n"
    lines += "install(DIRECTORY launch KEY share/x)\n"
    files = {"src/a.cpp": TALKER, "launch/a.launch.xml": LAUNCH.format("a")}
    asked = ("CMK102", "CMK104", "CMK110", "CMK120", "LCH002")
    assert codes({**cmake(lines.replace("KEY", word)), **files}, *asked) == expected


@pytest.mark.parametrize(
    "line, files, expected",
    [
        ("install(FILES README DESTINATION share/${PROJECT_NAME})", {"README": "x\n"}, []),
        ("install(FILES LIBRAY DESTINATION share/${PROJECT_NAME})", {"LIBRAY": "x\n"}, []),
        ('install(FILES "LIBRAY" DESTINATION share/${PROJECT_NAME})', {}, ["CMK102"]),
        ("install(FILES libray DESTINATION share/${PROJECT_NAME})", {}, ["CMK102"]),
        ("install(FILES TYP DESTINATION share/${PROJECT_NAME})", {}, ["CMK102"]),
        ("install(FILES README DESTINATION RUNTME COMPONENT OPTONAL)", {"README": ""}, []),
        ("install(EXPORT EXPORTS DESTINATION share/${PROJECT_NAME} FILE DESTINATIO.cmake)", {}, []),
        ("add_library(a a.cpp)\ninstall(TARGETS a DESTINATION lib INCLUDES DESTINATION INCLUDE)", {"a.cpp": ""}, []),
        ("install(FILES a OPTONAL DESTINATION share/${PROJECT_NAME})", {}, ["CMK120"]),
        ("install(FILES README DESTINATION share/${PROJECT_NAME} PERMISIONS)", {"README": "x\n"}, ["CMK120"]),
        ("install(FILES README DESTINATION share/${PROJECT_NAME} DIRECTORY_PERMISIONNS)", {"README": ""}, ["CMK120"]),
        ("install(FILES README DESTINATION share/${PROJECT_NAME} EXPRTS)", {"README": "x\n"}, []),
    ],
)
def test_what_is_no_keyword_of_install(line: str, files: dict[str, str], expected: list[str]) -> None:
    assert codes({**cmake(f"{line}\n"), **files}, "CMK102", "CMK120") == expected


def test_a_misspelt_plugin_description_or_library() -> None:
    def found(old: str, new: str) -> list[str]:
        return codes({**plg005.FILES, "CMakeLists.txt": plg005.PACKAGE.replace(old, new)}, "CMK1", "PLG")

    assert found("nav2_core plugins.xml", "nav2_core plugin.xml") == ["CMK102"]
    assert found("TARGETS my_planner", "TARGETS my_plannr") == ["CMK110"]
    assert found("install(TARGETS my_planner DESTINATION lib)\n", "") == ["PLG004"]


def test_a_misspelt_python_package() -> None:
    lines = "find_package(ament_cmake_python REQUIRED)\n"
    files = {"my_pkg/__init__.py": "", "my_pkg/a.py": ""}
    wrong = cmake(f"{lines}ament_python_install_package(my_modules)\n", "  <depend>ament_cmake_python</depend>\n")
    assert codes({**wrong, **files}, "CMK1") == ["CMK102"]
    assert codes({**cmake(lines, "  <depend>ament_cmake_python</depend>\n"), **files}, "CMK1") == ["CMK109"]


def test_a_misspelt_package_to_find() -> None:
    lines = "add_executable(a src/a.cpp)\ntarget_link_libraries(a std_msgs::std_msgs)\n"
    source = {"src/a.cpp": "#include <std_msgs/msg/string.hpp>\nint main() {return 0;}\n"}
    for line, expected in (("find_package(std_mgs REQUIRED)\n", ["CMK117"]), ("", ["DEP107"])):
        files = {**cmake(line + lines, "  <depend>std_msgs</depend>\n"), **source}
        assert codes(files, "CMK117", "DEP107") == expected


def test_a_renamed_interface() -> None:
    depends = "  <member_of_group>rosidl_interface_packages</member_of_group>\n"
    source = "#include <my_pkg/msg/status.hpp>\nmy_pkg::msg::Status status;\nint main() {return 0;}\n"
    lines = "add_executable(a src/a.cpp)\nadd_executable(b src/b.cpp)\nament_package"
    text = INTERFACES_CMAKE.replace('"srv/SetMode.srv"', "").replace("ament_package", lines)
    files = {"package.xml": manifest(depends, "ament_cmake"), "src/a.cpp": source, "src/b.cpp": source}
    files["CMakeLists.txt"] = text
    assert told({**files, "msg/Status2.msg": "bool ok\n"}, "IDL") == [("IDL006", 0)]
    assert told({**files, "msg/Other.msg": "bool ok\n"}, "IDL") == [("IDL005", 0), ("IDL006", 0)]
    other = text.replace("msg/Status", "msg/Status2")
    assert told({**files, "msg/Status2.msg": "bool ok\n", "CMakeLists.txt": other}, "IDL") == [("IDL012", 1)]


def test_a_misspelt_package_of_interfaces() -> None:
    depends = "  <depend>std_msgs</depend>\n  <member_of_group>rosidl_interface_packages</member_of_group>\n"
    text = INTERFACES_CMAKE.replace('"srv/SetMode.srv"', "DEPENDENCIES std_msgs")
    for package, expected in (("std_mgs", ["DEP108"]), ("acme_arm", ["DEP108", "IDL007"]), ("std_msgs", [])):
        files = {"CMakeLists.txt": text, "msg/Status.msg": f"{package}/Header header\n{package}/String text\n"}
        assert codes({**files, "package.xml": manifest(depends, "ament_cmake")}, "DEP108", "IDL007") == expected


def test_a_renamed_header_is_told_at_its_first_include() -> None:
    lines = "add_executable(a src/a.cpp src/b.cpp)\ntarget_include_directories(a PRIVATE include)\n"
    source = '#include "my_pkg/words.hpp"\nint main() {return 0;}\n'
    files = {"src/a.cpp": source, "src/b.cpp": source, "include/my_pkg/words_2.hpp": "", "include/my_pkg/c.hpp": source}
    (finding,) = lint_files({**cmake(lines), **files}, ["CMK201"]).findings
    assert (finding.severity.value, finding.location.path, len(finding.related)) == ("error", "src/a.cpp", 2)


def test_a_misspelt_tag_has_no_place_in_the_order() -> None:
    lines = "  <exec_dpeend>rclpy</exec_dpeend>\n  <member_of_group>rosidl_interface_packages</member_of_group>\n"
    files = {"CMakeLists.txt": CMAKE, "package.xml": manifest(lines, "ament_cmake")}
    assert codes(files, "XML00") == ["XML001"]
    swapped = files["package.xml"].replace("  <exec_dpeend>", "  <license>MIT</license>\n  <exec_dpeend>")
    assert codes({**files, "package.xml": swapped}, "XML001", "XML002") == ["XML001", "XML002"]


def test_tags_of_newer_formats() -> None:
    lines = '  <exec_depend condition="$A == 1">rclpy</exec_depend>\n  <depend condition="$A == 1">rclcpp</depend>\n'
    of_3 = manifest(lines, "ament_cmake")
    for number, expected in (("3", []), ("2", [("XML004", 1)]), ("1", [("XML001", 1)])):
        files = {"CMakeLists.txt": CMAKE, "package.xml": of_3.replace('format="3"', f'format="{number}"')}
        assert told(files, "XML001", "XML004") == expected


@pytest.mark.parametrize("name, project, expected", [("my-pkg", "my_pkg", "CMK001"), ("my-pkg", "my-pkg", "XML101")])
def test_an_invalid_name_that_the_project_has_right(name: str, project: str, expected: str) -> None:
    text = CMAKE.replace("project(my_pkg)", f"project({project})")
    files = {"CMakeLists.txt": text, "package.xml": manifest(build_type="ament_cmake", name=name)}
    (finding,) = lint_files(files, ["CMK001", "XML101"]).findings
    assert finding.code == expected
    assert "call " in finding.message
    assert "my_pkg`" in finding.message


def test_a_renamed_module_of_an_entry_point(clean) -> None:
    node = (
        "import rclpy\nimport rclpy.node\n\n\nclass A(rclpy.node.Node):\n    pass\n\n\ndef main():\n    rclpy.init()\n"
    )
    node += "    rclpy.spin(A('a'))\n\n\nif __name__ == '__main__':\n    main()\n"
    files = {**clean, "setup.py": setup_py(scripts("talker = my_pkg.talker:main"))}
    assert codes({**files, "my_pkg/talker2.py": node}, "SET10") == ["SET101"]
    assert codes({**files, "my_pkg/talker.py": node, "my_pkg/listener.py": node}, "SET10") == ["SET106"]


def test_a_misspelt_name_in_a_launch_file(clean) -> None:
    text = (
        "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n\n\n"
        "def generate_launch_description():\n    node = Node(package='joy', executable='joy_node')\n"
        "    return LaunchDescription([node])\n"
    )

    def found(old: str, new: str) -> list[str]:
        return codes({**clean, "launch/a.launch.py": text.replace(old, new)}, "LCH013", "LCH018")

    assert found("", "") == []
    assert found("import Node", "import Nodde") == ["LCH013"]
    assert found("[node]", "[noed]") == ["LCH013"]
    assert found("[node]", "[something]") == ["LCH013", "LCH018"]


def test_fields_of_another_message(clean) -> None:
    text = "from std_msgs.msg import String\n\nmsg = String()\nmsg.{} = 1\nmsg.{} = 2\nmsg.{} = 3\n"
    interface = {
        "a/package.xml": manifest("  <exec_depend>b</exec_depend>\n").replace("my_pkg", "a"),
        "b/package.xml": manifest("", "ament_cmake").replace("my_pkg", "b"),
        "b/CMakeLists.txt": INTERFACES_CMAKE.replace("my_pkg", "b"),
        "b/msg/Status.msg": "float32 r\nfloat32 battery\n",
    }
    own = {f"a/{path}".replace("my_pkg", "a"): text.replace("my_pkg", "a") for path, text in clean.items()}
    files = {**own, **interface}

    def found(*names: str) -> list[tuple[str, int]]:
        code = text.replace("std_msgs.msg", "b.msg").replace("String", "Status").format(*names)
        said = lint_files({**files, "a/a/talker.py": code}, ["IDL010"]).findings
        return [(each.message.partition(":")[0], len(each.related)) for each in said]

    none = "`b/msg/Status` has no field"
    assert found("r", "battery", "r") == []
    assert found("rx", "ry", "rx") == [(f"{none}s `rx` and `ry`", 2)]
    assert found("rx", "batery", "ry") == [(f"{none}s `rx` and `ry`", 1), (f"{none} `batery`", 1)]


def test_blocks_without_their_key() -> None:
    def found(text: str) -> list[tuple[str, int]]:
        launch = "<launch><node pkg='a' exec='b'><param from='$(find-pkg-share my_pkg)/a.yaml'/></node></launch>\n"
        files = {**cmake(f"install(FILES a.yaml DESTINATION {ALL})\n"), "launch/a.launch.xml": launch, "a.yaml": text}
        said = lint_files(files, ["PRM001"]).findings
        return [(each.message.partition(" no ")[0], len(each.related)) for each in said]

    assert found("a:\n  b:\n    x: 1\nc:\n  y: 1\n") == [("the blocks of `a` and `c` have", 1)]
    assert found("c:\n  y: 1\n") == [("the block of `c` has", 0)]


def test_arguments_of_an_older_launch_ros(clean) -> None:
    text = (
        "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n\n\n"
        "def generate_launch_description():\n    return LaunchDescription([{}])\n"
    )

    def found(*nodes: str) -> list[tuple[str, str, int]]:
        files = {**clean, "launch/a.launch.py": text.format(", ".join(f"Node(package='joy', {n})" for n in nodes))}
        files["README.md"] = "For Jazzy.\n"
        said = lint_files(files, ["LCH005"]).findings
        assert all(each.fix for each in said)
        return [(each.message, each.fix.title, len(each.related)) for each in said if each.fix]

    stops = "launch no longer takes {} and stops there; write {}"
    one = stops.format("`node_name` of a node", "`name`")
    assert found("executable='a', node_name='b'") == [(one, "call it `name`", 0)]
    same = stops.format("`node_executable` of nodes", "`executable`")
    assert found("node_executable='a'", "node_executable='b'") == [(same, "write `executable`", 1)]
    both = stops.format("`node_executable` and `node_name` of nodes", "`executable` and `name`")
    assert found("node_executable='a', node_name='b'") == [(both, "write `executable` and `name`", 1)]


def test_what_ros1_left_in_a_ported_launch_file() -> None:
    node = '<node pkg="joy" exec="joy_node" ns="a"><rosparam param="b">1</rosparam></node>'
    files = {
        **cmake(f"install(DIRECTORY launch DESTINATION {ALL})\n"),
        "launch/a.launch": f"<launch>{node * 3}</launch>\n",
    }
    assert told(files, "LCH006", "LCH007") == [("LCH006", 2), ("LCH007", 2)]
    finds = '<launch><node pkg="joy" exec="joy_node" cwd="$(find a)" args="$(find b)"/></launch>\n'
    assert told({**files, "launch/a.launch": finds}, "LCH006", "LCH007") == [("LCH006", 1)]


@pytest.mark.parametrize("folder, expected", [("launch", ["LCH006"]), ("launch/ros1", [])])
def test_a_folder_for_ros1(folder: str, expected: list[str]) -> None:
    files = cmake(f"install(DIRECTORY launch DESTINATION {ALL})\n")
    for text in ('<launch><param name="a" value="1"/></launch>\n', '<launch><node pkg="a" type="b"/></launch>\n'):
        assert codes({**files, f"{folder}/a.launch": text}, "LCH006") == expected


def test_python_packages_that_one_list_leaves_out(clean) -> None:
    text = clean["setup.py"].replace("find_packages(exclude=['test'])", "['my_pkg']")
    inner = {f"my_pkg/{name}/__init__.py": "" for name in ("a", "b", "c")}
    files = {**clean, **inner, "setup.py": text, "my_pkg/talker.py": "import my_pkg.a\nimport my_pkg.b\n"}
    left_out, unused = lint_files(files, ["SET302"]).findings
    assert left_out.message.startswith("`my_pkg.a` and `my_pkg.b` are not in `packages`: ")
    assert unused.message.startswith("`my_pkg.c` is not in `packages`: ")
    assert [left_out.severity.value, unused.severity.value] == ["warning", "info"]
    assert left_out.fix is not None
    assert [each.text for each in left_out.fix.operations if isinstance(each, Edit)] == ["', 'my_pkg.a', 'my_pkg.b'"]


def test_a_description_that_is_not_exported() -> None:
    second = plg003.FILES["plugins.xml"].replace("my_pkg/Planner", "my_pkg/Other").replace("my_pkg::Planner", "Other")
    files = {
        **plg003.FILES,
        "others.xml": second,
        "src/planner.cpp": plg003.FILES["src/planner.cpp"]
        + "PLUGINLIB_EXPORT_CLASS(Other, nav2_core::GlobalPlanner)\n",
        "config/nav2.yaml": plg003.CONFIG.replace("Planner", "Other"),
    }
    assert codes(files, "PLG002", "PLG003") == ["PLG002"]
    del files["others.xml"]
    assert codes(files, "PLG003") == ["PLG003"]


@pytest.mark.parametrize("command, expected", [("ametn_target_dependencies", ["CMK114"]), ("link_all", ["CMK121"])])
def test_a_command_that_is_none_and_may_have_linked(command: str, expected: list[str]) -> None:
    needs = "  <depend>rclcpp</depend>\n  <depend>sensor_msgs</depend>\n"
    lines = (
        "find_package(rclcpp REQUIRED)\nfind_package(sensor_msgs REQUIRED)\nadd_executable(a src/a.cpp)\n"
        "target_link_libraries(a rclcpp::rclcpp)\n" + f"{command}(a sensor_msgs)\n"
    )
    source = "#include <rclcpp/rclcpp.hpp>\n#include <sensor_msgs/msg/image.hpp>\n" + TALKER
    assert codes({**cmake(lines, needs), "src/a.cpp": source}, "CMK114", "CMK121") == expected
