"""`rospkg new -i`: a question for what was not typed, asked again after a wrong answer, with the defaults of always."""

from __future__ import annotations

import io
import shlex
import sys
from pathlib import Path

import pytest
from in_process import Done, run_here

from rospkg_cli.cli.new.interactive import ask, command_of
from rospkg_cli.scaffold.answers import Request

ADA = {"maintainer": "Ada", "email": "ada@example.org", "distro": "lyrical"}


def answer(monkeypatch: pytest.MonkeyPatch, request: Request, *lines: str, **defaults: str) -> Request:
    monkeypatch.setattr("sys.stdin", io.StringIO("".join(f"{line}\n" for line in lines)))
    return ask(request, Path(), defaults)


def talk(lines: str, cwd: Path, *options: str) -> Done:
    before, sys.stdin = sys.stdin, io.StringIO(lines)
    try:
        return run_here("new", "-i", *options, cwd=cwd)
    finally:
        sys.stdin = before


def test_nothing_answered_is_what_nothing_typed_is(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.chdir(tmp_path)
    asked = Request("my_pkg", **ADA)
    assert answer(monkeypatch, asked, *[""] * 9) == asked


def test_every_answer_finds_its_place(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    given = (
        "my_pkg",
        "ament_cmake",
        "talker, driver:component",
        "nav_msgs",
        "xml",
        "generate",
        "minimal",
        "jazzy",
        "Drives.",
        "MIT",
    )
    found = answer(monkeypatch, Request(""), *given, "Ada", "ada@example.org", "ci, docs")
    assert found == Request(
        "my_pkg", "ament_cmake", ("talker", "driver:component"), ("nav_msgs",), launch="xml", tests="minimal",
        parameters="generate",
        distro="jazzy", description="Drives.", license="MIT", maintainer="Ada", email="ada@example.org",
        extras=("ci", "docs"),
    )  # fmt: skip
    said = capsys.readouterr()
    assert said.out == ""
    assert "License (SPDX identifier) [Apache-2.0]: " in said.err


def test_launch_formats_and_distributions_stand_in_lines_of_their_own(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    answer(monkeypatch, Request("my_pkg", maintainer="Ada", email="ada@example.org"), *[""] * 10)
    said = capsys.readouterr().err
    assert "  yaml  YAML, as short, in lists and keys\n  none  no launch file\nLaunch file [py]: " in said
    assert "  humble   Humble Hawksbill on Ubuntu 22.04, an LTS until 2027-05\n" in said
    assert "\n  kilted   Kilted Kaiju on Ubuntu 24.04, until 2026-12\n" in said
    assert "\n  rolling  Rolling Ridley on Ubuntu 26.04, always the newest\nDistribution [" in said


def test_a_package_that_starts_others_is_not_offered_no_launch_file(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    answer(monkeypatch, Request("my_bringup", template="bringup", **ADA), *[""] * 9)
    assert "in lists and keys\nLaunch file [py]: " in capsys.readouterr().err


def test_a_wrong_answer_is_explained_and_asked_again(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    given = (
        "My-Pkg",
        "my_pkg",
        "ament_pyton",
        "",
        "talker:publischer",
        "talker",
        "my_pkg",
        "",
        "",
        "generated",
        "",
        "",
        "",
        "WTFPL",
        "",
        "",
    )
    found = answer(monkeypatch, Request("", **ADA), *given)
    assert (found.name, found.nodes, found.depends, found.license) == ("my_pkg", ("talker",), (), "")
    said = capsys.readouterr().err
    for why in (
        "try `my_pkg`",
        "did you mean `ament_python`",
        "did you mean `publisher`",
        "depend on itself",
        "did you mean `generate`",
        "`WTFPL`",
    ):
        assert why in said


def test_messages_are_asked_for_one_by_one(monkeypatch: pytest.MonkeyPatch) -> None:
    given = ("interfaces", "Status:float32 x, string y", "Other", "", "", "minimal", "", "", "")
    found = answer(monkeypatch, Request("my_interfaces", **ADA), *given)
    assert found.msgs == ("Status:float32 x, string y", "Other")
    assert (found.nodes, found.launch, found.tests) == ((), "", "minimal")


def test_what_was_typed_is_not_asked_and_the_config_is_the_default(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    typed = Request("my_pkg", "mixed", nodes=("a1", "b1:python"), launch="yaml", tests="none", **ADA)
    assert answer(monkeypatch, typed, "", "", "", "", "", license="MIT") == typed
    said = capsys.readouterr().err
    assert "License (SPDX identifier) [MIT]: " in said
    assert "Type" not in said
    assert "Launch" not in said


def test_answers_that_end_too_soon_write_nothing(tmp_path: Path) -> None:
    done = talk("my_pkg\n\n", tmp_path)
    assert done.returncode == 2
    assert "the answers ended at `Nodes (comma-separated)" in done.stderr
    assert list(tmp_path.iterdir()) == []


def test_the_command_at_the_end_writes_the_same(tmp_path: Path) -> None:
    lines = "my_pkg\n\ntalker,counter:timer\nnav_msgs\nyaml\ngenerate\n\n"
    lines += 'humble\nDrives "it".\nMIT\nAda\nada@example.org\nci\n\n'
    done = talk(lines, tmp_path, "--into", "one")
    assert done.returncode == 0, done.stderr
    [command] = [line for line in done.stderr.splitlines() if "the same without questions: " in line]
    assert "  with         ci\n" in done.stderr
    words = shlex.split(command.partition("questions: ")[2])
    assert run_here(*words[1:], "--into", "two", cwd=tmp_path).returncode == 0
    written = {folder: content(tmp_path / folder) for folder in ("one", "two")}
    assert written["one"] == written["two"] != {}


ADA_TYPED = ("my_pkg", "--maintainer", "Ada", "--email", "ada@example.org", "--distro", "lyrical")


@pytest.mark.parametrize(
    ("said", "writes"), [("", True), ("Y", True), ("maybe\nyes", True), ("n", False), ("no", False)]
)
def test_it_writes_after_a_summary_and_a_yes(tmp_path: Path, said: str, writes: bool) -> None:
    done = talk("\n" * 9 + f"{said}\n", tmp_path, *ADA_TYPED)
    assert done.returncode == 0, done.stderr
    assert "my_pkg: ament_python, A ROS 2 node that publishes a greeting at a steady rate\n" in done.stderr
    assert "  nodes        my_pkg_node (publisher, Python)\n" in done.stderr
    assert "depends on " not in done.stderr
    assert "  with " not in done.stderr
    assert done.stderr.count("files? [Y/n] ") == 1 + said.count("\n")
    assert ("Answer y or n." in done.stderr) is ("maybe" in said)
    assert (tmp_path / "my_pkg").exists() is writes
    if writes:
        assert f"Write these {len(content(tmp_path / 'my_pkg'))} files?" in done.stderr
    else:
        assert done.stdout == ""


def test_a_family_is_confirmed_as_a_whole(tmp_path: Path) -> None:
    done = talk("\n" * 9 + "n\n", tmp_path, *ADA_TYPED, "--family")
    assert done.returncode == 0, done.stderr
    assert [f"my_pkg{end}: " in done.stderr for end in ("_interfaces", "_description", "", "_bringup")] == [True] * 4
    assert list(tmp_path.iterdir()) == []


def test_what_is_only_shown_needs_no_yes(tmp_path: Path) -> None:
    assert "[Y/n]" not in talk("\n" * 9, tmp_path, *ADA_TYPED, "--dry-run").stderr


@pytest.mark.parametrize(("option", "files"), [("--skip", 1), ("--force", 2)])
def test_of_a_folder_that_exists_only_what_changes_is_counted(tmp_path: Path, option: str, files: int) -> None:
    assert run_here("new", *ADA_TYPED, cwd=tmp_path).returncode == 0
    (tmp_path / "my_pkg" / "README.md").unlink()
    (tmp_path / "my_pkg" / "LICENSE").write_text("mine\n")
    done = talk("\n" * 9 + "n\n", tmp_path, *ADA_TYPED, option)
    assert ("Write this file? [Y/n] " if files == 1 else "Write these 2 files? [Y/n] ") in done.stderr
    assert not (tmp_path / "my_pkg" / "README.md").exists()


def test_types_kinds_and_tests_are_listed_with_what_they_are(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    answer(monkeypatch, Request("my_pkg", **ADA), *[""] * 9)
    said = [" ".join(line.split()) for line in capsys.readouterr().err.replace(": ", ":\n").splitlines()]
    assert "ament_cmake a C++ package with nodes" in said
    assert "timer a node that counts down" in said
    assert "minimal what needs neither ROS nor ament" in said
    assert "pre-commit checks before each commit" in said


def content(folder: Path) -> dict[str, bytes]:
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def test_a_command_names_what_differs_from_the_defaults() -> None:
    asked = Request("my_pkg", nodes=("a1", "b1"), params=False, extras=("ci",), own_template="../ours")
    assert command_of(asked) == "rospkg new my_pkg --node a1 --node b1 --no-params --with ci --template ../ours"


def test_without_a_name_and_without_questions_it_says_what_to_type(tmp_path: Path) -> None:
    done = run_here("new", cwd=tmp_path)
    assert done.returncode == 2
    assert "rospkg new my_robot_nav" in done.stderr
