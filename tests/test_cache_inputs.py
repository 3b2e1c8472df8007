"""Nothing that a finding depends on is outside of the cache's key and trace, by reading the sources and by watching."""

from __future__ import annotations

import ast
import dataclasses
import os
import re
import sys
from pathlib import Path

import pytest
from imports import imports, modules
from keeping import run_kept

from rospkg_cli import disk_trace
from rospkg_cli.cache.run_key import VARIABLES
from rospkg_cli.cli.lint.kept_output import may_be_kept
from rospkg_cli.cli.lint.lint_options import FixOptions, LintOptions, ReportOptions, RuleOptions, SuppressionOptions

OUTSIDE = (
    "cache",
    "cli.cache",
    "scaffold",
    "index.",
    "cli.index.run",
    "cli.new",
    "cli.format",
    "cli.inspect",
    "cli.explain",
    "cli.doctor",
    "cli.server",
    "cli.upgrade",
    "cli.change",
    "cli.add",
    "cli.rename",
    "cli.graph",
    "addition",
    "renaming",
    "change",
    "lookup",
    "cli.lint.changed_packages",
)
"""Modules of other verbs, and the cache itself."""

WRITING = ("engine.fixing", "cli.lint.add_ignores")
"""Their runs are never kept."""

OWN = {"ros.read_table", "resources", "search_path", "rule_docs", "rule_table", "report.html", "graph.as_html"}
"""They read what rospkg is made of, which the key holds as a whole."""

STREAMS = {"cli.streams", "cli.progress"}


UPDATING = {("index.cache", "glob"), ("index.cache", "lstat")}
"""What an update of the index asks."""


def lint_modules() -> list[str]:
    return [name for name in modules() if name == "index.cache" or not name.startswith((*OUTSIDE, *WRITING))]


ASKS = set(
    "stat lstat exists lexists is_file is_dir is_symlink isfile isdir islink scandir listdir iterdir glob rglob "
    "readlink realpath resolve samefile read_text read_bytes open access walk expanduser".split()
)
"""Functions and methods that ask the disk."""

NOT_THE_DISK = {
    "languages",  # what a Python file would call
    "package",  # files of a tree
    "checks",
    "edits",
    "files",
}


def test_only_one_module_asks_the_disk() -> None:
    """All others ask through it, so that a trace is whole."""
    allowed = OWN | STREAMS | {"disk_trace", "current_folder", "engine.run.rule_plugins", "report.wrap", "example"}
    for name in lint_modules():
        if name in allowed or name.partition(".")[0] in NOT_THE_DISK or name.startswith("rules"):
            continue
        for node in ast.walk(modules()[name]):
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr in ASKS:
                assert is_entry(node.func.value) or (name, node.func.attr) in UPDATING, (name, node.lineno)
    rooms = {room: {name for name in modules() if name.partition(".")[0] == room} for room in NOT_THE_DISK}
    for names in (*rooms.values(), {name for name in modules() if name.startswith("rules")}):
        for name in names:
            assert not {"disk", "disk_trace"} & imports(name), name


def is_entry(node: ast.expr) -> bool:
    """Return whether an object is an entry of a listing that `scan` made, or a rule's own pattern."""
    return isinstance(node, ast.Name) and node.id in {"entry", "each", "re", "self"}


def test_every_variable_that_lint_asks_for_is_in_the_key() -> None:
    for name in lint_modules():
        for node in ast.walk(modules()[name]):
            values = [node.slice] if isinstance(node, ast.Subscript) else []
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == "get":
                values, owner = node.args[:1], ast.unparse(node.func.value)
            elif isinstance(node, ast.Subscript):
                owner = ast.unparse(node.value)
            else:
                continue
            asked = [v.value for v in values if isinstance(v, ast.Constant)]
            if owner in ("environment", "os.environ") and name != "search_path":
                assert set(asked) <= set(VARIABLES), (name, node.lineno)


def test_every_option_is_judged() -> None:
    """A new option must be said to be harmless (it only changes what is printed) or to write."""
    known = {
        LintOptions: "paths workspace jobs allow_empty fail_on exit_zero config isolated show_settings no_cache watch "
        "changed since stdin_filename rules fixing suppression report",
        RuleOptions: "select ignore extend_select pedantic release preview target",
        FixOptions: "fix unsafe_fixes diff fix_only fix_level show_fixes exit_non_zero_on_fix",
        SuppressionOptions: "add_ignores baseline write_baseline",
        ReportOptions: "format output statistics color quiet show traceback",
    }
    for kind, names in known.items():
        assert {each.name for each in dataclasses.fields(kind)} == set(names.split()), kind
    assert may_be_kept(LintOptions())
    writing = [
        LintOptions(no_cache=True),
        LintOptions(changed=True),
        LintOptions(since=""),
        LintOptions(stdin_filename=Path("x")),
        LintOptions(fixing=FixOptions(fix=True)),
        LintOptions(suppression=SuppressionOptions(add_ignores="x")),
        LintOptions(suppression=SuppressionOptions(write_baseline=Path("x"))),
        LintOptions(report=ReportOptions(output=("json:x",))),
    ]
    assert not any(map(may_be_kept, writing))


def test_all_that_is_touched_is_in_the_trace(tmp_path: Path, write, clean, monkeypatch) -> None:
    """Watch the system's own functions: each path that lint looks at is a question of the trace."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    write(tmp_path / "ws/src/my_pkg", {**clean, "launch/a.launch.xml": "<launch/>"})
    write(tmp_path / "ws/src/other", {path: text.replace("my_pkg", "other") for path, text in clean.items()})
    (tmp_path / "ws/src/my_pkg/link").symlink_to("../other")
    touched: set[str] = set()

    def watched(function):
        def call(path, *others, **named):
            touched.add(os.fspath(path) if isinstance(path, str | os.PathLike) else "")
            return function(path, *others, **named)

        return call

    for name in ("stat", "lstat", "readlink", "scandir", "listdir"):
        monkeypatch.setattr(os, name, watched(getattr(os, name)))
    audited(touched)
    run_kept("src", "--pedantic", "--release", cwd=tmp_path / "ws")
    AUDIT.clear()
    monkeypatch.undo()
    asked = {text[1:].rstrip("/") for text in kept_questions(tmp_path / "cache/rospkg/lint")}
    parents = {str(parent) for path in asked for parent in Path(path).parents}
    below = {path.rstrip("/") for path in touched if path.startswith(str(tmp_path / "ws"))}
    missing = {path for path in below if path not in asked and path not in parents}
    assert not missing
    assert len(below) > 40


AUDIT: list[set[str]] = []


def audited(touched: set[str]) -> None:
    """Add what is opened or listed, by whatever way; a hook can't be removed, so that it asks whether it is wanted."""
    AUDIT.append(touched)

    def hook(event: str, arguments: tuple[object, ...]) -> None:
        if AUDIT and event in ("open", "os.scandir", "os.listdir") and isinstance(arguments[0], str):
            AUDIT[0].add(arguments[0])

    sys.addaudithook(hook)


def kept_questions(folder: Path) -> list[str]:
    (kept,) = folder.glob("run-*")
    return re.findall(r"(?<=\0)[krxtlnbw](?:/|\.)[^\0]*", kept.read_text("utf-8", "replace"))


@pytest.mark.parametrize("letter", "kxtrlnbw")
def test_each_kind_of_question_notes_its_answer(tmp_path: Path, letter: str) -> None:
    from rospkg_cli.cache.recheck import DISK, recheck

    (tmp_path / "a").write_text("one")
    trace = disk_trace.start_trace()
    path = str(tmp_path if letter in "ln" else tmp_path / "a")
    DISK[letter](path)
    disk_trace.stop_trace()
    questions = [(f"{letter}{path}", trace.answers[f"{letter}{path}"], "")]
    assert recheck(questions) is not None
    (tmp_path / "a").unlink()
    if letter != "x":
        (tmp_path / "a").symlink_to("b")
    (tmp_path / "c").mkdir()
    assert recheck(questions) is None
