"""What commands print of packages, templates and typed names holds nothing that a terminal or a log would obey."""

from __future__ import annotations

import io
import json
import re
from pathlib import Path

import pytest

from rospkg_cli.cli import progress
from rospkg_cli.cli.app import run
from rospkg_cli.cli.format.run import format_manifests
from rospkg_cli.cli.inspect.run import inspect
from rospkg_cli.report.color import paint

RAW = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069\u2028\ufeff\ud800-\udfff]")
HOSTILE = r"a\x1b]0;x\x07\x9b2J\u202e\r\n::error::x\ud800"
"""As Python's source writes it."""


def is_safe(text: str) -> bool:
    """Return whether nothing is obeyed: no character of RAW, no line that begins with `::`."""
    return not RAW.search(text) and not re.search(r"(?m)^\s*::", text)


@pytest.fixture
def hostile(tmp_path: Path, clean: dict[str, str], write) -> Path:
    """A package whose entry points, installed files and launch file hold hostile texts."""
    entry = f"    entry_points={{'console_scripts': ['{HOSTILE} = my_pkg.b{HOSTILE}:m']}},\n"
    setup = clean["setup.py"].replace("    extras_require", f"{entry}    extras_require")
    assert HOSTILE in setup
    launch = (
        "from launch import LaunchDescription\nfrom launch.actions import DeclareLaunchArgument, ExecuteProcess\n"
        "from launch_ros.actions import Node\n\n\ndef generate_launch_description():\n"
        f"    return LaunchDescription([DeclareLaunchArgument('{HOSTILE}', default_value='{HOSTILE}'),\n"
        f"        Node(package='{HOSTILE}', executable='{HOSTILE}', name='{HOSTILE}', parameters=['{HOSTILE}']),\n"
        f"        ExecuteProcess(cmd=['{HOSTILE}', '{HOSTILE}'])])\n"
    )
    package = write(tmp_path / "my_pkg", {**clean, "setup.py": setup, "launch/a.launch.py": launch})
    (package / "launch" / "b\x1b[31m\n::error::\x9b.launch.py").write_text(launch)
    (package / "c\x1b").mkdir()
    return package


def test_inspect_shows_tables_that_are_safe(hostile: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(hostile)
    for form in ("text", "json"):
        stream = io.StringIO()
        assert inspect([], format=form, stream=stream) == 0
        assert is_safe(stream.getvalue()), form
        assert "\\u001b" in stream.getvalue() or "\\x1b" in stream.getvalue()
    json.loads(stream.getvalue())


@pytest.mark.parametrize(
    "options", ["", "--diff", "--statistics", "--fix", "--format concise", "--add-ignores x --traceback"]
)
def test_lint_prints_nothing_raw(hostile: Path, options: str, monkeypatch: pytest.MonkeyPatch, capsys) -> None:
    monkeypatch.chdir(hostile.parent)
    monkeypatch.setattr("sys.argv", ["rospkg", "lint", "--pedantic", "--color", "never", *options.split()])
    assert run() in (0, 1)
    said = capsys.readouterr()
    assert is_safe(said.out)
    assert is_safe(said.err)


def test_format_names_files_safely(tmp_path: Path, clean: dict[str, str], write, monkeypatch, capsys) -> None:
    manifest = clean["package.xml"].replace("  <name>", "  <license>MIT\x9b</license>\n  <name>")
    write(tmp_path / "a\x1b\n::error::\u202e" / "my_pkg", {**clean, "package.xml": manifest})
    write(tmp_path / "b\x1b\n::error::\u202e" / "my_b", {**clean, "package.xml": "<package>\x1b"})
    monkeypatch.chdir(tmp_path)
    for check, diff in ((False, True), (True, False), (False, False)):
        assert format_manifests((), check, diff) == 1
        said = capsys.readouterr()
        assert is_safe(said.out)
        assert is_safe(said.err)


@pytest.mark.parametrize("more", ["--dry-run", "--diff", ""])
def test_new_shows_a_strangers_template_safely(tmp_path: Path, more: str, monkeypatch, capsys, write) -> None:
    template = write(
        tmp_path / "template",
        {
            "template.toml": 'title = "x\\u001b[31m"\n',
            "files/package.xml.j2": "<package/>\n",
            "files/NOTES.md.j2": "\x1b]0;x\x07\n::error::x\n\u202e\x9b\n",
        },
    )
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("sys.argv", ["rospkg", "new", "my_new", "--template", str(template), *more.split()])
    run()
    said = capsys.readouterr()
    assert is_safe(said.out), said.out
    assert is_safe(said.err), said.err


@pytest.mark.parametrize(
    "typed",
    [
        ["lint", "a\n::error::\x1b"], ["lint", "--select", "A\x1b\n::error::"], ["lint", "--\n::error::\x1b"], ["\x1b"],
        ["explain", "\x1b\n::x"], ["new", "\x1b\n::x"], ["rules", "--format", "\x1b"], ["inspect", "\x1b\udcff"],
        ["graph", "\n::x\x1b"],
        ["lint", "--baseline", "\x1b\udcff", "."], ["format", "\n::x\x1b"],
    ],
)  # fmt: skip
def test_what_was_typed_comes_back_on_one_safe_line(typed: list[str], tmp_path: Path, monkeypatch, capsys) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("sys.argv", ["rospkg", *typed])
    assert run() == 2
    said = capsys.readouterr()
    assert (said.out, said.err.count("\n")) == ("", 1)
    assert is_safe(said.err)


def test_a_fault_of_ours_is_told_safely(tmp_path: Path, monkeypatch, capsys) -> None:
    def raises(*_: object) -> int:
        raise RuntimeError("a\n::error::\x1b\udcff")

    monkeypatch.setattr("rospkg_cli.cli.lint.run.lint", raises)
    monkeypatch.chdir(tmp_path)
    for more in ([], ["--traceback"]):
        monkeypatch.setattr("sys.argv", ["rospkg", "lint", *more])
        assert run() == 3
        said = capsys.readouterr().err
        assert is_safe(said)
        assert ("Traceback" in said) == bool(more)
        assert said.splitlines()[-1].startswith("rospkg: internal error: RuntimeError: a\\n::error::\\x1b\\udcff")


def test_progress_is_no_markup() -> None:
    assert progress.plain_text("reading [red]\x1b[31m[/nonsense]").plain == "reading [red]\\x1b[31m[/nonsense]"


def test_colour_is_ours() -> None:
    assert paint("x", "red", True) == "\x1b[1;31mx\x1b[0m"
