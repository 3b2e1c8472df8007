"""Limits of a run: the last that is still taken, and the first that is too much."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace

import pytest
from cmaking import read

from rospkg_cli import disk_trace
from rospkg_cli.edits.brought_hits import related
from rospkg_cli.edits.cmake_commands import guard
from rospkg_cli.engine.discovery import discover, exclusions, incomplete_workspace, listed_repositories
from rospkg_cli.engine.fixing import remove_leftovers
from rospkg_cli.engine.run import run_rules
from rospkg_cli.engine.run.pool import SERIAL_BELOW, Pool
from rospkg_cli.engine.run.process_pool import asked_of_the_disk
from rospkg_cli.engine.run.scope import Scope
from rospkg_cli.engine.run.session import Session
from rospkg_cli.engine.suppression import comments, file_head
from rospkg_cli.engine.suppression.insert_ignores import ignore_comments
from rospkg_cli.example import manifest
from rospkg_cli.files import PackageFiles
from rospkg_cli.finding import Edit, Finding, Fix, Hit, Location, Related, Severity
from rospkg_cli.light_dataclasses import replace
from rospkg_cli.rule_table import rule_by_code
from rospkg_cli.source import Source, Span
from rospkg_cli.tree import MemoryTree

AT = Span(0, 1)


@pytest.mark.parametrize("package, where", [("arm", "`arm`"), ("", "the workspace")])
def test_findings_of_one_rule(monkeypatch: pytest.MonkeyPatch, package: str, where: str) -> None:
    def check(count: int) -> Iterator[Hit]:
        yield from [Hit("a", AT, f"hit {n}", None, (Related("a", AT, "x"),), Fix("Do it", ())) for n in range(count)]

    monkeypatch.setattr(run_rules, "MAX_HITS", 1_002)
    rule = replace(rule_by_code("XML104"), over=int, check=check)
    hits = list(run_rules.run_rule(rule, [1_000, 2], package))
    assert [hit.message for hit in hits[-2:]] == ["hit 0", "hit 1"]
    *others, last = run_rules.run_rule(rule, [1_000, 5], package)
    assert [hit.message for hit in others[-1:]] == ["hit 1"]
    more = f"more than 1,002 findings of XML104 in {where}: from here on they are not shown"
    assert last == Hit("a", AT, more)


def test_repositories_of_a_list(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(listed_repositories, "MAX_LISTED", 2)
    assert listed_repositories.listed_repositories(b"repositories: {a: 1, b: 2}") == ["a", "b"]
    with pytest.raises(ValueError, match="one too long"):
        listed_repositories.listed_repositories(b"repositories: {a: 1, b: 2, c: 3}")


def test_bytes_of_a_list_and_of_submodules(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "a.repos").write_text(listed := "repositories: {arm: 1}")
    monkeypatch.setattr(incomplete_workspace, "MAX_BYTES", len(listed))
    missing = incomplete_workspace.missing_of_list(tmp_path / "a.repos", tmp_path)
    assert missing.why == "`a.repos` lists repositories that are not here (arm)"
    monkeypatch.setattr(incomplete_workspace, "MAX_BYTES", len(listed) - 1)
    assert incomplete_workspace.missing_of_list(tmp_path / "a.repos", tmp_path).why.endswith("and can't be read")
    (tmp_path / ".gitmodules").write_text(modules := '[submodule "a"]\n\tpath = a\n[submodule "b"]\n\tpath = b\n')
    (tmp_path / "a").mkdir()
    (tmp_path / "a/x").touch()
    for limit, folders in ((len(modules), ["a", "b"]), (len(modules) - 1, [])):
        monkeypatch.setattr(incomplete_workspace, "MAX_BYTES", limit)
        assert incomplete_workspace.submodules(tmp_path / ".gitmodules") == folders
    (tmp_path / "a.repos").unlink()
    monkeypatch.setattr(incomplete_workspace, "MAX_BYTES", 1_000)
    for limit, missing in ((2, "the submodule `b` is empty"), (1, "none")):
        monkeypatch.setattr(incomplete_workspace, "MAX_SUBMODULES", limit)
        found = [each.why for each in incomplete_workspace.missing_below(tmp_path, tmp_path)]
        assert (found or ["none"])[0].startswith(missing)


def test_folders_that_are_searched_for_a_pattern(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "a/b").mkdir(parents=True)
    (tmp_path / "a/x.txt").touch()
    monkeypatch.setattr(exclusions, "MAX_FOLDERS", 3)
    assert not exclusions.is_anywhere(tmp_path, "none")
    assert exclusions.is_anywhere(tmp_path, "x.*")
    assert exclusions.is_anywhere(tmp_path, "a/x.txt")
    monkeypatch.setattr(exclusions, "MAX_FOLDERS", 2)
    assert exclusions.is_anywhere(tmp_path, "none")
    assert not exclusions.is_anywhere(tmp_path / "nowhere", "none")


def test_links_that_are_followed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "top").mkdir()
    for name in ("a", "b"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "package.xml").touch()
        (tmp_path / "top" / name).symlink_to(tmp_path / name)
    for limit, names in ((2, ["a", "b"]), (1, ["a"])):
        monkeypatch.setattr(discover, "MAX_LINKED_FOLDERS", limit)
        assert [path.name for path in discover.packages_below(tmp_path / "top")] == names


def test_pieces_of_the_head_of_a_file(monkeypatch: pytest.MonkeyPatch) -> None:
    text = "<!-- a --> <!-- b -->"
    for limit, is_head in ((3, True), (2, False)):
        monkeypatch.setattr(file_head, "MAX_STEPS", limit)
        assert file_head.FileHead(Source("a.xml", text)).holds(len(text)) is is_head


def test_what_is_read_of_a_head_is_not_read_again() -> None:
    head = file_head.FileHead(Source("a.xml", "<!-- a --> <!-- b --> <c/>"))
    assert head.holds(15)
    assert (head.at, head.steps) == (11, 3)
    assert head.holds(22)
    assert (head.at, head.steps) == (22, 5)
    assert not head.holds(25)


def test_the_reason_of_an_ignore_comment(monkeypatch: pytest.MonkeyPatch) -> None:
    text = "<!-- rospkg: ignore[XML104] so\nlong -->"
    files = PackageFiles(MemoryTree.of({"a.xml": text}))
    (whole,) = comments.suppressions_in(files)
    assert (whole.reason, whole.span) == ("so\nlong", Span(0, len(text)))
    first = len(" so\nlong -->")
    for limit, reason in ((first, "so\nlong"), (first - 1, "so")):
        monkeypatch.setattr(comments, "MAX_REASON", limit)
        (found,) = comments.suppressions_in(files)
        assert found.reason == reason


def test_other_places_of_a_finding() -> None:
    found = related(("a", Span(n, n)) for n in range(9))
    assert found == tuple(Related("a", Span(n, n), "and here") for n in (1, 2, 3))


def test_commands_that_are_guarded(monkeypatch: pytest.MonkeyPatch) -> None:
    file = read("a(1)\na(2)\nb(3)\na(4)\na(5)\na(6)\n").root
    wanted = [each for each in file.syntax.commands if each.name == "a"]
    for limit, guarded in ((3, wanted), (2, wanted[:2])):
        monkeypatch.setattr("rospkg_cli.edits.cmake_commands.MAX_RUN", limit)
        assert list(guard(file, wanted)) == [id(each) for each in guarded]


@pytest.mark.parametrize("packages, is_serial", [(SERIAL_BELOW - 1, True), (SERIAL_BELOW, False)])
def test_few_packages_are_checked_in_this_process(packages: int, is_serial: bool) -> None:
    made: list[str] = []

    class Several(Pool):
        def __init__(self, *arguments: object) -> None:
            made.append("several")

    folders = [f"p{n}" for n in range(packages)]
    tree, scope = MemoryTree.of({"package.xml": manifest()}), Scope((), frozenset())
    for kept, expected in ((None, ["several"]), (SimpleNamespace(), [] if is_serial else ["several"])):
        made.clear()
        session = Session(tree, scope, frozenset(), make_pool=Several, kept=kept)  # type: ignore[arg-type]
        session.pool_for(folders)
        assert made == expected


@pytest.mark.parametrize(
    "path, text, line, put",
    [
        ("a.py", "#!/usr/bin/env python3\nx = 1\n", 1, None),
        ("a.py", "x = 1\n#! y\n", 1, "# rospkg: ignore[SET101] why not\n"),
        ("a.py", "x = 1\n  #! y\n", 2, "  # rospkg: ignore[SET101] why not\n"),
        ("a.py", "x = 1\n#! y\n", 2, "# rospkg: ignore[SET101] why not\n"),
        ("a.xml", "<?xml version='1.0'?>\n<a/>\n", 1, None),
        ("a.xml", "<a>\n\t<b/>\n", 2, "\t<!-- rospkg: ignore[SET101] why not -->\n"),
        ("a.cpp", "int x;\n", 1, "// rospkg: ignore[SET101] why not\n"),
        ("a.md", "x\n", 1, None),
    ],
)
def test_an_ignore_comment_never_comes_before_the_first_line_s_mark(
    path: str, text: str, line: int, put: str | None
) -> None:
    at = Location(path, Span(0, 1), line, 1, line, 2)
    found = [Finding(code, "x", Severity.ERROR, "x", at, "a") for code in ("SET101", "RPK001")]
    fixes = list(ignore_comments(MemoryTree.of({path: text}), found, " why\n not "))
    start = Source(path, text).line_span(line).start
    edits = () if put is None else (Edit(path, Span(start, start), put),)
    assert [(fix.title, fix.operations) for fix in fixes] == ([("Ignore SET101", edits)] if edits else [])


def test_a_process_gives_its_trace() -> None:
    assert asked_of_the_disk() == []
    trace = disk_trace.start_trace()
    assert asked_of_the_disk() == [trace]
    disk_trace.stop_trace()


@pytest.mark.parametrize("age, has_ended", [(600.0, False), (601.0, True)])
def test_where_a_process_can_not_be_asked_the_age_of_its_file_tells(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, age: float, has_ended: bool
) -> None:
    (tmp_path / "x").touch()
    os.utime(tmp_path / "x", (1_000, 1_000))
    monkeypatch.setattr(remove_leftovers, "os", SimpleNamespace(name="nt"))
    monkeypatch.setattr(remove_leftovers, "time", SimpleNamespace(time=lambda: 1_000 + age))
    assert remove_leftovers.has_ended(tmp_path / "x", os.getpid()) is has_ended
    assert remove_leftovers.has_ended(tmp_path / "gone", os.getpid()) is False


@pytest.mark.parametrize(
    "error, has_ended",
    [(None, False), (ProcessLookupError, True), (OverflowError, True), (PermissionError, False)],
)
def test_elsewhere_its_process_does(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, error: type[Exception] | None, has_ended: bool
) -> None:
    asked: list[tuple[int, int]] = []

    def kill(process: int, signal: int) -> None:
        asked.append((process, signal))
        if error is not None:
            raise error

    monkeypatch.setattr(remove_leftovers, "os", SimpleNamespace(name="posix", kill=kill))
    assert remove_leftovers.has_ended(tmp_path / "x", 17) is has_ended
    assert asked == [(17, 0)]
