"""`rospkg new -i`: a question for what was not typed, asked again after a wrong answer, with the defaults of always."""

from __future__ import annotations

import io
import shlex
import subprocess
import sys
from pathlib import Path

import pytest
from test_lint_command import rospkg

from rospkg_cli.cli.new.interactive import ask, command_of
from rospkg_cli.scaffold.answers import Request

ADA = {"maintainer": "Ada", "email": "ada@example.org", "distro": "lyrical"}


def answer(monkeypatch: pytest.MonkeyPatch, request: Request, *lines: str, **defaults: str) -> Request:
    monkeypatch.setattr("sys.stdin", io.StringIO("".join(f"{line}\n" for line in lines)))
    return ask(request, Path(), defaults)


def talk(lines: str, cwd: Path, *options: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "rospkg_cli", "new", "-i", *options]
    return subprocess.run(command, cwd=cwd, input=lines, capture_output=True, text=True)


def test_nothing_answered_is_what_nothing_typed_is(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.chdir(tmp_path)
    asked = Request("my_pkg", **ADA)
    assert answer(monkeypatch, asked, *[""] * 7) == asked


def test_every_answer_finds_its_place(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    given = (
        "my_pkg",
        "ament_cmake",
        "talker, driver:component",
        "nav_msgs",
        "xml",
        "minimal",
        "jazzy",
        "Drives.",
        "MIT",
    )
    found = answer(monkeypatch, Request(""), *given, "Ada", "ada@example.org")
    assert found == Request(
        "my_pkg", "ament_cmake", ("talker", "driver:component"), ("nav_msgs",), launch="xml", tests="minimal",
        distro="jazzy", description="Drives.", license="MIT", maintainer="Ada", email="ada@example.org",
    )  # fmt: skip
    said = capsys.readouterr()
    assert said.out == ""
    assert "License (SPDX identifier) [Apache-2.0]: " in said.err


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
        "",
        "",
        "WTFPL",
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
        "`WTFPL`",
    ):
        assert why in said


def test_messages_are_asked_for_one_by_one(monkeypatch: pytest.MonkeyPatch) -> None:
    given = ("interfaces", "Status:float32 x, string y", "Other", "", "", "minimal", "", "")
    found = answer(monkeypatch, Request("my_interfaces", **ADA), *given)
    assert found.msgs == ("Status:float32 x, string y", "Other")
    assert (found.nodes, found.launch, found.tests) == ((), "", "minimal")


def test_what_was_typed_is_not_asked_and_the_config_is_the_default(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    typed = Request("my_pkg", "mixed", nodes=("a1", "b1:python"), launch="yaml", tests="none", **ADA)
    assert answer(monkeypatch, typed, "", "", "", license="MIT") == typed
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
    lines = 'my_pkg\n\ntalker,counter:timer\nnav_msgs\nyaml\n\nhumble\nDrives "it".\nMIT\nAda\nada@example.org\n'
    done = talk(lines, tmp_path, "--into", "one")
    assert done.returncode == 0, done.stderr
    [command] = [line for line in done.stderr.splitlines() if "the same without questions: " in line]
    words = shlex.split(command.partition("questions: ")[2])
    assert rospkg(*words[1:], "--into", "two", cwd=tmp_path).returncode == 0
    written = {folder: content(tmp_path / folder) for folder in ("one", "two")}
    assert written["one"] == written["two"] != {}


def content(folder: Path) -> dict[str, bytes]:
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def test_a_command_names_what_differs_from_the_defaults() -> None:
    asked = Request("my_pkg", nodes=("a1", "b1"), params=False, extras=("ci",), own_template="../ours")
    assert command_of(asked) == "rospkg new my_pkg --node a1 --node b1 --no-params --with ci --template ../ours"


def test_without_a_name_and_without_questions_it_says_what_to_type(tmp_path: Path) -> None:
    done = rospkg("new", cwd=tmp_path)
    assert done.returncode == 2
    assert "rospkg new my_robot_nav" in done.stderr
