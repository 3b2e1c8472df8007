"""The schema's verdict on package.xml, and what is said when it is no."""

from __future__ import annotations

import subprocess
import sys

import pytest

from rospkg_cli.example import manifest
from rospkg_cli.package.manifest import Manifest, manifest_of
from rospkg_cli.package.schema.schema import longest_run
from rospkg_cli.package.schema.violation import ViolationKind
from rospkg_cli.source import Source

GOOD = manifest()


def read(text: str) -> Manifest:
    return manifest_of(Source("package.xml", text))


def found(text: str) -> list[tuple[str, str, str]]:
    return [(v.kind.name, v.element.tag, v.name) for v in read(text).verdict.violations]


def with_line(line: str) -> str:
    return GOOD.replace("  <export>", f"  {line}\n  <export>")


def test_a_good_one_is_valid() -> None:
    assert read(GOOD).verdict.is_valid


@pytest.mark.parametrize(
    "text, violation",
    [
        (with_line("<run_depend>x</run_depend>"), ("CHILD", "run_depend", "run_depend")),
        (with_line('<depend foo="1">x</depend>'), ("ATTRIBUTE", "depend", "foo")),
        (with_line("<depend>x<b/></depend>"), ("CHILD", "b", "b")),
        (with_line('<depend version_gte="1.2.x">x</depend>'), ("VALUE", "depend", "version_gte")),
        (with_line("<member_of_group>A B</member_of_group>"), ("VALUE", "member_of_group", "")),
        (with_line("some words"), ("TEXT", "package", "")),
        (with_line("\u3000"), ("TEXT", "package", "")),
        (with_line("<name>again</name>"), ("REPEATED", "name", "name")),
        (GOOD.replace("  <license>Apache-2.0</license>\n", ""), ("MISSING", "package", "license")),
        (GOOD.replace("Apache-2.0", " "), ("VALUE", "license", "")),
        (GOOD.replace("1.0.0", "1a0b0"), ("VALUE", "version", "")),
        (GOOD.replace(' email="ada@example.org"', ""), ("MISSING_ATTRIBUTE", "maintainer", "email")),
        (GOOD.replace("<export>", "<export>words"), ("TEXT", "export", "")),
        (GOOD.replace('format="3"', 'format="3" lang="en"'), ("ATTRIBUTE", "package", "lang")),
        (GOOD.replace("</license>", '</license>\n  <url type="home">http://a.b</url>'), ("VALUE", "url", "type")),
    ],
)
def test_one_fault_is_one_violation(text: str, violation: tuple[str, str, str]) -> None:
    assert found(text) == [violation]


@pytest.mark.parametrize(
    "line",
    [
        "<member_of_group condition=\"$ROS_DISTRO == 'jazzy'\">a_group</member_of_group>",
        "<depend condition=\"$X == '3.8'\">x</depend>",
        '<depend version_gte="1" version_lt="2.0">x</depend>',
    ],
)
def test_what_the_text_of_rep_149_allows_is_allowed(line: str) -> None:
    assert read(with_line(line)).verdict.is_valid


def test_a_wrong_order_alone_is_no_violation() -> None:
    author = "  <author>Bob</author>\n"
    verdict = read(GOOD.replace("  <license>", author + "  <license>")).verdict
    assert (verdict.is_valid, verdict.is_ordered, verdict.violations) == (False, False, ())


def test_three_faults_are_three_findings() -> None:
    text = (
        with_line("<run_depend>x</run_depend>").replace("1.0.0", "1.0").replace("  <license>Apache-2.0</license>\n", "")
    )
    assert sorted(kind for kind, _, _ in found(text)) == ["CHILD", "MISSING", "VALUE"]


def test_every_unknown_tag_is_named_and_nothing_beside() -> None:
    lines = (
        "<run_depend>a</run_depend>\n<!-- x --><depend>b</depend><run_depend>c</run_depend><bogus/><depend>d</depend>"
    )
    assert [name for _, _, name in found(with_line(lines))] == ["run_depend", "run_depend", "bogus"]


def test_order_and_violation_are_told_apart() -> None:
    text = with_line("<depend>x</depend>\n<bogus/>\n<author>Bob</author>")
    verdict = read(text).verdict
    assert not verdict.is_ordered
    assert [(v.kind, v.name) for v in verdict.violations] == [(ViolationKind.CHILD, "bogus")]


@pytest.mark.parametrize(
    "attribute, asked",
    [('format="1"', 1), ('format="2"', 2), ('format="3"', 3), ('format="4"', 3), ('format="x"', 3), ("", 1)],
)
def test_the_schema_is_that_of_the_format(attribute: str, asked: int) -> None:
    assert read(GOOD.replace('format="3"', attribute)).schema_format == asked


def test_without_a_format_newer_tags_tell_it() -> None:
    assert read(with_line("<exec_depend>x</exec_depend>").replace(' format="3"', "")).schema_format == 3


def test_a_clean_package_is_linted_without_xmlschema() -> None:
    program = (
        "import sys; from rospkg_cli.example import BACKDROPS; from rospkg_cli.testing import lint_files\n"
        "found = lint_files({p: t for p, t in BACKDROPS['ament_python'].items() if t is not None})\n"
        "assert not found.findings, found.findings\n"
        "print('xmlschema' in sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout == "False\n"


def test_the_longest_run_never_falls() -> None:
    assert longest_run([0, 1, 2, 3, 6, 4, 7, 7]) == {0, 1, 2, 3, 5, 6, 7}
    assert longest_run([]) == set()
