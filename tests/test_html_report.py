"""The HTML report, read as a browser reads it: it loads nothing, text stays text, filters find what they name."""

from __future__ import annotations

import base64
import hashlib
import io
import re
from pathlib import Path

import pytest
from lxml import html

from rospkg_cli.engine.run.results import Results
from rospkg_cli.finding import Chmod, Create, Delete, Edit, Finding, Fix, Location, Move, Severity
from rospkg_cli.light_dataclasses import replace
from rospkg_cli.report import Report, render
from rospkg_cli.source import Span

NASTY = "</pre><script>alert(1)</script>\" onload='x' `<b>` &amp; \x1b[31m"
PLACE = Location("a/package.xml", Span(2, 6), 1, 3, 1, 7)
FINDING = Finding("XML104", "placeholder-text", Severity.WARNING, "`TODO` is left", PLACE, "a", "x\tTODO y")


def page(*findings: Finding) -> html.HtmlElement:
    return html.document_fromstring(rendered(*findings))


def rendered(*findings: Finding) -> str:
    stream = io.StringIO()
    render("html", Report(Results(findings, packages=1, files=2), Path("/ws"), Path("/ws")), stream)
    return stream.getvalue()


def fix_shown(**changes) -> str:
    (shown,) = page(replace(FINDING, **changes)).xpath("//details/pre")
    return shown.text_content()


def test_it_loads_nothing_and_runs_only_its_own_script() -> None:
    found = page(FINDING)
    assert not found.xpath("//@src | //link | //iframe | //@onclick | //@style")
    (policy,) = found.xpath("//meta[@http-equiv='Content-Security-Policy']/@content")
    for tag in ("script", "style"):
        (code,) = found.xpath(f"//{tag}/text()")
        digest = base64.b64encode(hashlib.sha256(code.encode()).digest()).decode()
        assert f"{tag}-src 'sha256-{digest}'" in policy
    assert policy.startswith("default-src 'none';")


def test_text_stays_text() -> None:
    fix = Fix(NASTY, (Create(NASTY, NASTY),))
    nasty = replace(FINDING, code=NASTY, name=NASTY, message=NASTY, package=NASTY, excerpt=NASTY, fix=fix)
    nasty = replace(nasty, location=replace(PLACE, path=NASTY), related=((PLACE, NASTY),))
    found = page(nasty)
    assert len(found.xpath("//script")) == 1
    assert not found.xpath("//b | //@onload")
    assert "\x1b" not in rendered(nasty)
    assert "<script>alert(1)</script>" in found.xpath("//article/h3")[0].text_content()


def test_filters_name_what_the_findings_carry() -> None:
    other = replace(FINDING, code="SET101", name="other", severity=Severity.ERROR, package="b")
    found = page(FINDING, other)
    for key, values in (("package", {"a", "b"}), ("rule", {"XML104 placeholder-text", "SET101 other"})):
        assert {each.text for each in found.xpath(f"//select[@id='{key}']/option")[1:]} == values
        assert set(found.xpath(f"//article/@data-{key}")) == values
    levels = [each.text for each in found.xpath("//select[@id='level']/option")[1:]]
    assert levels == ["error", "warning", "info"]
    assert set(found.xpath("//article/@data-level")) == {"error", "warning"}


def test_every_id_that_the_script_asks_for_is_there() -> None:
    found = page(FINDING)
    (script,) = found.xpath("//script/text()")
    asked = set(re.findall(r'get\("(\w+)"\)', script))
    assert asked == set(found.xpath("//@id"))


def test_sums_by_package_and_rule() -> None:
    found = page(FINDING, FINDING, replace(FINDING, package="b", severity=Severity.ERROR))
    rows = [[cell.text_content() for cell in row] for row in found.xpath("(//table)[1]/tr")]
    assert rows == [["Package", "error", "warning", "info"], ["b", "1", "", ""], ["a", "", "2", ""]]
    assert [row[0].text for row in found.xpath("(//table)[2]/tr")] == ["Rule", "XML104 placeholder-text"]


@pytest.mark.parametrize(
    "place, span",
    [
        (PLACE, "TODO"),
        (replace(PLACE, end_line=2, end_column=1), "TODO y"),
        (replace(PLACE, end_column=3), "T"),
        (replace(PLACE, column=9, end_column=9), " "),
    ],
)
def test_the_span_is_marked(place: Location, span: str) -> None:
    (mark,) = page(replace(FINDING, location=place)).xpath("//pre/mark")
    assert mark.text_content() == span


def edited(text: str, at: Location) -> list[str]:
    return fix_shown(fix=Fix("repair", (Edit(at.path, at.span, text),)), edit_locations=(at,)).splitlines()


def test_an_edit_of_the_same_line_is_a_diff() -> None:
    assert edited("done", PLACE) == ["@ a/package.xml:1:3", "- x\tTODO y", "+ x\tdone y"]


def test_an_edit_elsewhere_is_its_place_and_what_is_new() -> None:
    there = Location("a/setup.py", Span(9, 12), 4, 1, 4, 4)
    assert edited("new\n", there) == ["@ a/setup.py:4:1", "- 3 characters, up to 4:4", "+ new"]
    assert edited("new", replace(there, span=Span(9, 9)))[1:] == ["+ new"]
    assert edited("", there)[1:] == ["- 3 characters, up to 4:4"]


def test_operations_on_files_are_said() -> None:
    operations = (Create("n", "one\ntwo\n"), Delete("d"), Move("m", "to"), Chmod("c", True), Chmod("e", False))
    assert fix_shown(fix=Fix("repair", operations)).splitlines() == [
        "new file n", "+ one", "+ two", "deletes d", "moves m to to", "makes c executable", "makes e not executable",
    ]  # fmt: skip


def test_nothing_found() -> None:
    found = page()
    assert "No problems found" in found.text_content()
    assert not found.xpath("//article")
