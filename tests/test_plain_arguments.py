"""What is read without typer means what typer takes it for; all else is left to typer."""

from __future__ import annotations

import inspect
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from rospkg_cli.cli.app import app_for
from rospkg_cli.cli.lint import options
from rospkg_cli.cli.lint.plain_arguments import fields, plain_arguments

ALL = sorted((name, kind) for name, kind, _ in fields() if name != "paths")
FLAGS = [f"--{name.replace('_', '-')}" for name, kind in ALL if kind == "bool"]
VALUES = [f"--{name.replace('_', '-')}" for name, kind in ALL if kind != "bool"]
PLAIN = (
    [], ["."], ["src", "a/b", "päckage", "a b"], ["src", "--pedantic", "b"], [*FLAGS, *FLAGS],
    *([each] for each in FLAGS),
    *([each, "A"] for each in VALUES), *([f"{each}=A,B=C"] for each in VALUES),
    [part for each in VALUES for part in (each, "A", "p", each, "B")],
)  # fmt: skip
NOT_PLAIN = (
    [""], ["-"], ["-q"], ["-j", "2"], ["-j2"], ["--"], ["--", "--fix"], ["--help"], ["-h"], ["--fixx"], ["--pedant"],
    ["--paths", "a"], ["--fix=1"], ["--fix="], ["--no-fix"], ["--format"], ["--format="], ["--format", ""],
    ["--format", "-x"], ["--format", "--fix"], ["src", "--select"], ["--version"], ["--rules", "A"],
)  # fmt: skip


def typers(arguments: list[str], monkeypatch: pytest.MonkeyPatch) -> dict[str, Any]:
    seen: list[dict[str, Any]] = []
    monkeypatch.setattr(options, "lint_as_typed", lambda typed: seen.append(typed) or 0)
    app_for("lint")(["lint", *arguments], prog_name="rospkg", standalone_mode=False)
    [typed] = seen
    return typed


@pytest.mark.parametrize("arguments", PLAIN, ids=" ".join)
def test_plain_arguments_mean_what_typer_takes_them_for(arguments: list[str], monkeypatch: pytest.MonkeyPatch) -> None:
    ours, expected = plain_arguments(arguments), typers(arguments, monkeypatch)
    assert ours is not None
    listed = {name for name, kind, _ in fields() if kind.startswith("tuple")}
    assert ours == {name: tuple(each or ()) if name in listed else each for name, each in expected.items()}
    assert {name: type(each) for name, each in ours.items() if name not in listed} == {
        name: type(each) for name, each in expected.items() if name not in listed
    }


@pytest.mark.parametrize("arguments", NOT_PLAIN, ids=" ".join)
def test_what_is_not_plain_is_left_to_typer(arguments: list[str]) -> None:
    assert plain_arguments(arguments) is None


def test_each_option_is_known() -> None:
    assert {name for name, _, _ in fields()} == set(inspect.signature(options.lint).parameters)


def test_a_plain_lint_does_without_typer() -> None:
    code = (
        "import sys; sys.argv = ['rospkg', 'lint', '--no-cache', '--format', 'json', '.']\n"
        "from rospkg_cli.__main__ import main; main(); sys.exit('typer' in sys.modules)"
    )
    folder = Path(__file__).parent / "corpus" / "my_robot_nav"
    assert subprocess.run([sys.executable, "-c", code], cwd=folder, capture_output=True).returncode == 0
