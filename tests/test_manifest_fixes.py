"""Fixes of package.xml: never ill-formed, never without an end, in the file's own hand."""

from __future__ import annotations

import re

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rospkg_cli.edits.manifest import add_dependencies, add_dependency, add_element, add_export, remove_element
from rospkg_cli.edits.manifest_format import to_format_3
from rospkg_cli.edits.manifest_tags import remove_attribute, rename_tag, set_attribute, set_text
from rospkg_cli.engine.fixing.apply import edited
from rospkg_cli.engine.fixing.fix import fix_all
from rospkg_cli.engine.run.scope import Scope
from rospkg_cli.engine.run.session import Session
from rospkg_cli.example import manifest
from rospkg_cli.finding import Edit, Safety
from rospkg_cli.package.manifest import Manifest, manifest_of
from rospkg_cli.rule import all_rules
from rospkg_cli.source import Source
from rospkg_cli.tree import MemoryTree, TreeEntry

XML = frozenset(rule.code for rule in all_rules() if rule.family == "XML")
LINES = """
<name>my_pkg</name>
<name>My__Pkg</name>
<version>1.0.0</version>
<version>1.0</version>
<version/>
<description>It drives</description>
<description/>
<maintainer email="a@b.org">A</maintainer>
<maintainer>A</maintainer>
<license>MIT</license>
<license>Apache 2.0</license>
<license>GPLv3</license>
<license file="L">MIT</license>
<url type="home">http://a.b</url>
<url type="blog" >http://a.b</url>
<author>B</author>
<depend>rclcpp</depend>
<depend>rclcpp</depend>
<build_depend>rclcpp</build_depend>
<exec_depend>rclcpp</exec_depend>
<exec_depend >b</exec_depend >
<exec_depend>a</exec_depend>
<exec_depend condition="$ROS_VERSION == 2">b</exec_depend>
<depend/>
<depend>my_pkg</depend>
<depend>a</depend><depend>a</depend> <!-- twice -->
<run_depend>rclcpp</run_depend>
<run_depend condition='$A == 1'>x</run_depend>
<test_depend></test_depend>
<buildtool_depend>ament_python</buildtool_depend>
<member_of_group>g</member_of_group>
<group_depend>g</group_depend>
<bogus/>
words
<!-- why -->
<export/>
<export><build_type>ament_pyton</build_type></export>
<export><a/><!-- b --></export>
""".split("\n")
HEADS = """
<?xml version="1.0"?>
<?xml version="1.0"?><?xml-model href="http://x/package_format2.xsd"?>
<!-- x -->
""".split("\n")
PACKAGES = """<package>
<package format="1">
<package format='2'>
<package  format="3" >
<package format="9">""".split("\n")
FILES = st.sampled_from([{}, {"setup.py": ""}, {"CMakeLists.txt": "project(my_pkg)\nament_package()\n"}])


@settings(max_examples=80, deadline=None)
@given(
    st.sampled_from(HEADS),
    st.sampled_from(PACKAGES),
    st.lists(st.sampled_from(LINES), max_size=12),
    FILES,
    st.sampled_from(["\n  ", "\n\t", "", " "]),
)
def test_repair_keeps_a_manifest_readable_and_comes_to_an_end(
    head: str, package: str, lines: list[str], files: dict[str, str], between: str
) -> None:
    """A comment goes with the element right below it alone."""
    text = head + ("\n" if head else "") + package + "".join(between + line for line in lines) + "\n</package>\n"
    tree = MemoryTree.of({"package.xml": text, **files})
    session = Session(tree, Scope(("",), frozenset({""}), "my_pkg"), XML)
    outcome = fix_all(session, (Safety.SAFE, Safety.UNSAFE))
    assert outcome.refused == []
    entry = outcome.changes.get("package.xml")
    after = entry.text.text if entry else text
    before, now = (manifest_of(Source("package.xml", each)) for each in (text, after))
    lost = [each.text for each in before.document.comments if each.text not in after]
    assert [each for each in lost if re.search(f"<!--{re.escape(each)}-->\\s*<(?!!)", text) is None] == []
    left = [f for f in outcome.results.findings if f.fix]
    assert left == [], "a fix that was applied is offered again"
    assert now.name == before.name


def read(text: str) -> Manifest:
    return manifest_of(Source("package.xml", text))


def apply(text: str, *edits: Edit) -> str:
    return edited(TreeEntry("file", text.encode()), edits).text.text


@pytest.mark.parametrize(
    "before, name, after",
    [
        ("<depend>a</depend>\n<depend>c</depend>", "b", "<depend>a</depend>\n<depend>b</depend>\n<depend>c</depend>"),
        (
            "<depend>a</depend> <!-- x -->\n<export/>",
            "b",
            "<depend>a</depend> <!-- x -->\n<depend>b</depend>\n<export/>",
        ),
        ("<depend>c</depend>\n<depend>a</depend>", "b", "<depend>c</depend>\n<depend>a</depend>\n<depend>b</depend>"),
        ("<license>L</license>\n\n<export/>", "b", "<license>L</license>\n<depend>b</depend>\n\n<export/>"),
        ("<depend>b</depend>", "a", "<depend>a</depend>\n<depend>b</depend>"),
        ("<exec_depend>b</exec_depend>", "a", "<depend>a</depend>\n<exec_depend>b</exec_depend>"),
    ],
)
def test_a_dependency_is_put_where_a_person_would(before: str, name: str, after: str) -> None:
    text, want = (
        f"<package>\n  {each}\n</package>\n".replace("\n<", "\n  <").replace("  </pa", "</pa")
        for each in (before, after)
    )
    assert apply(text, add_dependency(read(text), "depend", name)) == want


def test_what_comes_to_one_place_is_put_in_order_and_once() -> None:
    text = "<package>\n  <name>a</name>\n</package>\n"
    found = read(text)
    group = add_element(found, "member_of_group", "<member_of_group>g</member_of_group>")
    several = add_dependencies(found, [("exec_depend", "d"), ("exec_depend", "b"), ("depend", "z")])
    single = [add_dependency(found, "exec_depend", name) for name in ("c", "b", "a")]
    after = [f"<exec_depend>{name}</exec_depend>" for name in "abcd"]
    lines = ["<depend>z</depend>", *after, "<member_of_group>g</member_of_group>"]
    new = "".join(f"\n  {line}" for line in lines)
    assert apply(text, group, *several, *single) == text.replace("</name>", f"</name>{new}")


def test_what_only_ros_2_has_gets_the_condition_of_its_like() -> None:
    for_1, for_2 = ("<depend condition='$ROS_VERSION == \"{}\"'>{}</depend>".format(*each) for each in ("1a", "2b"))
    text = f'<package format="3">\n  {for_1}\n  {for_2}\n</package>\n'
    added = [add_dependency(read(text), "depend", name) for name in ("eigen", "rclcpp_action", "std_msgs")]
    new = f"<depend>eigen</depend>\n  {for_2.replace('>b', '>rclcpp_action')}\n  <depend>std_msgs</depend>"
    assert apply(text, *added) == text.replace(for_2, f"{for_2}\n  {new}")
    other = text.replace('"2"', "3")
    assert "\n  <depend>rclcpp</depend>" in apply(other, add_dependency(read(other), "depend", "rclcpp"))


def test_blanks_behind_an_element_stay_where_they_are() -> None:
    text = "<package>\n  <depend>a</depend> \t\n</package>\n"
    assert apply(text, add_dependency(read(text), "depend", "b")) == text.replace("\t\n", "\t\n  <depend>b</depend>\n")


def test_an_element_goes_into_an_empty_package() -> None:
    text = "<package>\n</package>\n"
    assert apply(text, add_element(read(text), "name", "<name>a</name>")) == "<package>\n  <name>a</name>\n</package>\n"


@pytest.mark.parametrize(
    "before, after",
    [
        ("  <name>a</name>", "  <name>a</name>\n  <export>\n    <x/>\n  </export>"),
        ("  <export/>", "  <export>\n    <x/>\n  </export>"),
        ("  <export></export>", "  <export>\n    <x/>\n  </export>"),
        ("  <export>\n     <a/> <!-- b -->\n  </export>", "  <export>\n     <a/> <!-- b -->\n     <x/>\n  </export>"),
        ("\t<export>\n\t\t<a/>\n\t</export>", "\t<export>\n\t\t<a/>\n\t\t<x/>\n\t</export>"),
    ],
)
def test_an_export_is_made_or_extended(before: str, after: str) -> None:
    text = f"<package>\n{before}\n</package>\n"
    assert apply(text, add_export(read(text), "<x/>")) == f"<package>\n{after}\n</package>\n"


def test_attributes_texts_and_names_are_changed_in_place() -> None:
    text = "<package  format = '2' >\n  <url type='a'  >x</url>\n  <depend />\n  <depend >b</depend >\n</package>"
    manifest = read(text)
    url, empty, full = manifest.root.children
    edits = [
        set_attribute(manifest, manifest.root, "format", "3"),
        remove_attribute(manifest, url, "type"),
        set_text(manifest, url, "a & b"),
        *rename_tag(manifest, full, "exec_depend"),
        set_text(manifest, empty, "c"),
    ]
    assert apply(text, *edits) == (
        "<package  format = '3' >\n  <url  >a &amp; b</url>\n  <depend>c</depend>\n"
        "  <exec_depend >b</exec_depend >\n</package>"
    )
    condition = set_attribute(manifest, full, "condition", 'a < "b"')
    assert "<depend condition='a &lt; \"b\"' >b" in apply(text, condition)


def test_an_element_goes_with_its_line_or_alone() -> None:
    text = "<package>\n  <depend>a</depend>\n  <depend>b</depend> <depend>c</depend>\n</package>\n"
    first, second, _ = read(text).root.children
    assert apply(text, remove_element(read(text), first)) == text.replace("  <depend>a</depend>\n", "")
    assert apply(text, remove_element(read(text), second)) == text.replace("<depend>b</depend>", "")


@pytest.mark.parametrize(
    ("above", "behind", "goes"),
    [
        ("<!-- to build -->", "\n", True),
        ("<!-- to build -->", "", True),
        ("<!-- to build -->", "  <depend>b</depend>\n", False),
        ("<!-- <depend>c</depend> -->", "\n", False),
        ("<!-- of\n  two -->", "\n", False),
        ("<!-- apart -->\n", "\n", False),
        ("<name>a</name> <!-- of another -->", "\n", False),
    ],
)
def test_the_comment_of_an_element_alone_goes_with_it(above: str, behind: str, goes: bool) -> None:
    text = f"<package>\n  <version>1</version>\n  {above}\n  <depend>a</depend>\n{behind}</package>\n"
    found = read(text)
    element = next(each for each in found.root.children if each.tag == "depend")
    done = apply(text, remove_element(found, element))
    assert "<depend>a" not in done
    assert ("<!--" not in done) is goes


def test_one_blank_line_is_left_where_an_element_was_alone_between_two() -> None:
    text = "<package>\n  <name>a</name>\n\n  <depend>a</depend>\n  \n  <export/>\n</package>\n"
    assert apply(text, remove_element(read(text), read(text).root.children[1])) == text.replace(
        "  <depend>a</depend>\n  \n", ""
    )
    below = text.replace("</name>\n\n", "</name>\n")
    assert apply(below, remove_element(read(below), read(below).root.children[1])) == below.replace(
        "  <depend>a</depend>\n", ""
    )


def test_format_1_becomes_format_3() -> None:
    text = (
        '<?xml version="1.0"?>\n<?xml-model href="http://download.ros.org/schema/package_format1.xsd"?>\n<package>\n'
        "  <build_depend>a</build_depend>\n  <run_depend>a</run_depend>\n  <run_depend version_gte='1'>b</run_depend>\n"
        "</package>\n"
    )
    assert apply(text, *to_format_3(read(text))) == (
        '<?xml version="1.0"?>\n<?xml-model href="http://download.ros.org/schema/package_format3.xsd"?>\n'
        "<package format=\"3\">\n  <depend>a</depend>\n  <build_export_depend version_gte='1'>b</build_export_depend>\n"
        "  <exec_depend version_gte='1'>b</exec_depend>\n</package>\n"
    )


def test_a_fix_keeps_encoding_and_line_ends() -> None:
    head = '<?xml version="1.0" encoding="ISO-8859-1"?>\n'
    text = head + manifest("  <depend/>\n").partition("\n")[2].replace("Ada", "Zoë")
    data = text.replace("\n", "\r\n").encode("latin-1")
    session = Session(
        MemoryTree.of({"package.xml": data}), Scope(("",), frozenset({""}), "my_pkg"), frozenset({"XML210"})
    )
    outcome = fix_all(session, (Safety.SAFE,))
    after = outcome.changes["package.xml"]
    assert after is not None
    assert after.data == data.replace(b"  <depend/>\r\n", b"")


def test_a_run_depend_that_format_2_does_not_know_is_left_to_its_author() -> None:
    text = '<package format="2">\n  <run_depend>a</run_depend>\n</package>\n'
    assert apply(text, *to_format_3(read(text))) == text.replace('"2"', '"3"')
