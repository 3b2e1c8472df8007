"""`rospkg add` and `rospkg remove` on a disk: which package, what is said, and that all or nothing is written."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest
from in_process import Done, run_here
from planned import plan

FOOTER = "Nothing was written.\n"


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    """A workspace with two packages."""
    for planned in (
        plan("my_pkg", launch="none", params=False, tests="none"),
        plan("other_pkg", template="interfaces"),
    ):
        for file in planned.files:
            target = tmp_path / "ws" / "src" / planned.answers.name / file.path
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(file.entry.data)
            target.chmod(file.entry.mode)
    return tmp_path / "ws"


def state(folder: Path) -> dict[str, bytes]:
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def run(cwd: Path, *arguments: str) -> Done:
    return run_here(*arguments, cwd=cwd, XDG_CACHE_HOME=str(cwd / "cache"), NO_COLOR="1")


def test_added_and_removed_again(workspace: Path) -> None:
    package = workspace / "src" / "my_pkg"
    before = state(workspace)
    done = run(package, "add", "node", "talker:publisher")
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout == "create my_pkg/talker.py\nedit   setup.py\n"
    again = run(package, "add", "node", "talker:publisher")
    assert (again.returncode, again.stdout) == (0, "")
    assert again.stderr == "rospkg: nothing is to be done: it is there as it should be\n"
    removed = run(package, "remove", "node", "talker")
    assert (removed.returncode, removed.stdout) == (0, "remove my_pkg/talker.py\nedit   setup.py\n")
    assert removed.stderr == "rospkg: `rcl_interfaces`, `rclpy`, `std_msgs` stay in package.xml: other files need it\n"
    assert state(workspace) == before


def test_shown_and_not_written(workspace: Path) -> None:
    before = state(workspace)
    dry = run(workspace, "add", "launch", "up", "--package", "my_pkg", "--dry-run")
    assert dry.returncode == 0
    assert dry.stdout == (
        "create src/my_pkg/launch/up.launch.py\nedit   src/my_pkg/package.xml\nedit   src/my_pkg/setup.py\n\n" + FOOTER
    )
    diff = run(workspace, "add", "launch", "up", "--package", "src/my_pkg", "--diff")
    assert diff.returncode == 1
    assert "+++ b/src/my_pkg/launch/up.launch.py\n" in diff.stdout
    assert "+  <exec_depend>launch_ros</exec_depend>\n" in diff.stdout
    assert state(workspace) == before


def test_which_package_must_be_clear(workspace: Path) -> None:
    several = run(workspace, "add", "params", "robot")
    assert several.returncode == 2
    assert several.stderr.startswith(
        "rospkg: `.` holds 2 packages (`src/my_pkg`, `src/other_pkg`); say which one with --package"
    )
    nowhere = run(workspace, "add", "params", "robot", "-p", "nobody")
    assert (nowhere.returncode, nowhere.stdout) == (2, "")
    assert nowhere.stderr.startswith("rospkg: `nobody` does not exist")
    empty = run(workspace.parent, "add", "params", "robot", "-p", "ws/src/my_pkg/resource")
    assert empty.returncode == 0


def test_what_lint_would_report_is_taken_back(workspace: Path) -> None:
    before = state(workspace)
    done = run(workspace / "src" / "my_pkg", "add", "dependency", "roscpp")
    assert done.returncode == 2
    first, second = done.stderr.splitlines()
    assert first == "rospkg: lint would report what it does not report now, so nothing was written"
    assert second.startswith("src/my_pkg/package.xml:")
    assert "DEP203" in second
    assert state(workspace) == before


def test_what_can_not_be_checked_is_said(workspace: Path) -> None:
    done = run(workspace / "src" / "my_pkg", "add", "dependency", "no_such_package_anywhere")
    assert done.returncode == 0
    assert done.stderr.startswith("rospkg: whether `no_such_package_anywhere` exists is not checked")


def test_lines_to_paste_are_shown(workspace: Path) -> None:
    package = workspace / "src" / "my_pkg"
    setup = package / "setup.py"
    setup.write_text(setup.read_text().replace("entry_points={", "entry_points=those() or {"))
    before = state(workspace)
    done = run(package, "add", "node", "talker:empty")
    assert done.returncode == 2
    assert done.stderr.endswith("setup.py, in entry_points['console_scripts']:\n    'talker = my_pkg.talker:main',\n")
    assert state(workspace) == before


def test_wrong_names_are_one_sentence(workspace: Path) -> None:
    package = workspace / "src" / "my_pkg"
    for arguments, said in (
        (("node", "Bad-Name"), "can't be the name of a node"),
        (("node", "x_node:nothing"), "there is no kind of node `nothing`"),
        (("msg", "Status"), "only packages of type ament_cmake can generate interfaces"),
        (("node", "x_node:publisher:Nope/Nope"), "can't be a message"),
    ):
        done = run(package, "add", *arguments)
        assert done.returncode == 2
        assert said in done.stderr
        assert done.stderr.count("\n") == 1
    assert run(package, "remove", "node", "nobody").returncode == 2


def test_a_message_of_the_workspace_can_be_used(workspace: Path) -> None:
    done = run(workspace / "src" / "my_pkg", "add", "node", "ear:subscriber:other_pkg/Status")
    assert (done.returncode, done.stderr) == (0, "")
    assert "from other_pkg.msg import Status" in (workspace / "src/my_pkg/my_pkg/ear.py").read_text()


def git(folder: Path, *arguments: str) -> None:
    command = ["git", "-c", "user.name=Ada", "-c", "user.email=ada@example.org", *arguments]
    subprocess.run(command, cwd=folder, check=True, capture_output=True)


def test_what_git_can_not_bring_back_is_kept(workspace: Path) -> None:
    package = workspace / "src" / "my_pkg"
    assert run(package, "add", "node", "talker:empty").returncode == 0
    source = package / "my_pkg" / "talker.py"
    source.write_text(source.read_text().replace("'ready'", "'set'"))
    assert "--force removes it" in run(package, "remove", "node", "talker").stderr
    assert "in no git repository" in run(package, "remove", "node", "talker", "--force").stderr
    git(workspace, "init", "-q")
    assert "are not committed" in run(package, "remove", "node", "talker", "--force").stderr
    git(workspace, "add", "-A")
    git(workspace, "commit", "-qm", "all")
    assert run(package, "remove", "node", "talker", "--force", "--dry-run").returncode == 0
    assert run(package, "remove", "node", "talker", "--force").returncode == 0
    assert not source.exists()


def test_dirty_files_go_where_that_is_asked_for(workspace: Path) -> None:
    package = workspace / "src" / "my_pkg"
    assert run(package, "add", "test", "thing").returncode == 0
    (package / "test" / "test_thing.py").write_text("# edited\n")
    assert run(package, "remove", "test", "thing", "--force", "--allow-dirty").returncode == 0
    assert not (package / "test").exists()
