"""The text for people: what is shown of a short and of a long report, in which order, and how lines break."""

from __future__ import annotations

import io
import re
from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from in_process import run_here as rospkg

from rospkg_cli.engine.run.results import Results
from rospkg_cli.finding import Edit, Finding, Fix, Location, Safety, Severity
from rospkg_cli.report import Report, render
from rospkg_cli.report.short_message import clauses, short_message
from rospkg_cli.report.text import LONG
from rospkg_cli.report.wrap import terminal_width, words, wrapped
from rospkg_cli.source import Span

ERROR, WARNING, INFO = Severity.ERROR, Severity.WARNING, Severity.INFO


def finding(code: str, severity: Severity, package: str, line: int = 1, **others: object) -> Finding:
    place = Location(
        f"{package}/package.xml" if package else "rospkg.toml", Span(10 * line, 10 * line + 4), line, 1, line, 5
    )
    text = f"`{code.lower()}` is wrong in `{package}`: it fails; write it anew"
    return replace(Finding(code, f"name-of-{code.lower()}", severity, text, place, package, "some text"), **others)


def shown(*findings: Finding, packages: int = 3, **how: object) -> str:
    stream = io.StringIO()
    results = Results(tuple(sorted(findings, key=lambda f: f.sort_key)), packages=packages, files=9)
    render("text", Report(results, Path("/ws"), Path("/ws"), **how), stream)  # type: ignore[arg-type]
    return stream.getvalue()


def many(number: int, severity: Severity = WARNING, package: str = "arm") -> list[Finding]:
    return [finding("XML104", severity, package, line) for line in range(1, number + 1)]


def test_the_worst_package_is_last_and_its_worst_finding_too() -> None:
    text = shown(
        finding("SET101", ERROR, "base"), finding("XML104", WARNING, "base", 9), finding("XML104", WARNING, "arm"),
        finding("DEP101", WARNING, "arm", 2), finding("DEP101", WARNING, "camera"),
    )  # fmt: skip
    assert re.findall(r"^(\w+): (.*)$", text, re.M) == [
        ("camera", "1 warning"),
        ("arm", "2 warnings"),
        ("base", "1 error, 1 warning"),
    ]
    heads = re.findall(r"^(\w+)/package.xml:(\d+)", text, re.M)
    assert heads == [("camera", "1"), ("arm", "1"), ("arm", "2"), ("base", "9"), ("base", "1")]


def test_one_package_has_no_heading_and_no_package_is_the_workspace() -> None:
    assert not re.search(r"^arm:", shown(*many(1), packages=1), re.M)
    assert shown(finding("RPK002", WARNING, "")).startswith("workspace: 1 warning\nrospkg.toml:1:1: warning RPK002")


def test_infos_are_counted_and_shown_where_asked() -> None:
    found = [*many(1), *many(2, INFO, "base"), finding("DEP102", INFO, "base")]
    text = shown(*found)
    assert "base/package.xml" not in text
    assert "not shown: 3 info (DEP102 name-of-dep102, XML104 name-of-xml104)\nFound 1 warning, 3 info in " in text
    assert shown(*found, shows_info=True).count("base/package.xml") == 3
    assert "not shown" not in shown(*found, shows_info=True)
    assert "not shown" not in shown(*many(2))


def test_the_heading_counts_infos_too_even_where_they_are_not_shown() -> None:
    assert "arm: 1 warning, 2 info\n" in shown(*many(1), *many(2, INFO))


def test_a_long_report_is_short_and_has_a_table() -> None:
    found = [*many(LONG - 1), finding("SET101", ERROR, "base"), finding("DEP102", INFO, "base")]
    assert "rule\n" not in shown(*found)
    assert shown(*found).count("some text") == LONG
    found.append(finding("SET102", WARNING, "base"))
    text = shown(*found)
    assert text.count("some text") == 1  # the error's
    assert "  base/package.xml:1:1: error SET101 name-of-set101\n      1 | some text\n" in text
    assert "  base/package.xml:1:1: warning SET102 `set102` is wrong in `base`; write it anew\n" in text
    assert text.splitlines()[-8:-3] == [
        "error  warning  info  --fix  rule",
        "                   1         DEP102 name-of-dep102",
        "             1               SET102 name-of-set102",
        "            14               XML104 name-of-xml104",
        "    1                        SET101 name-of-set101",
    ]
    assert text.splitlines()[-2].startswith("--show all shows each finding in full")
    assert shown(*found, shows_all=True, shows_info=True).count("some text") == LONG + 2


def test_further_places_of_a_rule_follow_the_first_one_line_a_file() -> None:
    fix = Fix("Add <depend>x</depend>", (Edit("arm/package.xml", Span(0, 0), "x"),))
    other = replace(finding("XML104", WARNING, "arm", 99), location=Location("arm/b.xml", Span(0, 1), 9, 2, 9, 3))
    first, *more = many(LONG)
    text = shown(replace(first, fix=fix), *(replace(each, fix=fix) for each in more), replace(other, fix=None))
    assert "  arm/b.xml:9:2: warning XML104 `xml104` is wrong in `arm`; write it anew\n" in text
    (line,) = re.findall("^    arm/package.xml:1:1: .*", text, re.M)
    assert line.startswith("    arm/package.xml:1:1: add <depend>x</depend>; 2:1: add <depend>x</depend>; 3:1: add")
    assert line.endswith(f"; {LONG}:1: add <depend>x</depend>")


@pytest.mark.parametrize("safety, option", [(Safety.SAFE, "--fix"), (Safety.UNSAFE, "--fix --unsafe-fixes")])
def test_a_fix_is_said_once(safety: Safety, option: str) -> None:
    fix = Fix("Write it anew", (Edit("arm/package.xml", Span(0, 0), "x"),), safety)
    (found,) = many(1)
    text = shown(replace(found, fix=fix))
    assert f"  `xml104` is wrong in `arm`: it fails\n  {option}: write it anew\n\n" in text
    short = shown(*(replace(each, fix=fix) for each in many(LONG + 1)))
    assert f"XML104 `xml104` is wrong in `arm`; {option}: write it anew\n" in short
    assert ("   16  XML104" in short) == (safety is Safety.SAFE)


def test_places_that_are_said_the_same_of_stand_together() -> None:
    places = [Location(f"arm/{name}.py", Span(0, 1), 3, 1, 3, 2) for name in "abc"]
    (found,) = many(1)
    text = shown(replace(found, related=((places[0], "and here"), (places[1], "the first"), (places[2], "and here"))))
    assert "  see arm/a.py:3:1, arm/c.py:3:1: and here\n  see arm/b.py:3:1: the first\n" in text


def test_of_many_related_places_the_first_are_shown() -> None:
    (found,) = many(1)
    places = [(Location(f"arm/{name}.py", Span(0, 1), 3, 1, 3, 2), "the same") for name in "abcdef"]
    five = shown(replace(found, related=tuple(places[:5])))
    assert "  see arm/a.py:3:1, arm/b.py:3:1, arm/c.py:3:1, arm/d.py:3:1, arm/e.py:3:1: the same\n" in five
    six = shown(replace(found, related=tuple(places)))
    assert "  see arm/a.py:3:1, arm/b.py:3:1, arm/c.py:3:1, arm/d.py:3:1 and 2 more: the same\n" in six


def test_what_is_wrong_and_what_to_do_are_told_apart() -> None:
    (found,) = many(1)
    assert clauses('`a: b; c` says "x: y": then; do') == ['`a: b; c` says "x: y"', "then", "do"]
    for message, short in (
        ("a is wrong: b fails; do c", "a is wrong; do c"),
        ("a is wrong; do c", "a is wrong; do c"),
        ("a is wrong: b fails", "a is wrong: b fails"),
        ("a is wrong", "a is wrong"),
        ("a: b: c", "a: b: c"),
    ):
        assert short_message(replace(found, message=message)) == short
    fix = Fix("Do d", ())
    assert short_message(replace(found, message="a is wrong: b fails; do c", fix=fix)) == "a is wrong"


@given(st.lists(st.text("ab` /.", min_size=1, max_size=12), max_size=12), st.integers(20, 60))
def test_lines_fit_and_lose_nothing(parts: list[str], width: int) -> None:
    text = " ".join(parts)
    found = wrapped(words(text), width, "  ", "    ")
    assert "".join("".join(found).split()) == "".join(text.split())
    assert all(len(line) <= width or len(line.split()) == 1 for line in found)
    assert len(wrapped(words(text), None)) == 1


def test_neither_places_nor_code_are_broken() -> None:
    text = "aaaa bbbb `find_package(rclcpp REQUIRED)` cccc"
    assert wrapped(words(text), 34) == ["aaaa bbbb", "`find_package(rclcpp REQUIRED)`", "cccc"]
    assert wrapped(words(text), 20) == ["aaaa bbbb", "`find_package(rclcpp", "REQUIRED)` cccc"]
    place = "a folder/with a very long name indeed.py:12:3:"
    assert wrapped([(place, ""), *words("error X")], 30) == [place, "error X"]
    assert wrapped([("some/long/path/of/a/file.py:12:3:", "bold"), *words("error X")], 30, "", "  ", True) == [
        "\x1b[1msome/long/path/of/a/file.py:12:3:\x1b[0m",
        "  error X",
    ]


def test_the_excerpt_fits_the_width() -> None:
    long = "x" * 30 + "here" + "y" * 200
    place = Location("arm/a.py", Span(30, 34), 7, 31, 7, 35)
    (found,) = many(1)
    for width, length in ((40, 40), (100, 100), (300, 118), (None, 118)):
        lines = shown(replace(found, excerpt=long, location=place), width=width).splitlines()
        source = next(line for line in lines if line.startswith("    7 | "))
        marks = lines[lines.index(source) + 1]
        assert len(source) == length
        assert source[marks.index("^") : marks.rindex("^") + 1] == "here"


def test_the_width_is_the_terminals(monkeypatch: pytest.MonkeyPatch) -> None:
    class Terminal(io.StringIO):
        def isatty(self) -> bool:
            return True

    monkeypatch.setenv("COLUMNS", "57")
    assert terminal_width(Terminal()) == 57
    monkeypatch.setenv("COLUMNS", "3")
    assert terminal_width(Terminal()) == 20
    monkeypatch.delenv("COLUMNS")
    assert (terminal_width(Terminal()) or 0) >= 20
    assert terminal_width(io.StringIO()) is None


@pytest.fixture
def package(tmp_path, write, clean) -> Path:
    """A package with one warning, and one info that only --pedantic brings."""
    manifest = clean["package.xml"].replace("Apache-2.0", "TODO")
    return write(tmp_path / "my_pkg", {**clean, "package.xml": manifest, "setup.cfg": ""})


def test_show_info_fail_on_info_and_a_rule_by_its_name_show_infos(package: Path) -> None:
    (package / "rospkg.toml").write_text('[severity]\nXML104 = "info"\n')
    place = "package.xml:8:12: info XML104"
    assert place not in rospkg("lint", cwd=package).stdout
    assert "not shown: 1 info (XML104 placeholder-metadata)" in rospkg("lint", cwd=package).stdout
    for how in (
        ["--show", "info"],
        ["--show", "all"],
        ["--fail-on", "info"],
        ["--select", "XML104"],
        ["--select", "placeholder-metadata"],
    ):
        assert place in rospkg("lint", *how, cwd=package).stdout, how
    assert place not in rospkg("lint", "--select", "XML", cwd=package).stdout
    (package / "rospkg.toml").write_text('fail-on = "info"\n[severity]\nXML104 = "info"\n')
    assert place in rospkg("lint", cwd=package).stdout
    assert "--show must be one of info, all" in rospkg("lint", "--show", "infos", cwd=package).stderr


def test_show_all_shows_each_finding_in_full(tmp_path: Path, write, clean) -> None:
    for number in range(LONG + 1):
        manifest = clean["package.xml"].replace("my_pkg", f"p{number}").replace("Apache-2.0", "TODO")
        write(tmp_path / f"p{number}", {"package.xml": manifest})
    select = ("--select", "XML1")
    assert "<license>" not in rospkg("lint", *select, cwd=tmp_path).stdout
    assert rospkg("lint", *select, "--show", "all", cwd=tmp_path).stdout.count("<license>") == LONG + 1
