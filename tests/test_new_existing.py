"""`rospkg new` where there is a folder of that name: nothing of the user's is lost, and all is written or nothing."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from rospkg_cli.cli import UsageError
from rospkg_cli.cli.new.run import new
from rospkg_cli.engine.fixing.signals import stopped_by_signals
from rospkg_cli.scaffold import existing_folder
from rospkg_cli.scaffold.answers import Request
from rospkg_cli.scaffold.answers_record import RECORD

ADA = {"maintainer": "Ada Lovelace", "email": "ada@example.org", "year": 2026, "distro": "lyrical"}
NAME = "my_robot_nav"
PACKAGE = Path(NAME)


@pytest.fixture(autouse=True)
def there(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Path:
    """A package that its user went on with."""
    monkeypatch.chdir(tmp_path)
    assert new(Request("my_robot_nav", **ADA)) == 0
    (PACKAGE / "setup.py").write_text("# mine\n")
    (PACKAGE / "notes.txt").write_text("mine too\n")
    (PACKAGE / "launch/my_robot_nav.launch.py").unlink()
    (PACKAGE / "launch").rmdir()
    capsys.readouterr()
    return tmp_path


def content(folder: Path) -> dict[str, bytes]:
    return {p.relative_to(folder).as_posix(): p.read_bytes() for p in sorted(folder.rglob("*")) if p.is_file()}


def again(**options: object) -> int:
    return new(Request("my_robot_nav", **ADA), **options)


def test_nothing_is_touched_unasked(there: Path) -> None:
    before = content(there)
    with pytest.raises(UsageError, match=r"exists already .*--diff .*--skip .*--force"):
        again()
    assert content(there) == before


def test_skip_writes_what_is_missing(there: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert again(existing="skip") == 0
    assert (PACKAGE / "setup.py").read_text() == "# mine\n"
    assert (PACKAGE / "launch/my_robot_nav.launch.py").is_file()
    assert [path.name for path in there.iterdir()] == ["my_robot_nav"]
    said = capsys.readouterr().err
    assert "rospkg: 1 file written, " in said
    assert "; `setup.py` lacks what would be written there: --diff shows it, " in said


def test_each_file_has_a_status_and_those_left_alone_say_what_they_lack(capsys: pytest.CaptureFixture[str]) -> None:
    more = Request("my_robot_nav", nodes=("my_robot_nav_node", "extra:timer"), **ADA)
    assert new(more, existing="skip") == 0
    said = capsys.readouterr().out
    assert "created    my_robot_nav/extra.py\nidentical  my_robot_nav/greeting.py\n" in said
    lacking = said.partition("skipped    setup.py   differs, and lacks:\n")[2].splitlines()
    assert lacking[0].strip().startswith("# Copyright 2026 Ada Lovelace")
    assert lacking[6].strip().startswith("and ")
    assert lacking[6].endswith(" more: --diff shows them")
    assert "skipped    README.md   differs, and lacks:\n" in said
    assert "             ### extra\n" in said
    assert "skipped    .rospkg-answers.toml   holds other answers; `rospkg new --update` merges\n" in said
    assert "├" not in said
    assert "Next" in said


@pytest.mark.parametrize(("how", "word"), [("skip", "skipped"), ("force", "replaced")])
def test_a_file_that_differs_without_a_line_less_or_is_no_text(
    capsys: pytest.CaptureFixture[str], how: str, word: str
) -> None:
    (PACKAGE / "README.md").write_text((PACKAGE / "README.md").read_text() + "more\n")
    (PACKAGE / "setup.cfg").write_bytes(b"\xff\xfe\x00")
    (PACKAGE / RECORD).write_text("")
    assert again(existing=how) == 0
    said, told = capsys.readouterr()
    assert ("; `setup.py` lacks" in told, "README.md" in told) == (how == "skip", False)
    assert f"{word:<9}  README.md" in said
    assert ("README.md   differs, and lacks no line\n" in said) is (how == "skip")
    assert ("setup.cfg   differs, and is no text\n" in said) is (how == "skip")


def test_a_refusal_shows_which_files_are_in_conflict(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(UsageError, match=r"--force .*, `rospkg new --update my_robot_nav` merges"):
        again()
    said = capsys.readouterr().err
    assert "identical  package.xml\n" in said
    assert "conflict   setup.py   differs, and lacks:\n" in said
    assert "created    launch/my_robot_nav.launch.py\n" in said


def test_skip_is_silent_of_files_that_are_as_they_should_be(there: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert again(existing="force") == 0
    (PACKAGE / "launch/my_robot_nav.launch.py").unlink()
    capsys.readouterr()
    assert again(existing="skip") == 0
    assert "lack" not in capsys.readouterr().err


def test_force_replaces_and_keeps_what_was_there(there: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert again(existing="force") == 0
    assert "find_packages" in (PACKAGE / "setup.py").read_text()
    assert (PACKAGE / "notes.txt").read_text() == "mine too\n"
    assert content(there / "my_robot_nav.orig") == {"COLCON_IGNORE": b"", "setup.py": b"# mine\n"}
    assert "1 replaced: what was there is in" in capsys.readouterr().err
    (PACKAGE / "setup.py").write_text("# mine again\n")
    assert again(existing="force") == 0
    assert (there / "my_robot_nav.orig2/setup.py").read_text() == "# mine again\n"
    assert again(existing="force") == 0
    assert sorted(path.name for path in there.iterdir()) == ["my_robot_nav", "my_robot_nav.orig", "my_robot_nav.orig2"]


@pytest.mark.parametrize("how, shown", [("", True), ("force", True), ("skip", False)])
def test_a_diff_shows_what_would_change_and_writes_nothing(
    there: Path, capsys: pytest.CaptureFixture[str], how: str, shown: bool
) -> None:
    before = content(there)
    assert again(diff=True, existing=how) == 1
    said = capsys.readouterr().out
    assert content(there) == before
    assert ("--- a/my_robot_nav/setup.py\n+++ b/my_robot_nav/setup.py\n" in said) == shown
    assert "--- /dev/null\n+++ b/my_robot_nav/launch/my_robot_nav.launch.py\n" in said
    assert said.count("+++ ") == 1 + shown


def test_the_diff_is_one_that_patch_applies(capsys: pytest.CaptureFixture[str]) -> None:
    again(diff=True)
    said = capsys.readouterr().out
    subprocess.run(["patch", "-p1", "--silent"], input=said, text=True, check=True)
    assert again(diff=True) == 0
    assert capsys.readouterr().out == ""


def test_a_diff_of_a_file_that_is_no_text_says_so(capsys: pytest.CaptureFixture[str]) -> None:
    (PACKAGE / "setup.py").write_bytes(b"\xff\x00")
    assert again(diff=True) == 1
    assert "Binary files a/my_robot_nav/setup.py and b/my_robot_nav/setup.py differ\n" in capsys.readouterr().out


def test_where_nothing_is_every_option_writes_or_shows_all(capsys: pytest.CaptureFixture[str]) -> None:
    assert new(Request("other_pkg", **ADA), diff=True) == 1
    assert "+++ b/other_pkg/package.xml" in capsys.readouterr().out
    assert not Path("other_pkg").exists()
    for name, how in (("other_pkg", "force"), ("another_pkg", "skip")):
        assert new(Request(name, **ADA), existing=how) == 0
        assert Path(name, "package.xml").is_file()


def obstacle_folder() -> None:
    (PACKAGE / "setup.cfg").unlink()
    (PACKAGE / "setup.cfg").mkdir()


def obstacle_link() -> None:
    Path("elsewhere").mkdir()
    (PACKAGE / "launch").symlink_to(Path("elsewhere").absolute())


def obstacle_file() -> None:
    (PACKAGE / "launch").write_text("")


def obstacle_dead_link() -> None:
    (PACKAGE / "launch").mkdir()
    (PACKAGE / "launch/my_robot_nav.launch.py").symlink_to("nowhere")


@pytest.mark.parametrize("how", ["force", "skip"])
@pytest.mark.parametrize(
    "obstacle, why",
    [
        (obstacle_folder, "not a file"),
        (obstacle_link, "a link"),
        (obstacle_file, "not a folder"),
        (obstacle_dead_link, "no"),
    ],
)
def test_what_stands_in_the_way_is_left_alone(there: Path, how: str, obstacle, why: str) -> None:
    obstacle()
    before = content(there)
    with pytest.raises(UsageError, match=why):
        again(existing=how)
    assert content(there) == before
    assert {path.name for path in there.iterdir()} <= {"my_robot_nav", "elsewhere"}


def test_a_link_to_a_file_is_never_replaced() -> None:
    Path("setup.py").write_text("# shared\n")
    (PACKAGE / "setup.py").unlink()
    (PACKAGE / "setup.py").symlink_to("../setup.py")
    with pytest.raises(UsageError, match="is a link"):
        again(existing="force")
    assert Path("setup.py").read_text() == "# shared\n"
    assert not (PACKAGE / "launch").exists()
    assert again(existing="skip") == 0


def test_a_file_in_the_place_of_the_package_is_refused() -> None:
    Path("taken_name").write_text("mine")
    for how in ("force", "skip"):
        with pytest.raises(UsageError, match="not a folder"):
            new(Request("taken_name", **ADA), existing=how)
    assert Path("taken_name").read_text() == "mine"


@pytest.mark.parametrize("error", [OSError(28, "No space left on device"), KeyboardInterrupt()])
@pytest.mark.parametrize("after", range(3))
def test_whatever_fails_all_is_as_it_was(
    there: Path, monkeypatch: pytest.MonkeyPatch, after: int, error: BaseException
) -> None:
    before, real, moved = content(there), existing_folder.move, []

    def move(source: Path, target: Path, undo: list) -> None:
        real(source, target, undo)
        moved.append(target)
        if len(moved) > after:
            raise error

    monkeypatch.setattr(existing_folder, "move", move)
    with pytest.raises((UsageError, KeyboardInterrupt)):
        again(existing="force")
    assert len(moved) == after + 1
    assert content(there) == before
    assert [path.name for path in there.iterdir()] == ["my_robot_nav"]
    assert not (PACKAGE / "launch").exists()


STOPPED = """
import os, signal, sys
signal.signal(signal.SIGINT, signal.default_int_handler)
signal.signal(signal.SIGHUP, signal.SIG_DFL)  # the tests may run below nohup, or in the background
from rospkg_cli.scaffold import {module} as module
real, done = module.{name}, []
def stopped(*args):
    real(*args)
    done.append(args)
    if len(done) == {after}:
        os.kill(os.getpid(), signal.{signal})
module.{name} = stopped
sys.argv = ['rospkg', 'new', *{asked!r}, '--maintainer', 'Ada', '--email', 'ada@example.org']
from rospkg_cli.__main__ import main
sys.exit(main())
"""


@pytest.mark.parametrize("number, status", [("SIGINT", 130), ("SIGTERM", 143), ("SIGHUP", 129)])
@pytest.mark.parametrize(
    "place, after, asked",
    [
        ("write.write", 2, ["new_pkg"]),
        ("write.write", 20, ["my_r2", "--family"]),
        ("existing_folder.move", 2, [NAME, "--force"]),
    ],
)
def test_a_signal_leaves_nothing_half_written(
    there: Path, number: str, status: int, place: str, after: int, asked: list[str]
) -> None:
    before = content(there)
    module, name = place.split(".")
    code = STOPPED.format(module=module, name=name, after=after, signal=number, asked=asked)
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60)
    assert (done.returncode, done.stdout) == (status, "")
    assert done.stderr == "rospkg: interrupted; no partial files were left\n"
    assert content(there) == before
    assert [path.name for path in there.iterdir()] == ["my_robot_nav"]


def test_a_signal_that_is_ignored_from_outside_stays_so() -> None:
    before = signal.signal(signal.SIGHUP, signal.SIG_IGN)
    try:
        with stopped_by_signals():
            os.kill(os.getpid(), signal.SIGHUP)
    finally:
        signal.signal(signal.SIGHUP, before)
