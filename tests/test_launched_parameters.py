"""Parameter files and values that launch files give to nodes."""

from __future__ import annotations

import pytest

from rospkg_cli.checks.params.parameter_file_paths import MAX_DEPTH
from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

INSTALL = "install(DIRECTORY launch config DESTINATION share/${PROJECT_NAME})\n"
CODE = """\
Talker() : Node("talker")
{
  declare_parameter<double>("rate");
  declare_parameter<std::string>("frame");
  // for tests
  declare_parameter<bool>("verbose");
  if (get_parameter("verbose").as_bool()) {
    declare_parameter<double>("only_then");
  }
  declare_parameter("optional", 5);
  declare_parameter("number_of_wheels", 4);
  declare_parameter("middle_of_height", 4.0);
}
"""


def package(launch: str, values: str = "", name: str = "robot.launch.xml") -> dict[str, str]:
    build = "add_executable(talker src/talker.cpp)\ninstall(TARGETS talker DESTINATION lib/${PROJECT_NAME})\n"
    return {
        "package.xml": manifest("", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace("ament_package", build + INSTALL + "ament_package"),
        "src/talker.cpp": CODE,
        f"launch/{name}": launch,
        "config/robot.yaml": values or "other:\n  ros__parameters:\n    a: 1\n",
    }


def xml(inside: str, attributes: str = 'name="talker"', arguments: str = "") -> str:
    return f'<launch>{arguments}<node pkg="my_pkg" exec="talker" {attributes}>{inside}</node></launch>\n'


def messages(files: dict[str, str], code: str) -> list[str]:
    return [finding.message for finding in lint_files(files, [code]).findings]


FILE = '<param from="$(find-pkg-share my_pkg)/config/robot.yaml"/>'
ALL = "    rate: 1.0\n    frame: map\n    verbose: true\n"
INLINE = '<param name="rate" value="1.0"/><param name="frame" value="map"/><param name="verbose" value="true"/>'


@pytest.mark.parametrize(
    "inside, values, missing",
    [
        (INLINE, "", []),
        ("", "", ["rate", "frame", "verbose"]),
        ('<param name="rate" value="1.0"/>', "", ["frame", "verbose"]),
        (FILE, f"talker:\n  ros__parameters:\n{ALL}", []),
        (FILE, f"/**:\n  ros__parameters:\n{ALL}", []),
        (FILE, f"/ns/talker:\n  ros__parameters:\n{ALL}", []),
        (FILE, f"somebody:\n  ros__parameters:\n{ALL}", ["rate", "frame", "verbose"]),
        (FILE + '<param name="rate" value="1.0"/>', "/**:\n  ros__parameters:\n    frame: map\n", ["verbose"]),
        ('<param from="$(var unknown)"/>', "", []),
        ('<param from="$(find-pkg-share elsewhere)/config/robot.yaml"/>', "", []),
        ('<param name="$(var unknown)" value="1"/>', "", []),
    ],
)
def test_what_a_node_needs_and_is_not_given(inside: str, values: str, missing: list[str]) -> None:
    found = messages(package(xml(inside), values), "PRM008")
    assert bool(found) is bool(missing), found
    for name in missing:
        assert f"`{name}`" in found[0]
    assert not any("only_then" in message or "optional" in message for message in found)


def test_a_launch_argument_stands_for_its_default() -> None:
    argument = '<arg name="file" default="$(find-pkg-share my_pkg)/config/robot.yaml"/>'
    launch = xml('<param from="$(var file)"/>', arguments=argument)
    assert messages(package(launch, "talker:\n  ros__parameters:\n    rate: 1.0\n"), "PRM008")
    assert not messages(package(launch, f"talker:\n  ros__parameters:\n{ALL}"), "PRM008")


def test_defaults_are_followed_through_other_arguments_as_far_as_promised() -> None:
    """What is not followed may be any file of the folder, and then it is not known what the node is given."""

    def found(count: int) -> list[str]:
        names = [f"a{number}" for number in range(count)]
        values = [*(f"$(var {name})" for name in names[1:]), "robot"]
        arguments = "".join(
            f'<arg name="{name}" default="{value}"/>' for name, value in zip(names, values, strict=True)
        )
        given = '<param from="$(find-pkg-share my_pkg)/config/$(var a0).yaml"/>'
        files = package(xml(given, arguments=arguments), "talker:\n  ros__parameters:\n    rate: 1.0\n")
        return messages({**files, "config/other.yaml": "other:\n  ros__parameters:\n    a: 1\n"}, "PRM008")

    assert [bool(found(count)) for count in (1, 2, MAX_DEPTH, MAX_DEPTH + 1)] == [True, True, True, False]


def test_a_node_that_may_not_be_started_is_left_alone() -> None:
    launch = xml("", 'name="talker" if="$(var x)"', '<arg name="x" default="true"/>')
    assert not messages(package(launch), "PRM008")


@pytest.mark.parametrize(
    "key, named",
    [
        ("talker_node", True),
        ("talkr", True),
        ("talker", False),
        ("/**", False),
        ("/ns/talker", False),
        ("listener", True),
        ("$(var name)", False),
    ],
)
def test_blocks_that_no_node_reads(key: str, named: bool) -> None:
    found = messages(package(xml(FILE), f"'{key}':\n  ros__parameters:\n    a: 1\n"), "PRM003")
    assert bool(found) is named, found


def test_a_block_of_another_node_that_is_started_here_is_right() -> None:
    both = '<launch><node pkg="a" exec="a" name="talker"/>' + xml(FILE, 'name="talkers"').removeprefix("<launch>")
    assert not messages(package(both, "talker:\n  ros__parameters:\n    a: 1\n"), "PRM003")


def test_a_piece_of_a_path_that_is_filled_in_may_be_any_name() -> None:
    launch = xml('<param from="$(find-pkg-share my_pkg)/config/$(var robot).yaml"/>', arguments='<arg name="robot"/>')
    assert messages(package(launch, "talker_node:\n  ros__parameters:\n    a: 1\n"), "PRM003")


def test_a_component_reads_its_file_through_python() -> None:
    component = '<composable_node pkg="my_pkg" plugin="my_pkg::Talker" name="talker">{}</composable_node>'
    container = (
        '<node_container pkg="rclcpp_components" exec="component_container" name="c" namespace="">{}</node_container>'
    )
    values = "talker:\n  ros__parameters:\n    a: 1e-9\n"
    given = f"<launch>{container.format(component.format(FILE))}</launch>\n"
    levels = [
        finding.severity.value
        for launch in (given, given.replace('name="talker"', 'name="other"'), xml(FILE))
        for finding in lint_files(package(launch, values), ["PRM005"]).findings
    ]
    assert levels == ["warning", "info", "info"]


def test_a_number_in_a_block_that_no_node_reads() -> None:
    values = "talker:\n  ros__parameters:\n    a: 10_000\nother:\n  ros__parameters:\n    b: 0\n"
    launches = (xml(FILE, 'name="talker"'), xml(FILE.replace("robot", "robots"), 'name="talker"'))
    found = [lint_files(package(each, values), ["PRM005"]).findings for each in launches]
    assert [[each.severity.value for each in one] for one in found] == [["warning"], ["info"]]


@pytest.mark.parametrize(
    "number, told",
    [("03", ""), ("-07", ""), ("+07", ""), ("00", ""), ("007", ""), ("010", "10"), ("017", "17"), ("08", "8")],
)
def test_a_zero_before_a_digit_is_told_where_the_number_is_another(number: str, told: str) -> None:
    files = package(xml(FILE), f"talker:\n  ros__parameters:\n    a: {number}\n")
    found = lint_files(files, ["PRM005"]).findings
    assert [each.severity.value for each in found] == ["warning"] * bool(told)
    assert all(f"write `{told}`" in each.message for each in found)


PLUGINS = """\
server:
  ros__parameters:
    recovery_plugins: {names}
    spin: {{plugin: a::Spin}}
    backup: {{plugin: a::BackUp}}
"""


@pytest.mark.parametrize(
    "names, said",
    [
        ("[spin, backup]", ""),
        ("[spin, back_up]", "`back_up`"),
        ("[spin]", ""),
        ("[spin, x, y]", ""),
        ("[backup, z]", "`z`"),
    ],
)
def test_lists_of_plugins(names: str, said: str) -> None:
    found = messages(package("<launch/>\n", PLUGINS.format(names=names)), "PRM008")
    assert bool(found) is bool(said), found
    assert all(said in message for message in found)


@pytest.mark.parametrize(
    "names, meant",
    [
        (["rat"], []),
        (["rrate"], ["`rate`"]),
        (["raet", "frame"], ["`rate`"]),
        (["raet", "rate"], []),
        (["raet", "nothing", "else"], []),
        (["verbsoe"], ["`verbose`"]),
        (["vrbsoe"], []),
        (["vrbsoe", "rate"], ["`verbose`"]),
        (["fra"], []),
        (["use_sim_time"], []),
        (["wheels"], ["`number_of_wheels`"]),
        (["number"], []),
        (["height"], []),
        (["wheels_of_number"], ["`number_of_wheels`"]),
        (["of_wheels", "nothing"], []),
        (["wheel"], []),
        (["of"], []),
    ],
)
def test_names_in_launch_files_that_the_package_does_not_declare(names: list[str], meant: list[str]) -> None:
    inside = "".join(f'<param name="{name}" value="1"/>' for name in names)
    found = messages(package(xml(inside)), "PRM007")
    assert [message.rpartition("mean ")[2].rstrip("?") for message in found] == meant


def test_names_of_a_package_that_is_not_here_are_left_alone() -> None:
    launch = xml('<param name="rrate" value="1"/>').replace('pkg="my_pkg"', 'pkg="elsewhere"')
    assert messages(package(launch), "PRM007") == []


def test_lists_of_plugins_beside_a_single_one() -> None:
    """`progress_checker_plugin: progress_checker` names a group as well, and of several the near one is meant."""
    block = PLUGINS.format(names="[spin, back_up]") + "    check: {plugin: a::Check}\n"
    single = "    check_plugin: check\n"
    for text in (block, block + single):
        (message,) = messages(package("<launch/>\n", text), "PRM008")
        assert "did you mean `backup`" in message
    far = PLUGINS.format(names="[spin, z]") + "    check: {plugin: a::Check}\n"
    assert not messages(package("<launch/>\n", far), "PRM008")
    assert messages(package("<launch/>\n", far + single), "PRM008")


def test_a_copy_of_a_parameter_file_that_was_left_behind() -> None:
    theirs = {
        f"src/talker/{path}": text for path, text in package("<launch/>\n", f"/**:\n  ros__parameters:\n{ALL}").items()
    }
    theirs["src/talker/package.xml"] = manifest("", "ament_cmake", "talker")
    theirs["src/talker/src/talker.cpp"] = CODE.replace("  if", '  declare_parameter<int>("count");\n  if')
    theirs["src/talker/config/robot.yaml"] += "    count: 1\n"
    copy = {
        "src/bringup/package.xml": manifest("", "ament_cmake", "bringup"),
        "src/bringup/CMakeLists.txt": CMAKE.replace("my_pkg", "bringup"),
        "src/bringup/config/talker.yaml": f"/**:\n  ros__parameters:\n{ALL}",
    }
    (message,) = messages({**theirs, **copy}, "PRM008")
    assert message.startswith("`count` is missing here, and `")
    copy["src/bringup/config/talker.yaml"] += "    count: 1\n"
    assert not messages({**theirs, **copy}, "PRM008")


@pytest.mark.parametrize(
    "broken", [{"launch/b.launch.py": "def f(:\n"}, {"config/b.yaml": "a:\n  ros__parameters: [\n"}]
)
def test_a_file_that_cannot_be_read_silences_only_what_it_may_explain(broken: dict[str, str]) -> None:
    given = INLINE.replace("verbose", "verbos")
    assert len(messages({**package(xml(given)), **broken}, "PRM007")) == 1
    assert len(messages(package(xml(given)), "PRM008")) == 1
    assert messages({**package(xml(given)), **broken}, "PRM008") == []
    block = package(xml(FILE), "talke:\n  ros__parameters:\n    rate: 1.0\n")
    assert len(messages(block, "PRM003")) == 1
    assert messages({**block, **broken}, "PRM003") == []


@pytest.mark.parametrize(
    "program, count",
    [("talker", 1), ("talker.py", 0), ("joy_talker", 0)],
)
def test_types_count_for_the_program_that_declares_them(program: str, count: int) -> None:
    inside = '<param name="rate" value="10"/><param name="frame" value="odom"/>'
    files = package(f'<launch><node pkg="my_pkg" exec="{program}">{inside}</node></launch>')
    assert len(lint_files(files, ["PRM006"]).findings) == count
