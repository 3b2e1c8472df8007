"""docs/rules/ has a page for each rule, made of the rule (`--update-golden` writes them), and its address is told."""

from __future__ import annotations

import io
import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from in_process import run_here
from pygls.workspace import PositionCodec

from rospkg_cli import rule_address
from rospkg_cli.cli.server.diagnostics import diagnostic
from rospkg_cli.report import Report, render
from rospkg_cli.rule import PLUGGED_IN, Rule, all_rules
from rospkg_cli.rule_address import address, web_address
from rospkg_cli.rule_docs import page, summary
from rospkg_cli.source import Source
from rospkg_cli.testing import lint_files

ROOT = Path(__file__).parents[1]
FOLDER = ROOT / "docs/rules"
WEB = "https://example.org/rospkg/{code}.html"
HEAD = """\
# Rules

Each page says what a rule finds, why that is bad, when the rule is quiet, and shows the fault and its repair, as
`rospkg explain CODE` does. By what was printed on your screen: [symptoms](../symptoms.md).

| Rule | Name | Severity | Fix | |
|---|---|---|---|---|
"""
RULES = [rule for rule in all_rules() if rule.code not in PLUGGED_IN]


def expected() -> dict[str, str]:
    """Return the texts of all pages by their names."""
    rows = (
        f"| [{rule.code}]({rule.code}.md) | {rule.name} | {rule.severity.value} | "
        f"{rule.fix.value if rule.fix else ''} | {in_a_cell(summary(rule))} |\n"
        for rule in RULES
    )
    return {"README.md": HEAD + "".join(rows), **{f"{rule.code}.md": "".join(as_list(page(rule))) for rule in RULES}}


def in_a_cell(text: str) -> str:
    return text.replace("|", "\\|")


def as_list(text: str) -> Iterator[str]:
    """Yield the lines of a page, what stands between its title and its first heading as a list."""
    head, heading, rest = text.partition("## ")
    yield re.sub(r"(?m)^(?=\w+: )", "- ", head)
    yield heading + rest


def test_the_pages_say_what_the_rules_say(pytestconfig: pytest.Config) -> None:
    pages = expected()
    if pytestconfig.getoption("--update-golden"):
        FOLDER.mkdir(exist_ok=True)
        for path in FOLDER.glob("*.md"):
            path.unlink()
        for name, text in pages.items():
            (FOLDER / name).write_text(text, encoding="utf-8")
    there = {path.name: path.read_text(encoding="utf-8") for path in FOLDER.glob("*.md")}
    assert there.keys() == pages.keys(), "write them: pytest tests/test_rule_pages.py --update-golden"
    changed = [name for name in pages if there[name] != pages[name]]
    assert not changed, "write them: pytest tests/test_rule_pages.py --update-golden"


@pytest.mark.parametrize("rule", RULES, ids=lambda rule: rule.code)
def test_a_page_keeps_its_tags_and_its_blocks(rule: Rule[Any]) -> None:
    """A tag outside of code is swallowed by Markdown, on the page and on terminals."""
    prose, *rest = re.split(r"^```\w*$", page(rule), flags=re.MULTILINE)
    assert "<" not in re.sub(r"`[^`]*`", "", prose)
    assert len(rest) % 2 == 0


def test_each_address_is_a_page_of_the_repository() -> None:
    for rule in RULES:
        assert (ROOT / str(address(rule.code))).is_file(), "the project has a site now: take this test back"


def test_explain_ends_with_the_address(tmp_path: Path) -> None:
    for name in ("SET101", "entry-point-module-missing"):
        assert run_here("explain", name, cwd=tmp_path).stdout.endswith("\n\nPage: docs/rules/SET101.md\n")
    listed = json.loads(run_here("rules", "SET101", "--format", "json", cwd=tmp_path).stdout)
    assert listed[0]["page"] == "docs/rules/SET101.md"


def test_a_rule_of_a_plugin_has_no_page_of_ours(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(rule_address, "PAGES", WEB)
    monkeypatch.setitem(PLUGGED_IN, "OUR001", RULES[0])
    assert (address("OUR001"), web_address("OUR001")) == (None, None)


class OneText:
    """A text that was linted, under whatever path."""

    def __init__(self, text: str) -> None:
        self.text = text

    def source(self, path: str) -> Source:
        return Source(path, self.text)

    def uri(self, path: str) -> str:
        return f"file:///ws/{path}"


@pytest.mark.parametrize("place, leads_to", [(WEB, "https://example.org/rospkg/XML104.html"), ("docs/{code}.md", None)])
def test_formats_and_editors_lead_to_a_page_on_the_web(
    place: str, leads_to: str | None, clean: dict[str, str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(rule_address, "PAGES", place)
    text = clean["package.xml"].replace("Apache-2.0", "TODO")
    results = lint_files({**clean, "package.xml": text}, ["XML104"])
    shown = {}
    for form in ("sarif", "rdjson"):
        stream = io.StringIO()
        render(form, Report(results, Path("/ws"), Path("/ws")), stream)
        shown[form] = json.loads(stream.getvalue())
    [rule] = shown["sarif"]["runs"][0]["tool"]["driver"]["rules"]
    [found] = shown["rdjson"]["diagnostics"]
    assert rule.get("helpUri") == leads_to
    assert found["code"] == {"value": "XML104", **({"url": leads_to} if leads_to else {})}
    told = diagnostic(results.findings[0], OneText(text), PositionCodec())
    assert (told.code_description and told.code_description.href) == leads_to


@pytest.mark.parametrize("color, width, is_link", [(True, 80, True), (True, None, False), (False, 80, False)])
def test_on_a_terminal_a_code_is_a_link_to_its_page(
    color: bool, width: int | None, is_link: bool, clean: dict[str, str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(rule_address, "PAGES", WEB)
    results = lint_files({**clean, "package.xml": clean["package.xml"].replace("Apache-2.0", "TODO")}, ["XML104"])
    stream = io.StringIO()
    render("text", Report(results, Path("/ws"), Path("/ws"), color=color, width=width), stream)
    link = "\x1b]8;;https://example.org/rospkg/XML104.html\x1b\\XML104\x1b]8;;\x1b\\"
    assert (link in stream.getvalue()) is is_link
    assert "XML104" in stream.getvalue()
