"""`rospkg rename` on a disk: which package, what is said, and that all or nothing is written."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest
from in_process import run_here
from renaming import below, depends, named, python_package
from writing import Write

FILES = {
    **below("src/old_name", python_package("old_name", README_md="# old_name\n")),
    "src/other/package.xml": named("other", depends("old_name", tag="exec_depend")),
    "src/other/setup.py": "from setuptools import setup\n\nsetup(name='other', version='1.0.0')\n",
}
TOLD = """\
rename src/old_name to new_name
rename src/old_name/old_name to new_name
rename src/old_name/resource/old_name to new_name
edit   src/new_name/new_name/drive.py
edit   src/new_name/package.xml
edit   src/new_name/setup.cfg
edit   src/new_name/setup.py
edit   src/other/package.xml
"""
LEFT = "\n1 line with `old_name` left: prose, comments, namespaces, and names of other things than the package\n"


@pytest.fixture
def workspace(tmp_path: Path, write: Write) -> Path:
    return write(tmp_path / "ws", {path.replace("README_md", "README.md"): text for path, text in FILES.items()})


def contents(root: Path) -> dict[str, bytes]:
    return {str(path.relative_to(root)): path.read_bytes() for path in root.rglob("*") if path.is_file()}


def test_it_shows_then_writes_then_goes_back(workspace: Path) -> None:
    before = contents(workspace)
    (workspace / "src/old_name/notes.bin").write_bytes(b"\xff")
    dry = run_here("rename", "old_name", "new_name", "--dry-run", cwd=workspace)
    assert (dry.returncode, dry.stdout.partition("\n\n")[0]) == (0, TOLD.rstrip("\n"))
    assert contents(workspace).keys() == {*before, "src/old_name/notes.bin"}
    done = run_here("rename", "old_name", "new_name", "--allow-dirty", cwd=workspace)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout == f"{TOLD}{LEFT}  src/new_name/README.md:1: # old_name\n"
    assert (workspace / "src/new_name/notes.bin").read_bytes() == b"\xff"
    assert not (workspace / "src/old_name").exists()
    assert run_here("rename", "src/new_name", "old_name", "--allow-dirty", cwd=workspace).returncode == 0
    assert contents(workspace) == before | {"src/old_name/notes.bin": b"\xff"}


def test_the_diff_shows_moves_and_lines(workspace: Path) -> None:
    done = run_here("rename", "old_name", "new_name", "--diff", cwd=workspace / "src/other")
    assert done.returncode == 1
    assert "rename ../old_name to new_name\n" in done.stdout
    assert "-  <exec_depend>old_name</exec_depend>\n+  <exec_depend>new_name</exec_depend>\n" in done.stdout


@pytest.mark.parametrize(
    ("typed", "said"),
    [
        (("old_nam", "new_name"), "there is no package `old_nam` in the workspace"),
        (("old_name", "old_name"), "the package is called `old_name` already"),
        (("old_name", "other"), "`other` is the name of the package in `src/other`; choose another name"),
        (("old_name", "New-Name"), "`New-Name` can't be the name of a package"),
        (("old_name", "new_name"), "is in no git repository, so nothing could bring the old files back"),
        (("old_name",), "give the old name and the new one: `rospkg rename OLD NEW`"),
    ],
)
def test_what_can_not_be(workspace: Path, typed: tuple[str, ...], said: str) -> None:
    before = contents(workspace)
    done = run_here("rename", *typed, cwd=workspace)
    assert (done.returncode, said in done.stderr) == (2, True), done.stderr
    assert contents(workspace) == before


def test_git_must_be_able_to_bring_it_back(workspace: Path) -> None:
    def git(*words: str) -> None:
        subprocess.run(("git", "-c", "user.name=a", "-c", "user.email=a@b", *words), cwd=workspace, check=True)

    git("init", "-q")
    git("add", "-A")
    git("commit", "-qm", "all")
    (workspace / "src/old_name/new.txt").write_text("x")
    refused = run_here("rename", "old_name", "new_name", cwd=workspace)
    assert (refused.returncode, "`src/old_name/new.txt`: changes are not committed" in refused.stderr) == (2, True)
    (workspace / "src/old_name/new.txt").unlink()
    assert run_here("rename", "old_name", "new_name", cwd=workspace).returncode == 0


def test_what_a_computed_name_hides_is_refused(workspace: Path) -> None:
    launch = workspace / "src/other/launch/up.launch.py"
    launch.parent.mkdir()
    installed = "data_files=[('share/other/launch', ['launch/up.launch.py'])]"
    (launch.parents[1] / "setup.py").write_text(
        f"from setuptools import setup\n\nsetup(name='other', version='1.0.0', {installed})\n"
    )
    launch.write_text(
        "from launch_ros.actions import Node\n\n\ndef generate_launch_description():\n"
        "    owner = 'old_' 'name'\n    return [Node(package=owner, executable='drive')]  # old_name\n"
    )
    before = contents(workspace)
    done = run_here("rename", "old_name", "new_name", "--allow-dirty", cwd=workspace)
    assert (done.returncode, contents(workspace)) == (2, before)
    assert "lint would report what it does not report now" in done.stderr


def test_names_of_earlier_builds_are_told(workspace: Path) -> None:
    (workspace / "build/old_name").mkdir(parents=True)
    done = run_here("rename", "old_name", "new_name", "--dry-run", cwd=workspace / "src/old_name/resource")
    assert "are left of earlier builds" in done.stderr
    assert "the current folder gets another name" in done.stderr


def test_a_folder_that_is_the_whole_workspace_keeps_its_name(tmp_path: Path, write: Write) -> None:
    write(tmp_path, below("old_name", python_package("old_name")))
    done = run_here("rename", "old_name", "new_name", "--dry-run", cwd=tmp_path)
    assert "`old_name` keeps its name: no workspace is around it; to rename it too: mv old_name new_name" in done.stderr
    inside = run_here("rename", ".", "new_name", "--dry-run", cwd=tmp_path / "old_name")
    assert "to rename it too: mv ../old_name ../new_name" in inside.stderr
    write(tmp_path / "aside/folder", python_package("old_name"))
    other = run_here("rename", "folder", "new_name", "--dry-run", cwd=tmp_path / "aside")
    assert "the folder `folder` keeps its name: it is not that of the package" in other.stderr
