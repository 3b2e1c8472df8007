"""Changes to packages that exist: in memory step by step, judged by lint, and written all or nothing."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from rospkg_cli.change import ChangeError, NotUnderstoodError, Paste
from rospkg_cli.change.draft import Draft
from rospkg_cli.change.git_state import require_clean, uncommitted
from rospkg_cli.change.judge import judge, refuse_new
from rospkg_cli.disk import DiskTree
from rospkg_cli.engine.fixing.write import WriteError
from rospkg_cli.engine.fixing.write_all import write_all
from rospkg_cli.engine.run.scope import Scope
from rospkg_cli.engine.run.session import Session
from rospkg_cli.engine.selection import EVERYTHING
from rospkg_cli.example import manifest
from rospkg_cli.fence import Fence
from rospkg_cli.finding import Chmod, Create, Delete, Edit, Move
from rospkg_cli.source import Span
from rospkg_cli.tree import MemoryTree, TreeEntry


def draft() -> Draft:
    return Draft(MemoryTree.of({"a/package.xml": manifest(), "a/one.txt": "one\n", "b.txt": "b"}))


def test_each_step_sees_the_one_before() -> None:
    made = draft()
    made.apply("a", (Edit("one.txt", Span(0, 0), "zero "), Create("src/new.py", "x\n")))
    made.apply("a", (Edit("one.txt", Span(0, 4), "ZERO"), Move("src/new.py", "src/moved.py")))
    assert made.tree.entry("a/one.txt").data == b"ZERO one\n"
    assert made.package("a").files.exists("src/moved.py")
    assert sorted(made.changes) == ["a/one.txt", "a/src/moved.py"]
    assert list(made.created()) == ["a/src/moved.py"]


def test_what_comes_back_is_no_change() -> None:
    made = draft()
    made.apply("", (Edit("b.txt", Span(0, 0), "a"), Delete("a/one.txt")))
    other = made.copy()
    made.apply("", (Edit("b.txt", Span(0, 1), ""), Create("a/one.txt", "one\n")))
    assert made.changes == {}
    assert sorted(other.changes) == ["a/one.txt", "b.txt"]


def test_an_executable_bit_is_a_change() -> None:
    made = draft()
    made.apply("", (Chmod("b.txt", True),))
    assert made.changes["b.txt"] == TreeEntry("file", b"b", 0o755)


def test_edits_that_overlap_are_refused() -> None:
    with pytest.raises(ValueError, match="overlap"):
        draft().apply("", (Edit("a/one.txt", Span(0, 2), "a"), Edit("a/one.txt", Span(1, 3), "b")))


def test_a_text_that_an_encoding_can_not_hold_is_refused() -> None:
    latin = "<?xml version='1.0' encoding='iso-8859-1'?><a/>"
    with pytest.raises(ChangeError, match="encoding that can't hold"):
        Draft(MemoryTree.of({"a.xml": latin})).apply("", (Edit("a.xml", Span(0, 0), "⚙"),))


def session(files: dict[str, str]) -> Session:
    return Session(MemoryTree.of(files), Scope(("a",), frozenset({"a"})), EVERYTHING.codes())


def test_only_what_is_new_is_refused() -> None:
    text = manifest().replace("Drives my robot", "TODO")
    before = session({"a/package.xml": text})
    changed = Draft(before.tree)
    changed.apply("a", (Edit("package.xml", Span(0, 0), "\n"),))
    assert [each.code for each in judge(before, changed).new] == ["RPK001"]
    moved = Draft(before.tree)
    at = text.index("  <maintainer")
    moved.apply("a", (Edit("package.xml", Span(at, at), "\n"),))
    judged = judge(before, moved)
    assert judged.before.findings
    assert judged.new == ()


def test_a_refusal_shows_what_lint_says() -> None:
    before = session({"a/package.xml": manifest()})
    changed = Draft(before.tree)
    changed.apply("a", (Edit("package.xml", Span(0, 0), "\n"),))
    with pytest.raises(ChangeError, match="nothing was written") as refused:
        refuse_new(judge(before, changed).new)
    assert refused.value.details[0].startswith("a/package.xml:")
    refuse_new(())


def test_what_is_not_understood_comes_with_lines_to_paste() -> None:
    error = NotUnderstoodError("`setup.py` is computed; paste this", Paste("setup.py", "a\n\nb"))
    assert str(error) == "`setup.py` is computed; paste this"
    assert error.details == ("setup.py:", "    a", "", "    b")


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "one.txt").write_text("one\n")
    (tmp_path / "sub").mkdir()
    (tmp_path / "sub" / "two.txt").write_text("two\n")
    return tmp_path


def write(folder: Path, *operations: Edit | Create | Delete, meanwhile: str = "") -> None:
    tree = DiskTree(folder)
    made = Draft(tree)
    made.apply("", operations)
    if meanwhile:
        (folder / meanwhile).write_text("changed\n")
    write_all(folder, tree, made.changes, Fence(folder))


def test_everything_is_written_and_empty_folders_go(folder: Path) -> None:
    write(folder, Edit("one.txt", Span(0, 0), "zero "), Create("new/deep/x.py", "#!x\n", True), Delete("sub/two.txt"))
    assert (folder / "one.txt").read_text() == "zero one\n"
    assert (folder / "new/deep/x.py").stat().st_mode & 0o100
    assert not (folder / "sub").exists()


def test_nothing_is_written_where_one_file_can_not_be(folder: Path) -> None:
    with pytest.raises(WriteError, match=r"changed by someone else meanwhile.*nothing was written"):
        write(
            folder,
            Create("made/x.py", ""),
            Edit("one.txt", Span(0, 0), "zero "),
            Delete("sub/two.txt"),
            meanwhile="sub/two.txt",
        )
    assert (folder / "one.txt").read_text() == "one\n"
    assert sorted(path.name for path in folder.iterdir()) == ["one.txt", "sub"]
    assert (folder / "sub" / "two.txt").read_text() == "changed\n"


def test_a_removed_file_comes_back_where_another_can_not_be_written(folder: Path) -> None:
    (folder / "z.txt").write_text("z")
    (folder / "z.txt").chmod(0o444)
    with pytest.raises(WriteError, match=r"`z.txt` can't be written: the file is read-only; nothing was written"):
        write(folder, Delete("one.txt"), Edit("z.txt", Span(0, 0), "a"))
    assert (folder / "one.txt").read_text() == "one\n"


def git(folder: Path, *arguments: str) -> None:
    identity = ("-c", "user.name=Ada", "-c", "user.email=ada@example.org")
    subprocess.run(["git", *identity, *arguments], cwd=folder, check=True, capture_output=True)


def test_git_must_be_able_to_bring_everything_back(folder: Path) -> None:
    with pytest.raises(ChangeError, match=r"no git repository.*--allow-dirty"):
        require_clean(folder)
    git(folder, "init", "-q")
    assert uncommitted(folder) == ["one.txt", "sub/two.txt"]
    git(folder, "add", "-A")
    git(folder, "commit", "-qm", "all")
    require_clean(folder)
    (folder / "sub" / "two.txt").write_text("other")
    with pytest.raises(ChangeError, match=r"`sub/two\.txt`: changes are not committed; commit or stash"):
        require_clean(folder / "sub")
    require_clean(folder, ["one.txt"])
    require_clean(folder, [])
    for number in range(4):
        (folder / f"{number}.txt").write_text("")
    with pytest.raises(ChangeError, match=r"`\w.*`, `\d\.txt`, `\d\.txt` and 2 more: changes"):
        require_clean(folder)
