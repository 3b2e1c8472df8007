"""`rospkg lint --changed` and `--since`: the packages that differ, by the real git."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest
from in_process import run_here
from writing import Write


@pytest.fixture
def ws(tmp_path: Path, write: Write, clean: dict[str, str]) -> Path:
    """A repository with two packages whose manifests have a placeholder, and a commit of them."""
    folder = tmp_path / "ws"
    for name in ("a_pkg", "b_pkg"):
        files = {path.replace("my_pkg", name): text.replace("my_pkg", name) for path, text in clean.items()}
        files["package.xml"] = files["package.xml"].replace("Apache-2.0", "TODO")
        write(folder / name, files)
    git(folder, "init", "-q", "-b", "main")
    commit(folder)
    return folder


def git(folder: Path, *arguments: str) -> None:
    who = ("-c", "user.name=Ada", "-c", "user.email=ada@example.org")
    subprocess.run(["git", *who, *arguments], cwd=folder, check=True, capture_output=True)


def commit(folder: Path) -> None:
    git(folder, "add", "-A")
    git(folder, "commit", "-q", "-m", "A commit")


def touched(package: Path) -> None:
    path = package / "package.xml"
    path.write_text(path.read_text() + "\n")


def named(ws: Path, *arguments: str) -> set[str]:
    done = run_here("lint", "--format", "concise", *arguments, cwd=ws)
    assert (done.returncode in (0, 1), done.stderr) == (True, "")
    return {line.partition("/")[0] for line in done.stdout.splitlines() if ": " in line and "XML104" in line}


def test_all_are_linted_without_the_options(ws: Path) -> None:
    assert named(ws) == {"a_pkg", "b_pkg"}


def test_what_is_not_committed(ws: Path) -> None:
    assert named(ws, "--changed") == set()
    touched(ws / "b_pkg")
    assert named(ws, "--changed") == {"b_pkg"}
    git(ws, "add", "-A")
    assert named(ws, "--changed") == {"b_pkg"}


def test_a_new_file_is_a_change_and_an_ignored_one_is_none(ws: Path) -> None:
    (ws / ".gitignore").write_text("*.log\n")
    commit(ws)
    (ws / "a_pkg/run.log").touch()
    assert named(ws, "--changed") == set()
    (ws / "a_pkg/new.txt").touch()
    assert named(ws, "--changed") == {"a_pkg"}


def test_a_removed_file_is_a_change(ws: Path) -> None:
    (ws / "a_pkg/setup.cfg").unlink()
    assert named(ws, "--changed") == {"a_pkg"}


def test_since_a_branch_counts_its_commits_and_what_is_not_committed(ws: Path) -> None:
    git(ws, "checkout", "-q", "-b", "topic")
    touched(ws / "a_pkg")
    commit(ws)
    assert named(ws, "--changed") == set()
    assert named(ws, "--since", "main") == {"a_pkg"}
    touched(ws / "b_pkg")
    assert named(ws, "--since", "main") == {"a_pkg", "b_pkg"}


def test_commits_of_the_other_branch_are_no_change(ws: Path) -> None:
    git(ws, "checkout", "-q", "-b", "topic")
    touched(ws / "a_pkg")
    commit(ws)
    git(ws, "checkout", "-q", "main")
    touched(ws / "b_pkg")
    commit(ws)
    git(ws, "checkout", "-q", "topic")
    assert named(ws, "--since", "main") == {"a_pkg"}


def test_without_a_commit_everything_is_new(ws: Path, tmp_path: Path) -> None:
    (ws / ".git").rename(tmp_path / "gone")
    git(ws, "init", "-q")
    assert named(ws, "--changed") == {"a_pkg", "b_pkg"}
    git(ws, "add", "a_pkg")
    assert named(ws, "--changed") == {"a_pkg", "b_pkg"}


def test_each_repository_of_a_workspace_is_asked(ws: Path) -> None:
    git(ws / "b_pkg", "init", "-q")
    commit(ws / "b_pkg")
    assert named(ws, "--changed") == set()
    touched(ws / "b_pkg")
    assert named(ws, "--changed") == {"b_pkg"}


def test_neighbours_are_known_though_not_linted(ws: Path) -> None:
    path = ws / "a_pkg/package.xml"
    path.write_text(path.read_text().replace("<export>", "<depend>b_pkg</depend>\n  <export>"))
    assert "DEP001" not in run_here("lint", "--changed", cwd=ws).stdout


def test_the_answer_is_not_kept_for_later(ws: Path, tmp_path: Path) -> None:
    cached = {"XDG_CACHE_HOME": str(tmp_path / "cache")}
    assert "0 packages" in run_here("lint", "--changed", cwd=ws, **cached).stdout
    git(ws, "rm", "-q", "--cached", "a_pkg/package.xml")
    assert "1 package" in run_here("lint", "--changed", cwd=ws, **cached).stdout


def test_a_name_that_git_does_not_know(ws: Path) -> None:
    done = run_here("lint", "--since", "nothing", cwd=ws)
    says = f"rospkg: git can't say what has changed in `{ws}`: fatal: Not a valid object name nothing\n"
    assert (done.returncode, done.stdout, done.stderr) == (2, "", says)


def test_a_name_is_no_option_of_git(ws: Path) -> None:
    done = run_here("lint", "--since=--output=x", cwd=ws)
    assert (done.returncode, (ws / "x").exists()) == (2, False)


def test_outside_of_a_repository_it_says_so(tmp_path: Path, write: Write, clean: dict[str, str]) -> None:
    write(tmp_path / "my_pkg", clean)
    done = run_here("lint", "--changed", cwd=tmp_path)
    assert done.returncode == 2
    assert "lies in no git repository, so what has changed is unknown; leave --changed, --since out" in done.stderr


def test_without_git_it_says_so(ws: Path, tmp_path: Path) -> None:
    done = run_here("lint", "--changed", cwd=ws, PATH=str(tmp_path))
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.startswith("rospkg: git can't be started: ")
