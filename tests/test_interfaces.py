"""Interface files: the grammar of rosidl, and types across packages. (tests/real asks the real one.)"""

from __future__ import annotations

import pytest
from interface_texts import REFUSED, TAKEN

from rospkg_cli.checks.interfaces.grammar import grammar_faults
from rospkg_cli.checks.interfaces.member_names import is_accepted
from rospkg_cli.engine.fixing.apply import apply_fixes
from rospkg_cli.example import BACKDROPS, INTERFACES_BODY, manifest
from rospkg_cli.package.interfaces.interface_file import InterfaceFile
from rospkg_cli.package.interfaces.text import parse_interface
from rospkg_cli.source import Source
from rospkg_cli.testing import lint_files
from rospkg_cli.tree import MemoryTree

IDL = ["IDL001", "IDL002", "IDL003", "IDL004"]


def read(kind: str, text: str) -> InterfaceFile:
    return parse_interface(Source(f"{kind}/Foo.{kind}", text), kind)


@pytest.mark.parametrize("kind, text", TAKEN)
def test_what_rosidl_takes(kind: str, text: str) -> None:
    assert is_accepted(read(kind, text))


@pytest.mark.parametrize("kind, text", REFUSED)
def test_what_rosidl_refuses(kind: str, text: str) -> None:
    assert not is_accepted(read(kind, text))


def test_every_fault_is_found_not_only_the_first() -> None:
    found = read("msg", "int a\nint32 b\nfloat c\nuint8 d 300\n").problems
    assert [problem.span.start for problem in found] == [0, 14, 30]


def test_places_are_those_of_the_file() -> None:
    source = Source("msg/Foo.msg", "# a comment\n\nPoint[<=3]\t where  # [m]\nuint8 SIX = 6\n")
    point, six = parse_interface(source, "msg").members
    assert source.slice(point.type.span) == "Point[<=3]"
    assert source.slice(point.type.base_span) == "Point"
    assert source.slice(point.name_span) == "where"
    assert (point.type.size, point.type.is_bounded, point.type.is_primitive) == (3, True, False)
    assert source.slice(six.name_span) == "SIX"
    assert six.value_span
    assert source.slice(six.value_span) == "6"


def test_a_service_has_two_sections_that_may_share_names() -> None:
    found = read("srv", "int32 a\n---\nint32 a\n")
    assert [section.suffix for section in found.sections] == ["_Request", "_Response"]
    assert is_accepted(found)


def test_a_name_that_never_ends_is_refused_at_once() -> None:
    """rosidl's own pattern for constants takes exponential time here."""
    assert not is_accepted(read("msg", f"int32 {'A' * 5000}_=1\n"))


def workspace(**texts: str) -> dict[str, str]:
    return {
        "src/shapes/package.xml": manifest("", "ament_cmake", "shapes"),
        "src/robot/package.xml": manifest("", "ament_cmake", "robot"),
        "src/shapes/msg/Square.msg": "float32 side\n",
        "src/shapes/srv/Cut.srv": "---\n",
        **{f"src/robot/msg/{name}.msg": text for name, text in texts.items()},
    }


@pytest.mark.parametrize(
    "text, said",
    [
        ("shapes/Square s", ""),
        ("Square s", "this package has no `msg/Square.msg`"),
        ("shapes/Squaer s", "write `shapes/Square`"),
        ("shapes/Circle c", "`shapes` has no message `Circle`"),
        ("shapes/Cut c", "`shapes` has no message `Cut`"),
        ("elsewhere/Anything a", ""),
        ("geometry_msgs/SomethingNew a", ""),
        ("geometry_msgs/Pose2d a", "write `geometry_msgs/Pose2D`"),
        ("sensor_msgs/Pose a", "write `geometry_msgs/Pose`"),
        ("String label", "write `string`"),
        ("std_msgs/Square s", "write `shapes/Square`"),
        ("elsewhere/Square s", ""),
        ("Other o", ""),
    ],
)
def test_types_across_the_workspace(text: str, said: str) -> None:
    found = lint_files(workspace(Robot=text + "\n", Other="int32 a\n"), ["IDL004"]).findings
    assert bool(found) is bool(said)
    assert all(said in finding.message for finding in found)


@pytest.mark.parametrize(
    ("path", "listed", "level"),
    [
        ("msg/Zone.msg", "${MESSAGES}", "warning"),
        ("msg/old/Zone.msg", "${MESSAGES}", None),
        ("msg/Zone_backup.msg", "${MESSAGES}", None),
        ("msg/old/Zone.msg", "msg/old/Zone.msg", "error"),
    ],
)
def test_an_unknown_list_holds_nothing_that_is_laid_aside(path: str, listed: str, level: str | None) -> None:
    cmake = BACKDROPS["interfaces"]["CMakeLists.txt"]
    call = f"rosidl_generate_interfaces(${{PROJECT_NAME}} {listed})"
    files = {**BACKDROPS["interfaces"], "CMakeLists.txt": f"{cmake.partition('rosidl_generate')[0]}{call}\n"}
    found = lint_files({**files, path: "int size\n"}, ["IDL001"]).findings
    assert [each.severity.value for each in found] == ([level] if level else [])


def test_a_namesake_of_several_packages_is_no_advice() -> None:
    files = workspace(Robot="std_msgs/Square s\n", Square="float32 side\n")
    assert not lint_files(files, ["IDL004"]).findings


def test_a_package_that_generates_messages_is_believed() -> None:
    files = {**workspace(Robot="shapes/Circle c\n"), "src/shapes/msg/Circle.msg.in": "float32 @FIELD@\n"}
    assert not lint_files(files, ["IDL004"]).findings


def test_a_service_is_no_type() -> None:
    files = {**BACKDROPS["interfaces"], "msg/Status.msg": "SetMode mode\n"}
    (finding,) = lint_files(files, ["IDL004"]).findings
    assert "`srv/SetMode`" in finding.message


def test_ros_1_packages_keep_their_own_grammar() -> None:
    files = {"package.xml": manifest("", "catkin"), "msg/old_name.msg": "Header header\ntime stampTime\n"}
    assert not lint_files(files, IDL).findings


def test_a_byte_order_mark_is_named() -> None:
    files = {**BACKDROPS["interfaces"], "msg/Status.msg": b"\xef\xbb\xbfint32 a\n"}
    (finding,) = lint_files(files, IDL).findings
    assert "byte order mark" in finding.message


def test_test_data_is_not_judged() -> None:
    files = {**BACKDROPS["interfaces"], "test/msg/Bad.msg": "int a\n", "templates/msg/X.msg": "@(type) a\n"}
    assert not lint_files(files, IDL).findings


def test_a_package_that_takes_messages_from_elsewhere_is_believed() -> None:
    cmake = "project(my_pkg)\nrosidl_generate_interfaces(${PROJECT_NAME} ${%s_MSG_FILES} msg/Status.msg)\n"
    files = {**BACKDROPS["interfaces"], "msg/Status.msg": "Circle c\n"}
    assert not lint_files({**files, "CMakeLists.txt": cmake % "shapes"}, ["IDL004"]).findings
    own = 'set(own_MSG_FILES "msg/Other.msg")\n' + cmake % "own"
    assert lint_files({**files, "CMakeLists.txt": own}, ["IDL004"]).findings


GENERATE = """\
cmake_minimum_required(VERSION 3.20)
project(my_pkg)
{before}
rosidl_generate_interfaces(${{PROJECT_NAME}}
{inside}
)
ament_package()
"""
LISTS = ["IDL005", "IDL006", "IDL007", "IDL009"]


def generated(before: str, inside: str, **messages: str) -> list[str]:
    cmake = GENERATE.format(before=before, inside=inside)
    files = {f"msg/{name}.msg": text + "\n" for name, text in messages.items()}
    found = lint_files({"package.xml": manifest("", "ament_cmake"), "CMakeLists.txt": cmake, **files}, LISTS).findings
    return [f"{finding.code} {finding.message.split(':')[0]}" for finding in found]


@pytest.mark.parametrize(
    "before, inside",
    [
        ("file(GLOB msgs RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} msg/*.msg)", "${msgs}"),
        ("set(msgs msg/A.msg msg/B.msg)", '"${msgs}"'),
        ("", "${CMAKE_CURRENT_SOURCE_DIR}:msg/A.msg msg/B.msg"),
        ("foreach(name A B)\n  list(APPEND msgs msg/${name}.msg)\nendforeach()", "${msgs}"),
        ("", "${other_MSG_FILES}"),
        ("", "msg/A.msg msg/B.msg LIBRARY_NAME x DEPENDENCIES std_msgs"),
        ("find_package(other)\nset(files msg/A.msg ${other_FILES})", "${files}"),
    ],
)
def test_lists_that_are_right_or_unknown(before: str, inside: str) -> None:
    assert generated(before, inside, A="int32 a", B="int32 b") == []


@pytest.mark.parametrize(
    "inside, messages, said",
    [
        ("msg/A.msg", {"A": "int32 a", "B": "int32 b"}, ["IDL005 `msg/B.msg` is not in `rosidl_generate_interfaces`"]),
        ("msg/A.msg msg/C.msg", {"A": "int32 a"}, ["IDL006 `msg/C.msg` does not exist"]),
        ("msg/A.msg msg/A.msg", {"A": "int32 a"}, ["IDL009 `msg/A.msg` is listed twice"]),
        ("msg/A.msg", {"A": "std_msgs/Header a"}, ["IDL007 `std_msgs` is not among the DEPENDENCIES"]),
        ("msg/A.msg DEPENDENCIES nav_msgs", {"A": "std_msgs/Header a"}, []),
        ("msg/A.msg DEPENDENCIES ${PROJECT_NAME}_x ${unknown}", {"A": "std_msgs/Header a"}, []),
    ],
)
def test_lists_that_are_wrong(inside: str, messages: dict[str, str], said: list[str]) -> None:
    found = generated("", inside, **messages)
    assert [text[: len(want)] for text, want in zip(found, said, strict=True)] == said


def test_what_a_listed_package_may_pass_on_is_left_alone() -> None:
    files = {
        "package.xml": manifest("", "ament_cmake"),
        "CMakeLists.txt": GENERATE.format(before="", inside="msg/A.msg DEPENDENCIES faraway_msgs"),
        "msg/A.msg": "std_msgs/Header a\nfaraway_msgs/B b\n",
    }
    assert lint_files(files, LISTS).findings == ()
    faraway = {"package.xml": manifest("", "ament_cmake", "faraway_msgs"), "msg/B.msg": "int32 a\n"}
    faraway["CMakeLists.txt"] = GENERATE.format(before="", inside="msg/B.msg").replace("my_pkg", "faraway_msgs")
    both = {f"a/{path}": text for path, text in files.items()} | {f"b/{path}": text for path, text in faraway.items()}
    assert [each.severity.value for each in lint_files(both, ["IDL007"]).findings] == ["error"]


def test_two_missing_dependencies_make_one_keyword() -> None:
    files = {
        "package.xml": manifest("", "ament_cmake"),
        "CMakeLists.txt": GENERATE.format(before="", inside="  msg/A.msg"),
        "msg/A.msg": "std_msgs/Header a\nunique_identifier_msgs/UUID b\n",
    }
    for _ in range(3):
        fixes = [finding.fix for finding in lint_files(files, ["IDL007"]).findings if finding.fix]
        changes, _ = apply_fixes(MemoryTree.of(files), fixes)
        files = {**files, **{path: entry.text.text for path, entry in changes.items() if entry}}
    assert files["CMakeLists.txt"].count("DEPENDENCIES") == 1
    assert "DEPENDENCIES std_msgs unique_identifier_msgs" in files["CMakeLists.txt"]


@pytest.mark.parametrize("targets, codes", [((), []), (("jazzy",), []), (("humble", "jazzy"), ["IDL007"])])
def test_services_pass_nothing_on_to_humble(targets: tuple[str, ...], codes: list[str]) -> None:
    files = {
        **{path: text for path, text in BACKDROPS["interfaces"].items() if text is not None},
        "package.xml": manifest("  <depend>builtin_interfaces</depend>\n" + INTERFACES_BODY, "ament_cmake"),
        "msg/Status.msg": "builtin_interfaces/Time stamp\n",
    }
    assert [finding.code for finding in lint_files(files, ["IDL007"], targets).findings] == codes


def test_a_huge_interface_is_skipped_and_said() -> None:
    files = {**BACKDROPS["interfaces"], "msg/Status.msg": "float32 Wrong\n" * 20_000}
    findings = lint_files(
        {path: text for path, text in files.items() if text is not None}, ["RPK007", "IDL003"]
    ).findings
    assert [(each.code, each.message) for each in findings] == [
        ("RPK007", "`msg/Status.msg` is not read: it has more than 200,000 characters")
    ]


def test_a_name_that_rosidl_refuses_is_not_listed() -> None:
    files = {"msg/Status.msg": "int32 a\n", "msg/Status_backup.msg": "int32 a\n"}
    cmake = GENERATE.format(before="", inside="msg/Status.msg")
    found = lint_files({"package.xml": manifest("", "ament_cmake"), "CMakeLists.txt": cmake, **files}, ["IDL005"])
    assert [finding.fix for finding in found.findings] == [None]


def test_lines_that_end_as_in_c_are_one_fault() -> None:
    def said(text: str) -> list[tuple[str, int]]:
        return [(each.message.partition(",")[0], len(each.related)) for each in grammar_faults(read("msg", text))]

    assert said("int32 a;\nstring b;  # the name\nint64 c;\n") == [("the lines end with `;`", 2)]
    assert said("int32 a;\nint64 c\n") == [("a line ends without `;`: one field a line", 0)]
    assert said("int32 a;\nint64 c;\nint d\n")[1][0].startswith("`int`")
