"""The bench that attacks us: it finds what it is there to find, and says nothing where nothing is wrong."""

from __future__ import annotations

import os
import random
import sys
import time
from dataclasses import replace
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[1]))

from bench.attack import limits, work
from bench.attack.case import Case, make_case, write_case
from bench.attack.checks import faults_of_change, faults_of_output, is_well_formed, snapshot
from bench.attack.corpus import Corpus, read_corpus
from bench.attack.kinds import KINDS, NESTS, NEW_PATH, SPARE, kind_of
from bench.attack.steps import Attempt
from bench.attack.texts import LIMIT, MUTATIONS
from bench.attack.trees import ODDITIES, SECRET
from bench.attack.work import Plan, run_all
from bench.many_packages import write_packages


@pytest.fixture(scope="module")
def corpus(tmp_path_factory: pytest.TempPathFactory) -> Corpus:
    folder = tmp_path_factory.mktemp("packages")
    write_packages(folder, 5)
    return read_corpus([folder])


def intact(corpus: Corpus) -> Case:
    package = sorted(corpus.packages)[1]
    return Case(0, "tree", package, "", (), corpus.packages[package], (), "1", unsafe=True)


def test_an_input_follows_from_its_number(corpus: Corpus) -> None:
    for number in range(40):
        assert make_case(corpus, 1, number) == make_case(corpus, 1, number)
    assert make_case(corpus, 1, 3) != make_case(corpus, 2, 3)
    assert {make_case(corpus, 1, number).kind for number in range(len(KINDS))} == set(KINDS)


def test_every_mutation_takes_every_kind_and_nothing_at_all() -> None:
    for kind in (*NESTS, "interface"):
        for mutation in MUTATIONS:
            for seed, data in enumerate((b"", b"<a b='c'>d</a>\n" * 5, b"\xff\x00")):
                found = mutation(data, kind, [b"one two\n"], random.Random(seed))
                assert len(found) <= 5 * LIMIT  # a case is cut at LIMIT afterwards


@pytest.mark.parametrize("oddity", range(len(ODDITIES)))
def test_every_oddity_can_be_put_into_a_tree(corpus: Corpus, oddity: int, tmp_path: Path) -> None:
    case = replace(intact(corpus), oddities=(oddity,) * 3)
    write_case(case, tmp_path / "one")
    write_case(case, tmp_path / "two")
    assert snapshot(tmp_path / "one") == snapshot(tmp_path / "two")
    assert snapshot(tmp_path / "one") != snapshot(write_case(intact(corpus), tmp_path / "three").parents[1])


@pytest.mark.parametrize(
    "path, kind",
    [
        ("package.xml", "manifest"),
        ("launch/a.launch.py", "launch.py"),
        ("a/b.py", "Python"),
        ("urdf/a.urdf.xacro", "robot"),
        ("cmake/a.cmake.in", ".cmake"),
        ("config/a.yaml", "parameters"),
        ("launch/a.launch.yaml", "launch.yaml"),
        ("a.png", None),
    ],
)
def test_the_kind_of_a_file(path: str, kind: str | None) -> None:
    assert kind_of(path) == kind


@pytest.mark.parametrize(
    "name, text, fault",
    [
        ("text", "a\x1b[2J", "raw"),
        ("json", '"\u202e"', "raw"),
        ("said", "rospkg: `a\rb`", "raw"),
        ("text", f"  1 | {SECRET}", "outside"),
        ("concise", "a\n ::error::b", "workflow command"),
        ("github", "::error file=a::b\n::stop-commands::c", "workflow command"),
        ("sarif", "{", "is no sarif"),
        ("junit", "<a>\ufffe</a>", "is no junit"),
    ],
)
def test_what_is_wrong_with_an_output_is_found(name: str, text: str, fault: str) -> None:
    assert fault in " ".join(faults_of_output(name, text))


@pytest.mark.parametrize("name, text", [("text", "\ta é ::b\n"), ("github", "::error file=a::b"), ("junit", "<a/>")])
def test_a_good_output_has_no_fault(name: str, text: str) -> None:
    assert not list(faults_of_output(name, text))


def test_what_is_well_formed() -> None:
    for path, good, bad in (("a.xml", b"<a/>", b"<a>"), ("a.yaml", b"a: b", b"a: ["), ("a.py", b"a", b"a b")):
        assert (is_well_formed(path, good), is_well_formed(path, bad)) == (True, False)
    assert is_well_formed("a.yaml", b"[" * 2_000) is False
    assert is_well_formed("a.msg", b"") is None


def test_what_a_command_may_not_change(tmp_path: Path) -> None:
    package = tmp_path / "ws" / "pkg"
    package.mkdir(parents=True)
    (package / "a.py").write_text("a\n")
    (package / "b.py").symlink_to("a.py")
    (tmp_path / "x").write_text("")
    before = snapshot(tmp_path)
    assert not list(faults_of_change(before, before))
    (package / "a.py").write_text("a b\n")
    (package / "b.py").unlink()
    (package / "b.py").write_text("")
    (package / ".a.py.1234").write_text("")
    (tmp_path / "x").write_text("y")
    found = " ".join(faults_of_change(before, snapshot(tmp_path)))
    assert all(each in found for each in ("well-formed", "another kind", "stray", "outside"))


def test_an_intact_package_passes_every_step(corpus: Corpus, tmp_path: Path) -> None:
    outcome = Attempt(intact(corpus), tmp_path / "room").run()
    assert not outcome.faults
    assert set(outcome.statuses) >= {"lint", "lint json", "inspect", "inspect json", "fix", "format"}


@pytest.mark.parametrize("kind", sorted(SPARE))
def test_no_seed_is_refused_as_it_is(corpus: Corpus, kind: str, tmp_path: Path) -> None:
    """A config that is always refused would test nothing behind the refusal."""
    case = intact(corpus)
    outcome = Attempt(replace(case, files={**case.files, NEW_PATH[kind]: SPARE[kind]}), tmp_path / "room").run()
    assert not outcome.faults
    assert all(status in (0, 1) for status in outcome.statuses.values())


def test_what_is_raised_is_found_with_its_place(corpus: Corpus, tmp_path: Path) -> None:
    attempt = Attempt(intact(corpus), tmp_path)

    def broken() -> int:
        raise RecursionError("too deep")

    def crashed() -> int:
        text = 'Traceback (most recent call last)\n  File "/x/rospkg_cli/a/b.py", line 3, in c\nKeyError: 1\n'
        print(text, file=sys.stderr)
        return 3

    attempt.step("one", broken)
    attempt.step("two", crashed)
    assert [(each.what, each.where) for each in attempt.outcome.faults] == [
        ("RecursionError: too deep", ""),
        ("RPK005 KeyError: 1", "a/b.py:3 c"),
    ]


def test_what_takes_too_long_is_found(corpus: Corpus, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(limits, "SECONDS", 0.05)
    attempt = Attempt(intact(corpus), tmp_path)

    def endless() -> int:
        while True:
            pass

    attempt.step("one", endless)
    assert "over the time" in attempt.outcome.faults[0].what


def test_a_process_that_dies_or_waits_is_one_failed_input(
    corpus: Corpus, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def run_case(plan: Plan, number: int) -> work.Row:
        if number == 1:
            os._exit(7)
        if number == 3:
            time.sleep(60)
        return {"case": number, "faults": []}

    monkeypatch.setattr(work, "run_case", run_case)
    monkeypatch.setattr(work, "STILL", 0.3)
    rows = sorted(run_all(Plan(corpus, 1, tmp_path), range(5), 2), key=lambda row: row["case"])
    assert [row["case"] for row in rows] == [0, 1, 2, 3, 4]
    assert [fault["what"] for row in rows for fault in row["faults"]] == ["the process died of 7", "waits for good"]
