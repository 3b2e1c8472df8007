"""Fixes that a maintainer merges as they stand: in the file's layout, and with no value that a template left."""

from __future__ import annotations

import pytest

from rospkg_cli.edits.cmake_export import append_names
from rospkg_cli.edits.cmake_rule_place import in_block_of_package
from rospkg_cli.edits.launch_file import import_name, pass_through
from rospkg_cli.edits.manifest import add_dependency
from rospkg_cli.engine.fixing.fix import fix_all
from rospkg_cli.engine.fixing.fix_results import FixResults
from rospkg_cli.engine.run.scope import Scope
from rospkg_cli.engine.run.session import Session
from rospkg_cli.example import BACKDROPS, CMAKE, SETUP_PY, existing_files, manifest, scripts, setup_py
from rospkg_cli.files import PackageFiles
from rospkg_cli.finding import Safety
from rospkg_cli.languages.cmake.file import read_file
from rospkg_cli.languages.python.file import parse_python
from rospkg_cli.package.manifest import manifest_of
from rospkg_cli.ros.link_targets import link_targets
from rospkg_cli.rules.cmake import cmk005_removed_command as cmk005
from rospkg_cli.rules.launch import lch009_unquoted_robot_description as lch009
from rospkg_cli.source import Source, Span
from rospkg_cli.testing import lint_files
from rospkg_cli.tree import MemoryTree

PYTHON = existing_files(BACKDROPS["ament_python"])
CMAKE_FILES = existing_files(BACKDROPS["ament_cmake"])
NODE = "import rclpy\n\n\ndef main():\n    rclpy.init()\n\n\nif __name__ == '__main__':\n    main()\n"
EVERY = (Safety.SAFE, Safety.UNSAFE)


def run(files: dict[str, str], *codes: str, safety: tuple[Safety, ...] = EVERY) -> FixResults:
    session = Session(MemoryTree.of(files), Scope(("",), frozenset({""}), ""), frozenset(codes))
    return fix_all(session, safety)


def fixed(files: dict[str, str], path: str, *codes: str, safety: tuple[Safety, ...] = EVERY) -> str:
    """Return a file after all fixes of some rules."""
    entry = run(files, *codes, safety=safety).changes.get(path)
    return entry.text.text if entry else files[path]


def test_data_files_that_were_not_there_stand_on_lines_of_their_own() -> None:
    start, end = SETUP_PY.index("    data_files=["), SETUP_PY.index("    install_requires")
    text = SETUP_PY[:start] + SETUP_PY[end:]
    after = fixed({**PYTHON, "setup.py": text}, "setup.py", "SET201", "SET203")
    assert after == text.removesuffix(")\n") + (
        "    data_files=[\n"
        "        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),\n"
        "        ('share/' + package_name, ['package.xml']),\n"
        "    ],\n)\n"
    )


@pytest.mark.parametrize("gap", ["\n", ""])
def test_export_at_the_end_is_parted_as_the_others_are(gap: str) -> None:
    text = manifest("  <depend>rclcpp</depend>\n", "ament_cmake")
    start, end = text.index("  <export>"), text.index("</package>")
    head = text[:start].rstrip().replace("\n\n", "\n").replace("  <buildtool", f"{gap}  <buildtool")
    head = head.replace("  <depend>", f"{gap}  <depend>") + "\n"
    after = fixed({**CMAKE_FILES, "package.xml": head + text[end:]}, "package.xml", "XML301")
    assert after == head + gap + text[start:]


@pytest.mark.parametrize(
    ("name", "theirs", "ours", "safety"),
    [
        ("maintainer_email", "ada@example.org", "ada@todo.todo", "safe"),
        ("maintainer_email", "ada@example.org", "adda@example.org", "unsafe"),
        ("maintainer_email", "you@example.com", "ada@example.org", None),
        ("maintainer", "Ada", "your_name", "safe"),
        ("maintainer", "Ada", "Your Name", "safe"),
        ("maintainer", "Ada", "Charles", "unsafe"),
        ("maintainer", "Your Name", "Charles", None),
        ("license", "Apache-2.0", "TODO: License declaration", "safe"),
        ("license", "License declaration", "TODO: License declaration", "unsafe"),
        ("license", "Apache-2.0", "see the file", "unsafe"),
    ],
)
def test_no_value_of_a_template_and_none_of_two_real_ones_unasked(
    name: str, theirs: str, ours: str, safety: str | None
) -> None:
    right = {"maintainer_email": "ada@example.org", "maintainer": "Ada", "license": "Apache-2.0"}[name]
    files = {"package.xml": manifest(), "setup.py": SETUP_PY}
    files["package.xml"] = (
        files["package.xml"].replace(f'"{right}"', f'"{theirs}"').replace(f">{right}<", f">{theirs}<")
    )
    files["setup.py"] = files["setup.py"].replace(f"{name}='{right}'", f"{name}='{ours}'")
    found = lint_files({**PYTHON, **files}, ["SET403"]).findings
    assert [each.fix.safety.value for each in found if each.fix] == ([safety] if safety else [])
    assert len(found) == (safety is not None)


def test_quotes_are_those_of_the_neighbours() -> None:
    files = {**PYTHON, "my_pkg/listener.py": NODE, "my_pkg/talker.py": NODE}
    text = setup_py(scripts("talker = my_pkg.talker:main")).replace("'talker = my_pkg.talker:main'", "'a'")
    text = text.replace("'a'", '"talker=my_pkg.talker:main"').replace(
        "    zip_safe", "    tests_require=['pytest'],\n    zip_safe"
    )
    after = fixed({**files, "setup.py": text}, "setup.py", "SET106", "SET304")
    assert '"listener=my_pkg.listener:main"' in after
    assert "extras_require={'test': ['pytest']}" in after


def test_a_module_that_cannot_be_named_gets_no_entry_point() -> None:
    files = {
        **PYTHON,
        "my_pkg/talker.py": NODE,
        "my_pkg/new talker.py": NODE,
        "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
    }
    assert fixed(files, "setup.py", "SET106") == files["setup.py"]


NAMES = [f"interfaces_of_part_{number}_msgs" for number in range(4)]
TARGETS = [f"${{{name}_TARGETS}}" for name in NAMES]


@pytest.mark.parametrize(
    ("call", "after"),
    [
        (f"(talker {' '.join(NAMES)})", "(talker PUBLIC" + "".join(f"\n  {each}" for each in TARGETS) + ")"),
        (
            f"(talker\n  {' '.join(NAMES)})",
            f"(talker PUBLIC\n  {' '.join(TARGETS[:2])}\n  {' '.join(TARGETS[2:])})",
        ),
        ("(talker \n  ${names})", f"(talker PUBLIC \n  {TARGETS[0]}\n  {TARGETS[1]})"),
        (f"(talker\n  {NAMES[0]}\n  {NAMES[1]})", f"(talker PUBLIC\n  {TARGETS[0]}\n  {TARGETS[1]})"),
    ],
)
def test_links_that_are_longer_than_the_packages_are_spread(call: str, after: str) -> None:
    call = f"ament_target_dependencies{call}"
    text = cmk005.ONE.replace("«ament_target_dependencies»(talker rclcpp std_msgs)", call)
    text = text.replace("find_package(rclcpp", f"set(names {NAMES[0]} {NAMES[1]})\nfind_package(rclcpp")
    made = fixed({**CMAKE_FILES, **cmk005.FILES, "CMakeLists.txt": text}, "CMakeLists.txt", "CMK005")
    assert made == text.replace(call, f"target_link_libraries{after}")


def test_a_bracket_stands_alone_where_others_do() -> None:
    files = "install(FILES\n  a\n  DESTINATION share/a\n)\nament_package"
    text = cmk005.ONE.replace("«ament_target_dependencies»", "ament_target_dependencies")
    text = text.replace("talker rclcpp std_msgs", f"talker {' '.join(NAMES)}").replace("ament_package", files)
    made = fixed({**CMAKE_FILES, **cmk005.FILES, "CMakeLists.txt": text}, "CMakeLists.txt", "CMK005")
    assert f"\n  {TARGETS[-1]}\n)\n" in made


LONG = "description_of_a_robot_with_two_arms"


@pytest.mark.parametrize(
    ("before", "after"),
    [
        (
            '    robot = {"robot_description": LONG}\n',
            '    robot = {\n        "robot_description": ParameterValue(LONG, value_type=str)\n    }\n',
        ),
        (
            '    robot = {\n        "robot_description": xacro_LONG\n    }\n',
            '    robot = {\n        "robot_description": ParameterValue(\n'
            "            xacro_LONG, value_type=str\n        )\n    }\n",
        ),
    ],
)
def test_a_value_is_wrapped_as_black_would(before: str, after: str) -> None:
    start = lch009.GOOD.index("    description = ")
    head = lch009.GOOD[:start].replace("from launch_ros.parameter_descriptions import ParameterValue\n", "")
    name = "xacro_LONG" if "xacro_LONG" in before else "LONG"
    rest = (
        f"    {name} = {lch009.COMMAND}\n{before}"
        '    return LaunchDescription(\n        [Node(package="robot_state_publisher", '
        'executable="robot_state_publisher", parameters=[robot])]\n    )\n'
    )
    files = {**PYTHON, "urdf/robot.urdf.xacro": lch009.ROBOT, "launch/a.launch.py": (head + rest).replace("LONG", LONG)}
    made = fixed(files, "launch/a.launch.py", "LCH009")
    assert after.replace("LONG", LONG) in made
    compile(made, "a.launch.py", "exec")


def test_what_is_needed_for_more_is_declared_once() -> None:
    cmake = CMAKE.replace("ament_package", "find_package(joy REQUIRED)\nament_package")
    files = {"package.xml": manifest("", "ament_cmake"), "CMakeLists.txt": cmake}
    files["launch/a.launch.xml"] = '<launch>\n  <node pkg="joy" exec="x"/>\n  <node pkg="rviz2" exec="x"/>\n</launch>\n'
    found = run({**CMAKE_FILES, **files}, "DEP103", "DEP104", "XML202")
    assert sorted(each.fix.title for each in found.applied if each.fix) == [
        "add <depend>joy</depend>",
        "add <exec_depend>rviz2</exec_depend>",
    ]


@pytest.mark.parametrize(
    ("folder", "user", "safety"),
    [
        ("speech", "", "safe"),
        ("examples", "", "unsafe"),
        ("examples", "import my_pkg.examples.words\n", "safe"),
    ],
)
def test_examples_are_not_installed_unasked(folder: str, user: str, safety: str) -> None:
    files = {**PYTHON, f"my_pkg/{folder}/words.py": "GREETING = 'hello'\n", "my_pkg/talker.py": user}
    (finding,) = lint_files(files, ["SET301"]).findings
    assert finding.fix is not None
    assert finding.fix.safety.value == safety


def test_gazebo_is_what_serves_to_build_with_it() -> None:
    cmake = CMAKE.replace("ament_package", "find_package(gazebo REQUIRED)\nament_package")
    assert "<depend>gazebo_dev</depend>" in fixed({**CMAKE_FILES, "CMakeLists.txt": cmake}, "package.xml", "DEP104")


@pytest.mark.parametrize(
    ("there", "after"),
    [
        ("(rclcpp)", "(rclcpp std_msgs)"),
        (f"({NAMES[0]} {NAMES[1]} {NAMES[2]})", "(" + "".join(f"\n  {n}" for n in NAMES[:3]) + "\n  std_msgs\n)"),
        (f"(\n  more_than_msgs {' '.join(NAMES[:3])})", f"(\n  more_than_msgs {' '.join(NAMES[:3])}\n  std_msgs)"),
    ],
)
def test_exports_keep_to_the_width(there: str, after: str) -> None:
    files = PackageFiles(MemoryTree.of({"CMakeLists.txt": f"ament_export_dependencies{there}\nament_package()\n"}))
    file = read_file(files, "CMakeLists.txt")
    source = file.source
    edit = append_names(file, file.syntax.commands[0], ["std_msgs"])
    text = source.text[: edit.span.start] + edit.text + source.text[edit.span.end :]
    assert text == f"ament_export_dependencies{after}\nament_package()\n"


def test_blanks_at_the_end_of_a_line_go_with_it() -> None:
    text = manifest("  <depend>rclcpp</depend>  \n  <url>https://example.org</url>\n")
    after = fixed({**PYTHON, "package.xml": text}, "package.xml", "XML002")
    assert sorted(after.splitlines()) == sorted(text.splitlines())
    assert after != text


@pytest.mark.parametrize(("main", "is_repaired"), [(None, True), ("x = 1\n", False)])
def test_an_entry_point_without_a_function_names_no_module_as_one(main: str | None, is_repaired: bool) -> None:
    text = setup_py(scripts("talker = my_pkg.talker.main" if main is None else "talker = my_pkg.talker"))
    files = {**PYTHON, "my_pkg/talker.py": main or NODE, "setup.py": text}
    assert (fixed(files, "setup.py", "SET103") != text) == is_repaired


def test_another_kind_stands_below_what_is_left_out() -> None:
    there = "  <depend>rclcpp</depend>\n  <!-- <depend>jsoncpp</depend> -->\n  <test_depend>joy</test_depend>\n"
    text = manifest(there, "ament_cmake")
    for tag in ("buildtool_depend", "depend", "test_depend", "export"):
        text = text.replace(f"\n  <{tag}>", f"\n\n  <{tag}>")
    files = {
        **CMAKE_FILES,
        "package.xml": text,
        "launch/a.launch.xml": '<launch>\n  <node pkg="rviz2" exec="x"/>\n</launch>\n',
    }
    after = fixed(files, "package.xml", "DEP103")
    assert "-->\n\n  <exec_depend>rviz2</exec_depend>\n\n  <test_depend>" in after


def test_a_destination_is_written_as_the_others_are() -> None:
    other = "os.path.join('share', package_name, 'config')"
    entries = f"({other}, ['config/a.yaml']),\n        ('config', ['config/b.yaml']),\n    ]"
    text = SETUP_PY.replace("from setuptools", "import os\n\nfrom setuptools").replace(
        "    ],\n    install", f"        {entries},\n    install"
    )
    files = {**PYTHON, "config/a.yaml": "", "config/b.yaml": "", "setup.py": text}
    assert fixed(files, "setup.py", "SET208") == text.replace("('config', [", f"({other}, [")


@pytest.mark.parametrize(
    ("imports", "after"),
    [
        (("launch_ros.actions", "launch_ros.substitutions", "launch.conditions"), 1),
        (("launch_ros.substitutions", "launch.conditions"), 0),
        (("launch.conditions", "os"), 1),
    ],
)
def test_an_import_stands_by_those_of_its_package(imports: tuple[str, ...], after: int) -> None:
    lines = [f"from {module} import {letter}\n" for module, letter in zip(imports, "abc", strict=False)]
    file = parse_python(Source("a.launch.py", "".join(lines)))
    (edit,) = import_name(file, "launch_ros.parameter_descriptions", "ParameterValue")
    assert edit.span.start == sum(map(len, lines[:after]))


@pytest.mark.parametrize(
    ("comment", "shift"), [("# The next one\n", ""), ("  # Of it\n", "  "), ("\n# Two\n# lines\n", "")]
)
def test_a_comment_of_the_next_block_stays(comment: str, shift: str) -> None:
    text = f"talker:\n  rate: 1.0\n{comment}listener:\n  ros__parameters:\n    rate: 1.0\n"
    after = fixed({**PYTHON, "config/a.yaml": text}, "config/a.yaml", "PRM001")
    assert after == text.replace("  rate: 1.0\n" + comment, f"  ros__parameters:\n    rate: 1.0\n{shift}{comment}", 1)


@pytest.mark.parametrize("has_rule", [True, False])
def test_a_rule_stands_in_the_branch_of_its_package(has_rule: bool) -> None:
    rule = "  install(DIRECTORY launch\n    DESTINATION lib/a\n  )\n" if has_rule else ""
    text = (
        "cmake_minimum_required(VERSION 3.10)\nproject(my_pkg)\nfind_package(ros_environment)\n"
        "if($ENV{ROS_VERSION} EQUAL 1)\n  install(DIRECTORY launch\n    DESTINATION lib/b\n  )\nelse()\n"
        f"  find_package(ament_cmake REQUIRED)\n{rule}  ament_package()\nendif()"
    )
    files = PackageFiles(MemoryTree.of({**CMAKE_FILES, "CMakeLists.txt": text}))
    edit = in_block_of_package(read_file(files, "CMakeLists.txt"), "install(DIRECTORY rviz\n  DESTINATION share/a\n)")
    assert edit is not None
    made = text[: edit.span.start] + edit.text + text[edit.span.end :]
    added = "\n  install(DIRECTORY rviz\n    DESTINATION share/a\n  )\n" + ("" if has_rule else "\n")
    assert made == text.replace("  ament_package", f"{added}  ament_package")


def test_what_only_ros_2_has_is_for_ros_2_where_others_are() -> None:
    condition = 'condition="$ROS_VERSION == 2"'
    text = manifest(f"  <depend {condition}>rclpy</depend>\n", "ament_cmake")
    nodes = '<launch>\n  <node pkg="ros_gz_sim" exec="x"/>\n  <node pkg="joy" exec="x"/>\n</launch>\n'
    after = fixed({**CMAKE_FILES, "package.xml": text, "launch/a.launch.xml": nodes}, "package.xml", "DEP103")
    assert f"<exec_depend {condition}>ros_gz_sim<" in after
    assert "<exec_depend>joy<" in after


def test_a_library_of_the_system_is_linked_by_what_its_find_module_sets() -> None:
    assert link_targets("jsoncpp").targets == ("${jsoncpp_LIBRARIES}",)


def test_include_directories_keep_to_the_width() -> None:
    libraries = ["OneLibraryOfOurs", "AnotherLibraryOfOurs", "YetAnotherLibraryOfOurs"]
    call = f"ament_target_dependencies(talker\n  {' '.join(libraries)})"
    text = cmk005.ONE.replace("«ament_target_dependencies»(talker rclcpp std_msgs)", call)
    made = fixed({**CMAKE_FILES, **cmk005.FILES, "CMakeLists.txt": text}, "CMakeLists.txt", "CMK005")
    written = "".join(f"\n  ${{{each}_INCLUDE_DIRS}}" for each in libraries)
    assert f"\ntarget_include_directories(talker PUBLIC{written})\n" in made


def test_tabs_stay_tabs() -> None:
    text = cmk005.ONE.replace("«ament_target_dependencies»", "ament_target_dependencies")
    text = text.replace("talker rclcpp std_msgs", f"talker {' '.join(NAMES)}")
    text = text.replace("ament_package", "install(FILES a\n\tDESTINATION share/a)\nament_package")
    made = fixed({**CMAKE_FILES, **cmk005.FILES, "CMakeLists.txt": text}, "CMakeLists.txt", "CMK005")
    assert f"(talker PUBLIC\n\t{TARGETS[0]}\n\t" in made
    start, end = SETUP_PY.index("    data_files=["), SETUP_PY.index("    install_requires")
    text = (SETUP_PY[:start] + SETUP_PY[end:]).replace("\n    ", "\n\t")
    made = fixed({**PYTHON, "setup.py": text}, "setup.py", "SET201", "SET203")
    assert "\n\tdata_files=[\n\t\t('share/" in made
    file = parse_python(Source("a.py", f"{{\n\t'a': {'a' * 50},\n}}\n"))
    first, _ = pass_through(file, Span(8, 58), "ParameterValue", "value_type=str", 80)
    assert first.text == "ParameterValue(\n\t\t"


@pytest.mark.parametrize(("name", "block"), [("sensor_msgs", 0), ("python3-yaml", 1)])
def test_packages_and_keys_stand_by_their_like(name: str, block: int) -> None:
    blocks = [
        "<exec_depend>rclpy</exec_depend>",
        "".join(f"<exec_depend>python3-{each}</exec_depend>" for each in "ab"),
    ]
    body = [text.replace("><exec", ">\n  <exec") for text in blocks]
    manifest_text = manifest("  <HERE/>\n").replace("<HERE/>", "\n\n  ".join(body))
    found = manifest_of(Source("package.xml", manifest_text))
    at = add_dependency(found, "exec_depend", name).span.start
    assert (at > manifest_text.index("python3-a")) == bool(block)


def test_a_package_is_looked_for_at_the_depth_of_the_others() -> None:
    text = cmk005.ONE.replace("«ament_target_dependencies»(talker rclcpp std_msgs)\n", "")
    text = text.replace("find_package(rclcpp REQUIRED)\n", "").replace("find_package(", "   find_package(")
    source = "#include <rclcpp/rclcpp.hpp>\n\nint main() {return 0;}\n"
    files = {**CMAKE_FILES, **cmk005.FILES, "src/talker.cpp": source, "CMakeLists.txt": text}
    assert "\n   find_package(rclcpp REQUIRED)\n" in fixed(files, "CMakeLists.txt", "DEP107")
