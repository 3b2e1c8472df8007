"""Parameter files, judged as rcl judges them: every verdict below is that of the real rcl_yaml_param_parser."""

from __future__ import annotations

import pytest

from rospkg_cli.checks.fault import Fault
from rospkg_cli.checks.params.ambiguous_numbers import canonical, number_faults
from rospkg_cli.checks.params.rcl_validation import rcl_faults
from rospkg_cli.checks.params.ros_parameters_key import key_faults
from rospkg_cli.example import BACKDROPS, existing_files, manifest
from rospkg_cli.languages.yaml.nodes import ScalarNode, documents
from rospkg_cli.package.params.parameter_file import ParameterFile
from rospkg_cli.package.params.scalar_types import type_of, yaml_type
from rospkg_cli.source import Source, Span
from rospkg_cli.testing import lint_files
from rospkg_cli.unreadable import UnreadableError

BLOCK = "n:\n  ros__parameters:\n"

BODY = ":\n  ros__parameters:\n    a: 1\n"

TAKEN = [
    BLOCK + "    a: &x 1\n", BLOCK + '    a: ""\n', BLOCK + "    b: {}\n", BLOCK + "    a: [1e-9, 1.0]\n",
    BLOCK + "    a: [true, yes, n]\n", BLOCK + "    a: [.nan, 1.0, nan]\n", BLOCK + "    a: !!str 1\n",
    BLOCK + "    a:\n      - b: [1, 2]\n", BLOCK + "    <<: {a: 1}\n", "n:\n  ros__parameters: {}\n",
    "n: {ros__parameters: {a: 1, b: {c: 2}}}\n", "x: {}\n" + BLOCK + "    a: 1\n",
    "ns:\n  n:\n    ros__parameters:\n      a: 1\n", "/ns/:\n  n:\n    ros__parameters:\n      a: 1\n",
    BLOCK + "    a: 1\n---\nm:\n  ros__parameters:\n    a: 1\n",
    BLOCK + "    a: 1\nn:\n  ros__parameters:\n    a: 2\n", "n:\n  'ros__parameters':\n    a: 1\n",
    *(name + BODY for name in ("n", "/**", "/**/n", '"*"', "ns/n")),
]  # fmt: skip

REFUSED = [
    "n:\n  ros_parameters:\n    a: 1\n", "n:\n  ros__parameter:\n    a: 1\n", "ros__parameters:\n  a: 1\n",
    "n:\n  x: 1\n  ros__parameters:\n    a: 1\n", BLOCK + "    a: 1\n  x: 1\n", "x: 1\n" + BLOCK + "    a: 1\n",
    "x:\n" + BLOCK + "    a: 1\n", BLOCK, "n:\n  ros__parameters: 5\n", BLOCK + "    a:\n", BLOCK + "    a: |\n",
    BLOCK + "    a: &x 1\n    b: *x\n", BLOCK + "    a: [1, 2.0]\n", BLOCK + "    a: [1, x]\n",
    BLOCK + '    a: ["1", 2]\n', BLOCK + "    a: [x, y, z]\n", BLOCK + "    a:\n    -\n    - 1\n",
    BLOCK + '    "": 1\n', BLOCK + "    a: [[1, 2], [3, 4]]\n    d: 5\n",
    BLOCK + "    a:\n    - b: 1\n      c: x\n    d: 5\n", BLOCK + "    a: {}\n    b: 1\n",
    "/1a/b:\n  ros__parameters:\n    b: 1\n", "/ns:\n  /n:\n    ros__parameters:\n      a: 1\n",
    "n" * 300 + BODY,
    BLOCK + "    a: 1\n  ros__parameters:\n    b: 2\n", BLOCK + "    a: 1\n  m:\n    ros__parameters:\n      b: 1\n",
    "m: *a\n" + BLOCK + "    a: 1\n", BLOCK + "    ? [a]\n    : 1\n",
    *(name + BODY for name in ("my-node", "1n", "a.b", "/a*", "//n", "ns/", "/")),
]  # fmt: skip


def read(text: str) -> ParameterFile:
    source = Source("config/robot.yaml", text)
    return ParameterFile(source, tuple(documents(source)))


def faults(text: str) -> list[Fault]:
    return [*key_faults(read(text)), *rcl_faults(read(text))]


@pytest.mark.parametrize("text", TAKEN)
def test_what_rcl_takes(text: str) -> None:
    assert not faults(text)


@pytest.mark.parametrize("text", REFUSED)
def test_what_rcl_refuses(text: str) -> None:
    assert faults(text)


def test_an_empty_list_has_no_type() -> None:
    """rcl takes it, and rclcpp stops at it."""
    (fault,) = faults(BLOCK + "    a: []\n")
    assert "No parameter value set" in fault.message


@pytest.mark.parametrize(
    "text, rcl, yaml",
    [
        ("1", "int", "int"), ("1e-9", "double", "string"), ("1.0e9", "double", "string"), ("010", "int", "int"),
        ("08", "double", "string"), ("0x1F", "int", "int"), ("1.", "double", "double"), (".5", "double", "double"),
        ("1_000", "string", "int"), ("1e400", "string", "string"), ("99999999999999999999", "double", "int"),
        ("nan", "double", "string"), (".nan", "double", "double"), ("-.inf", "double", "double"),
        ("1:30", "string", "int"), ("0b11", "string", "int"), ("x", "string", "string"), ("1.2.3", "string", "string"),
    ],
)  # fmt: skip
def test_types_of_scalars(text: str, rcl: str, yaml: str) -> None:
    assert type_of(ScalarNode(text, Span(0, 0), True)) == rcl
    assert yaml_type(text) == yaml


@pytest.mark.parametrize("text", ["y", "Y", "yes", "on", "True", "n", "No", "OFF"])
def test_bools(text: str) -> None:
    assert type_of(ScalarNode(text, Span(0, 0), True)) == "bool"
    assert type_of(ScalarNode(text, Span(0, 0), False, is_quoted=True)) == "string"


@pytest.mark.parametrize(
    "text, better", [("1e-9", "1.0e-9"), ("5.E3", "5.0e+3"), (".5e3", "0.5e+3"), ("-inf", "-.inf"), ("08", None)]
)
def test_a_number_that_everybody_reads(text: str, better: str | None) -> None:
    assert canonical(text) == better
    if better:
        assert yaml_type(better) == "double"
        assert type_of(ScalarNode(better, Span(0, 0), True)) == "double"


def test_a_list_of_numbers_is_one_finding_that_repairs_all() -> None:
    (found,) = number_faults(read(BLOCK + "    noise: [1e-9, 0.0, 1e-9]\n"), is_read_by_python=False)
    assert found.repair is not None
    assert [text for _, text in found.repair.edits] == ["1.0e-9", "1.0e-9"]


def test_names_of_parameters_and_places() -> None:
    file = read("# é\nns:\n  n:\n    ros__parameters:\n      a:\n        b.c: [1, 2]\n      'd': x\n")
    (block,) = file.blocks
    assert block.name == "ns/n"
    assert [(p.name, file.source.slice(p.key.span)) for p in block.parameters] == [("a.b.c", "b.c"), ("d", "'d'")]


def test_yaml_that_is_none_is_told_with_its_place() -> None:
    with pytest.raises(UnreadableError) as error:
        read(BLOCK + "    a: [1\n    b: 2\n")
    assert error.value.unreadable.span.start > 20


def test_depth_is_bounded() -> None:
    with pytest.raises(UnreadableError, match="YAML_DEPTH"):
        read("n: " + "{a: " * 500 + "1" + "}" * 500)


@pytest.mark.parametrize(
    "path, text",
    [
        ("config/other.yaml", "robot:\n  wheels: 4\n"),
        ("test/params.yaml", "n:\n  ros_parameters: {}\n"),
        ("config/template.yaml", "{{ name }}:\n  ros__parameters:\n    a: [1, 2.0]\n"),
        ("config/comment.yaml", "# no ros__parameters: here\na: [1, x]\n"),
    ],
)
def test_other_yaml_is_left_alone(path: str, text: str) -> None:
    assert not lint_files({**BACKDROPS["config"], path: text}, ["PRM001", "PRM004", "RPK001"]).findings


def test_names_that_launch_fills_in_are_left_alone() -> None:
    assert not faults("$(var name)_node:\n  ros__parameters:\n    a: [1.0, $(var x)]\n")


@pytest.mark.parametrize("text", [BLOCK + "    a: [1\n", "robot:\n  ros__parameters\n    rate: 5\n    name: a\n"])
def test_broken_yaml_with_parameters_is_unreadable(text: str) -> None:
    files = {**BACKDROPS["config"], "config/robot.yaml": text}
    assert [finding.code for finding in lint_files(files, ["RPK001", "PRM004"]).findings] == ["RPK001"]


@pytest.mark.parametrize(
    "text, says",
    [
        ("1e-9", "a string for PyYAML, which launch files read it with: write `1.0e-9`"),
        ("089", "`089` is not a whole number, because of the zero before it: write `89`"),
        ("-089", "`-089` is not a whole number, because of the zero before it: write `-89`"),
        ("+010", "`+010` is octal, that is 8, because of the zero before it: write `10`"),
        ("010", "`010` is octal, that is 8, because of the zero before it: write `10`"),
        ("1_000", "is a string for rcl, and a number for PyYAML: write `1000`"),
        ("089.5", ""),
        ("0", ""),
    ],
)
def test_numbers_that_two_readers_take_differently(text: str, says: str) -> None:
    found = [each.message for each in number_faults(read(f"{BLOCK}    a: {text}\n"), is_read_by_python=False)]
    assert (says in found[0]) if says else not found


def test_a_name_that_a_program_fills_in_is_left_alone() -> None:
    texts = {"config/a.yaml": "<ROS_NAMESPACE>/talker:\n  ros__parameters:\n    a: 1\n"}
    assert not lint_files({**BACKDROPS["config"], **texts}, ["PRM004"]).findings
    assert not lint_files(
        {**BACKDROPS["config"], "config/a.yaml": "a<b>/talker:\n  ros__parameters: {}\n"}, ["PRM004"]
    ).findings
    texts = {"config/a.yaml": "a-b/talker:\n  ros__parameters:\n    a: 1\n"}
    assert len(lint_files({**BACKDROPS["config"], **texts}, ["PRM004"]).findings) == 1


@pytest.mark.parametrize(
    ("first", "second", "level"),
    [
        ('["GridBased"]', "[GridBased]", "info"),
        ("'map'", '"map"', "info"),
        ("5", "'5'", "warning"),
        ("[a]", "[a, b]", "warning"),
    ],
)
def test_one_value_that_is_written_twice(first: str, second: str, level: str) -> None:
    text = f"talker:\n  ros__parameters:\n    a: {first}\n    a: {second}\n"
    (found,) = lint_files({"package.xml": manifest(), "config/a.yaml": text}, ["PRM002"]).findings
    assert found.severity.value == level


@pytest.mark.parametrize(
    ("nodes", "count"),
    [
        (("joy_teleop/joy_teleop",), 0),
        (("listener/listen",), 0),
        (("native/listen.py", "demo_nodes_py/listener"), 0),
        (("native/listen",), 1),
        (("joy_teleop/joy_teleop", "native/listen"), 1),
        (("unknown/listen",), 1),
        (("$(var name)/listen",), 1),
        ((), 1),
    ],
)
def test_an_empty_list_for_nodes_in_python(nodes: tuple[str, ...], count: int) -> None:
    path = '<param from="$(find-pkg-share my_pkg)/config/a.yaml"/>'
    lines = [f'<node pkg="{p}" exec="{e}">{path}</node>' for p, _, e in (each.partition("/") for each in nodes)]
    files = {
        **{f"my_pkg/{name}": text for name, text in existing_files(BACKDROPS["config"]).items()},
        "my_pkg/config/a.yaml": "a:\n  ros__parameters:\n    buttons: []\n",
        "my_pkg/launch/a.launch.xml": f"<launch>{''.join(lines)}</launch>\n",
        "listener/package.xml": manifest("", "ament_python", "listener"),
        "listener/setup.py": "",
        "native/package.xml": manifest("", "ament_cmake", "native"),
    }
    assert len(lint_files(files, ["PRM004"]).findings) == count
    files["my_pkg/config/a.yaml"] = files["my_pkg/config/a.yaml"].replace("a:", "joy_teleop:", 1)
    assert len(lint_files(files, ["PRM004"]).findings) == (count if nodes else 0)
