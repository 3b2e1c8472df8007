"""Nothing that a terminal, a log or a page would obey comes out of a package: neither its names nor its text."""

from __future__ import annotations

import io
import json
import re
import unicodedata
import xml.etree.ElementTree as ET
from dataclasses import replace
from pathlib import Path

import pytest
from markdown_it import MarkdownIt

from rospkg_cli.cli.diff import diff
from rospkg_cli.control_characters import in_json, visible, visible_lines, without_workflow_commands
from rospkg_cli.engine.run.results import Results
from rospkg_cli.finding import Edit, Finding, Fix, Location, Severity
from rospkg_cli.report import FORMATS, Report, render
from rospkg_cli.source import Source, Span
from rospkg_cli.tree import TreeEntry

C0 = "".join(map(chr, range(0x20)))
C1 = "".join(map(chr, range(0x7F, 0xA0)))
BIDI = "\u061c\u200e\u200f\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069"
ODD = "\u2028\u2029\ufeff\ufffe\uffff\ud800\udcff\U000e0041"
NASTY = C0 + C1 + BIDI + ODD
RAW = re.compile("[" + re.escape(NASTY.replace("\n", "").replace("\t", "")) + "]")
COMMANDS = "\n::error::pwn\r::stop-commands::x\n  ::add-mask::y ##[error]z ##vso[task.setvariable]"


def hostile(text: str) -> Finding:
    """Return a finding all whose texts are hostile."""
    line = f"before {text} here after".replace("\n", "")
    source = Source("a", line)
    start = line.index("here")
    place = Location(f"src/{text}.py", Span(start, start + 4), *source.position(start), *source.position(start + 4))
    fix = Fix(f"Put {text} in", (Edit(place.path, place.span, text),))
    return Finding(
        "SET101", "entry-point-module-missing", Severity.ERROR, f"`{text}` is {text} {'long ' * 12}{text}", place,
        text, line, ((place, f"there is {text}"),), fix, (place,),
    )  # fmt: skip


def reported(name: str, *findings: Finding, color: bool = False) -> str:
    stream = io.StringIO()
    silenced = tuple(replace(finding, suppressed=f"because {finding.package}") for finding in findings)
    results = Results(findings, silenced, packages=1, files=1)
    render(name, Report(results, Path("/w\x1b[0ms"), Path("/w\x1b[0ms/x\n::y"), color=color), stream)
    return stream.getvalue()


def obeyed(shown: str) -> list[str]:
    """Return the lines that GitHub's or Azure's runner would take for commands."""
    lines = re.split("[\r\n]", shown)
    return [line for line in lines if line.strip().startswith("::") or "##[" in line or "##vso[" in line]


@pytest.mark.parametrize("name", FORMATS)
def test_no_character_comes_out_raw(name: str) -> None:
    for text in (NASTY, *NASTY):
        shown = reported(name, hostile(text))
        assert not RAW.search(shown), text
        assert shown.encode()


@pytest.mark.parametrize("name", FORMATS)
def test_nothing_in_a_package_is_a_command_to_a_runner(name: str) -> None:
    for text in (COMMANDS, "::error::x", " ::error::x", "a\u2028::error::x"):
        finding = hostile(text)
        shown = reported(name, replace(finding, location=replace(finding.location, path=f"../x\n::y/{text}")), finding)
        told = [line for line in obeyed(shown) if not (name == "github" and line.startswith("::error file="))]
        assert not told, text


def test_paths_that_begin_like_a_command_do_not_stand_first_in_a_line() -> None:
    finding = hostile("x")
    finding = replace(finding, location=replace(finding.location, path="::error::x.py"))
    for name in set(FORMATS) - {"github"}:
        stream = io.StringIO()
        render(name, Report(Results((finding,)), Path("/w"), Path("/w")), stream)
        assert not obeyed(stream.getvalue()), name


def test_colours_are_ours_alone() -> None:
    shown = reported("text", hostile("\x1b[31m\x9b31m"), color=True)
    assert re.findall("\x1b\\[[0-9;]*m", shown)
    assert not RAW.search(re.sub("\x1b\\[[0-9;]*m", "", shown))
    assert "\\x1b[31m" in shown


@pytest.mark.parametrize("text", ["\x1b]0;x\x07", NASTY.replace("\n", ""), "\t\t", "é机\u202e", "##[a]", "\r"])
def test_the_carets_stand_under_what_is_meant(text: str) -> None:
    finding = hostile(text)
    if len(finding.excerpt) > 60:
        finding = replace(finding, excerpt=finding.excerpt[:60] + "…")
        start = 50
        finding = replace(finding, location=replace(finding.location, column=start + 1, end_column=start + 2))
    meant = finding.excerpt[finding.location.column - 1 : finding.location.end_column - 1]
    lines = reported("text", finding).splitlines()
    at = next(i for i, line in enumerate(lines) if line.lstrip(" |").startswith("^"))
    under = "".join(a for a, b in zip(lines[at - 1], lines[at].ljust(len(lines[at - 1])), strict=False) if b == "^")
    assert under == visible(meant)


@pytest.mark.parametrize("name", FORMATS)
def test_names_of_any_bytes_are_reported_and_written(name: str, tmp_path: Path) -> None:
    shown = reported(name, hostile("\udcff\ud83d"))
    (tmp_path / "report").write_text(shown, "utf-8")
    assert "udcff" in shown or "%FF" in shown


@pytest.mark.parametrize("name", ["json", "sarif", "gitlab", "rdjson"])
def test_json_holds_what_the_files_hold(name: str) -> None:
    """Escapes of JSON lose nothing; what is no Unicode at all is shown, for many readers refuse it."""
    text = NASTY.replace("\ud800", "").replace("\udcff", "") + "é机\U0001f600"
    document = json.dumps(json.loads(reported(name, hostile(text))), ensure_ascii=False)
    assert json.dumps(text, ensure_ascii=False)[1:-1] in document
    assert "\\\\udcff" in reported(name, hostile("\udcff"))
    ascii_only = io.TextIOWrapper(io.BytesIO(), "latin-1", newline="")
    render(name, Report(Results((hostile(text),)), Path("/w"), Path("/w")), ascii_only)
    ascii_only.flush()
    written = ascii_only.buffer.getvalue()  # type: ignore[attr-defined]
    assert json.dumps(text, ensure_ascii=False)[1:-1] in json.dumps(json.loads(written), ensure_ascii=False)


def test_junit_is_xml_whatever_the_names_are() -> None:
    for text in (*NASTY, NASTY, "]]>", "<a>&amp;\"'"):
        ET.fromstring(reported("junit", hostile(text)))
    stream = io.TextIOWrapper(io.BytesIO(), "latin-1")
    render("junit", Report(Results((hostile("é机\U0001f600"),)), Path("/w"), Path("/w")), stream)
    stream.flush()
    assert "é机\U0001f600" in "".join(ET.fromstring(stream.buffer.getvalue()).itertext())  # type: ignore[attr-defined]


def test_sarif_quotes_the_bytes_of_a_name() -> None:
    finding = hostile("x")
    for path, uri in (("a\udcff b#?%.py", "a%FF%20b%23%3F%25.py"), ("\ud800", "%ED%A0%80"), ("机", "%E6%9C%BA")):
        stream = io.StringIO()
        renamed = replace(finding, location=replace(finding.location, path=path))
        render("sarif", Report(Results((renamed,)), Path("/w"), Path("/w")), stream)
        (result,) = json.loads(stream.getvalue())["runs"][0]["results"]
        assert result["locations"][0]["physicalLocation"]["artifactLocation"]["uri"] == uri


MARKUP = [
    "<img src=x>", "[click](https://evil.example)", "![x](y)", "@somebody", "#12", "https://evil.example", "*x*", "_x_",
    "www.evil.example", "`", "``", "`<b>`", "``<b>`", "`a``<b>`", "```<b>``", "a|b", "a\\|b", "`a\\|<b>`", "~~x~~",
    "&lt;", "\\", "\\`<b>\\`", "<!--", "a@b.example", "$x$", "<https://evil.example>", "\n\n# x", "| x |\n|---|",
]  # fmt: skip


@pytest.mark.parametrize("text", [*MARKUP, "".join(MARKUP), " ".join(MARKUP)])
def test_markdown_shows_text_as_text(text: str) -> None:
    finding = hostile("x")
    parser = MarkdownIt("commonmark").enable(["table", "strikethrough"])
    for message in (text, f"`{text}` is {text}", f"{text}`"):
        nasty = replace(finding, message=message, location=replace(finding.location, path=f"a/{text}"))
        shown = reported("markdown", nasty)
        tokens = parser.parse(shown)
        assert sum(token.type == "td_open" for token in tokens) == 4, shown
        cells = [each for token in tokens for each in (token.children or [])]
        html = [each.content for each in cells if each.type == "html_inline"]
        assert set(html) <= {"<code>", "</code>"}
        assert not [each for each in cells if each.type in ("link_open", "image", "em_open", "strong_open", "s_open")]
        said = "".join(each.content for each in cells if each.type == "text")
        assert not re.search(r"(?<!\w)[@#]\w|://|\bwww\.", said)


def test_markdown_keeps_our_own_code_spans() -> None:
    finding = replace(hostile("x"), message="`my_pkg` is not in `setup.py`: my_thing, a-b (of 3)")
    assert "| `my_pkg` is not in `setup.py`: my_thing, a-b (of 3) |" in reported("markdown", finding)


def test_a_diff_shows_what_would_be_obeyed() -> None:
    before = TreeEntry("file", f"one\n::error::x\r{NASTY.replace(chr(10), '')[:-8]}\n::x\ntwo\n".encode())
    after = TreeEntry("file", before.data.replace(b"two", b"three"))
    shown = diff("a\n::error::\x1b\udcff.py", before, after)
    assert not RAW.search(shown)
    assert not obeyed(shown)
    assert "-two\n+three\n" in shown


def test_a_diff_breaks_lines_where_the_file_does() -> None:
    before = TreeEntry("file", b"a\x0cb\x1cc\xc2\x85d\r\ne\n")
    shown = diff("x", before, TreeEntry("file", before.data + b"f\n"))
    assert shown.splitlines()[3:] == [" a\\x0cb\\x1cc\\x85d", " e", "+f"]
    assert "No newline" not in shown


def test_every_such_character_is_shown() -> None:
    for number in (*range(0x3000), *range(0xD800, 0x10000), *range(0xE0000, 0xE0080)):
        char = chr(number)
        if unicodedata.category(char) in ("Cc", "Cs", "Zl", "Zp") or unicodedata.bidirectional(char) in BIDI_CLASSES:
            assert visible(char).isascii(), hex(number)
    assert visible("é机\U0001f468\u200d\U0001f469\xa0") == "é机\U0001f468\u200d\U0001f469\xa0"


BIDI_CLASSES = {"LRE", "RLE", "LRO", "RLO", "PDF", "LRI", "RLI", "FSI", "PDI"}


def test_a_prefix_stays_a_prefix() -> None:
    text = f"a##[b##vso[{NASTY}c"
    for end in range(len(text) + 1):
        assert visible(text).startswith(visible(text[:end]))


def test_lines_keep_their_ends_and_tabs() -> None:
    assert visible_lines("a\tb\r\nc\rd\n") == "a\tb\r\nc\\rd\n"
    assert without_workflow_commands("a\n ::b\n::c d::e") == "a\n \\x3a:b\n\\x3a:c d::e"
    assert in_json('"\u202e\U0001f600"', only_ascii=True) == '"\\u202e\\ud83d\\ude00"'
