"""Our expansion of xacro, against names worked out by hand; and against xacro itself, where it is installed."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import pytest

from rospkg_cli.files import PackageFiles
from rospkg_cli.package.urdf.expansion.expander import MAX_NODES, Expander
from rospkg_cli.package.urdf.expansion.library import XacroLibrary
from rospkg_cli.package.urdf.expansion.macros import MacroParameter, parameters_of
from rospkg_cli.package.urdf.expansion.values import XacroUnknown, shown, truth
from rospkg_cli.package.workspace import Workspace
from rospkg_cli.tree import MemoryTree

HEAD = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="r">'
CASES = {
    '<xacro:property name="n" value="3"/><link name="a${n + 1}"/><link name="${n / 2}"/><link name="${-n}"/>': (
        ["a4", "1.5", "-3"]
    ),
    '<xacro:property name="b" value="${a}x"/><xacro:property name="a" value="y"/><link name="${b}"/>': ["yx"],
    '<xacro:property name="a" value="1"/><xacro:property name="b" value="${a}" lazy_eval="false"/>'
    '<xacro:property name="a" value="2"/><link name="l${b}"/>': ["l1"],
    '<xacro:property name="a" default="1"/><xacro:property name="a" default="2"/><link name="l${a}"/>': ["l1"],
    '<xacro:macro name="m" params="p q:=z r:=^|w"><link name="${p}${q}${r}"/></xacro:macro>'
    '<xacro:m p="a"/><xacro:property name="r" value="v"/><xacro:m p="b" q="c"/>': ["azw", "bcv"],
    '<xacro:macro name="m" params="p"><xacro:property name="k" value="in" scope="global"/></xacro:macro>'
    '<xacro:m p="1"/><link name="${k}"/>': ["in"],
    '<xacro:macro name="m" params="p"><xacro:property name="k" value="${p}" scope="parent"/></xacro:macro>'
    '<xacro:m p="up"/><link name="${k}"/>': ["up"],
    '<xacro:macro name="m" params="*one **more"><xacro:insert_block name="one"/><xacro:insert_block name="more"/>'
    '</xacro:macro><xacro:m><link name="a"/><group><link name="b"/><link name="c"/></group></xacro:m>': (
        ["a", "b", "c"]
    ),
    '<xacro:property name="x"><link name="p"/></xacro:property><xacro:insert_block name="x"/>': ["p"],
    '<xacro:if value="${1 > 2}"><link name="a"/></xacro:if>'
    '<xacro:unless value="false"><link name="b"/></xacro:unless>': (["b"]),
    '<xacro:property name="s" value="left"/>'
    "<xacro:if value=\"${s == 'left'}\"><link name=\"${s + '_x'}\"/></xacro:if>": (["left_x"]),
    '<xacro:if value="${not True or 2 in [1]}"><link name="a"/></xacro:if><link name="${min(2, 3)}"/>': ["2"],
    '<xacro:property name="q" value="\'7\'"/><link name="${q * 2 if 1 else 0}"/>': ["14"],
    '<link name="$${x}"/><link name="${round(pi, 2)}"/><link name="${int(sqrt(16))}"/>': ["${x}", "3.14", "4"],
    '<xacro:macro name="n" params="d"><link name="l${d}"/><xacro:if value="${d > 1}"><xacro:n d="${d - 1}"/></xacro:if>'
    '</xacro:macro><xacro:n d="3"/>': ["l3", "l2", "l1"],
    '<xacro:property name="u" value="1_0"/><link name="${u}"/>'
    '<xacro:property name="t" value="true"/><link name="${t}"/>': (["1_0", "True"]),
}
UNKNOWN_HERE = frozenset({'<xacro:if value="${not True or 2 in [1]}">'})
"""Beginnings of cases with expressions that are left unknown."""


def expanded(body: str, **more: str) -> Expander:
    files = {"urdf/r.xacro": f"{HEAD}{body}</robot>", **more}
    library = XacroLibrary(PackageFiles(MemoryTree.of(files)), "my_pkg", Workspace())
    document = library.read("urdf/r.xacro")
    assert document is not None
    expander = Expander(library)
    expander.run(document)
    return expander


def links(expander: Expander) -> list[str]:
    return [shown(node.attributes["name"].value) for node in expander.found.children if node.tag == "link"]


@pytest.mark.parametrize("body", CASES)
def test_the_links_of_a_robot(body: str) -> None:
    expander = expanded(body)
    assert expander.found.problems == []
    if not body.startswith(tuple(UNKNOWN_HERE)):
        assert links(expander) == CASES[body]
        assert not expander.found.is_open


@pytest.mark.parametrize("body", CASES)
def test_xacro_itself_makes_the_same_links(body: str, tmp_path: Path) -> None:
    xacro = pytest.importorskip("xacro")
    path = tmp_path / "r.xacro"
    path.write_text(f"{HEAD}{body}</robot>", encoding="utf-8")
    root = xacro.process_file(str(path)).documentElement
    assert [link.getAttribute("name") for link in root.getElementsByTagName("link")] == CASES[body]


def test_what_comes_from_outside_is_compared_as_it_is_written() -> None:
    text = '<xacro:macro name="m" params="p"><link name="${p}a"/><link name="${p + \'b\'}"/></xacro:macro>'
    robot = expanded(f'<xacro:arg name="x" default=""/>{text}<xacro:m p="$(arg x)"/><xacro:m p="${{2 ** f}}"/>')
    assert links(robot)[:2] == ["$(arg x)a", "$(arg x)b"]
    assert [problem.name for problem in robot.found.problems] == ["f"]
    again = expanded(
        f'{text}<xacro:property name="f" value="$(arg x)"/><xacro:m p="${{2 * f}}"/><xacro:m p="${{2 * f}}"/>'
    )
    assert links(again)[0] == links(again)[2]


def test_included_files_are_read_in_their_place() -> None:
    part = f'{HEAD}<xacro:property name="k" value="v"/><link name="in"/><xacro:include filename="c.xacro"/></robot>'
    more = {"urdf/b.xacro": part, "urdf/c.xacro": f'{HEAD}<link name="inner"/></robot>'}
    robot = expanded('<link name="a"/><xacro:include filename="b.xacro"/><link name="${k}"/>', **more)
    assert links(robot) == ["a", "in", "inner", "v"]
    assert robot.found.reached == {"urdf/r.xacro", "urdf/b.xacro", "urdf/c.xacro"}
    found = expanded('<xacro:include filename="$(find my_pkg)/urdf/b.xacro"/>', **more)
    assert links(found) == ["in", "inner"]
    moved = expanded('<xacro:include filename="$(find my_pkg)/b.xacro"/>', **more)
    assert links(moved) == ["in", "inner"]


@pytest.mark.parametrize(
    "body",
    [
        '<xacro:include filename="$(find other)/b.xacro"/>',
        '<xacro:include filename="*.xacro"/>',
        '<xacro:include filename="/opt/b.xacro"/>',
        '<xacro:include filename="file:///opt/b.xacro"/>',
        '<xacro:include filename="r.xacro" ns="n"/>',
        '<xacro:include filename="$(arg x)"/>',
        "<xacro:include/>",
        '<xacro:call macro="m"/>',
        '<xacro:element xacro:name="link"/>',
        '<xacro:n.m/>',
        '<xacro:property value="1"/>',
        '<xacro:insert_block name="${x}"/>',
        '<xacro:include filename="r.xacro"/>',
        '<xacro:macro name="m" params=""><xacro:m/></xacro:macro><xacro:m/>',
    ],
)  # fmt: skip
def test_what_may_add_anything_leaves_the_robot_open(body: str) -> None:
    assert expanded(body).found.is_open


def test_macros_that_double_each_time_end() -> None:
    names = [f"m{number}" for number in range(40)]
    macros = "".join(
        f'<xacro:macro name="{a}" params=""><xacro:{b}/><xacro:{b}/></xacro:macro>' for a, b in pairwise(names)
    )
    robot = expanded(f'<xacro:macro name="m39" params=""><link name="x"/></xacro:macro>{macros}<xacro:m0/>')
    assert robot.found.is_open
    assert robot.nodes > MAX_NODES


def test_the_parameters_of_a_macro() -> None:
    assert parameters_of("a b:=1 c='x y' d:=^ e:=^|${f g} *h **i j:=") == (
        MacroParameter("a"), MacroParameter("b", "1"), MacroParameter("c", "'x y'"), MacroParameter("d", None, True),
        MacroParameter("e", "${f g}", True), MacroParameter("*h"), MacroParameter("**i"), MacroParameter("j"),
    )  # fmt: skip
    assert parameters_of("  ") == ()


@pytest.mark.parametrize(
    "value, verdict",
    [("true", True), ("True", True), ("1", True), ("0", False), ("false", False), ("1.0", None), ("yes", None),
     ("", None), (2, True), (0.0, False), (True, True), (XacroUnknown("x"), None)],
)  # fmt: skip
def test_what_a_condition_is(value: str | int | float | XacroUnknown, verdict: bool | None) -> None:
    assert truth(value) is verdict
