"""`rospkg new` when things go wrong: killed, no space left."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from in_process import run_here as rospkg
from test_robust_fix import tiny_disk as tiny_disk

NEW = ["new", "my_robot_nav", "--maintainer", "Ada", "--email", "ada@example.org"]


def killed_after(files: int, cwd: Path) -> int:
    """Run `rospkg new`, killed before it writes one more file than `files`; return the exit status."""
    code = (
        "import os, signal, sys; from rospkg_cli.scaffold import write as writing\n"
        "real, done = writing.write, []\n"
        "def write(path, file):\n"
        f"    if len(done) == {files}: os.kill(os.getpid(), signal.SIGKILL)\n"
        "    done.append(path)\n"
        "    real(path, file)\n"
        "writing.write = write\n"
        f"sys.argv = ['rospkg', *{NEW!r}]\n"
        "from rospkg_cli.__main__ import main; sys.exit(main())"
    )
    return subprocess.run([sys.executable, "-c", code], cwd=cwd, capture_output=True).returncode


@pytest.mark.parametrize("files", [0, 1, 9])
def test_killed_in_the_middle_there_is_no_package(tmp_path: Path, files: int) -> None:
    assert killed_after(files, tmp_path) == -9
    assert not (tmp_path / "my_robot_nav").exists()
    assert all(path.name.startswith(".") for path in tmp_path.iterdir()), "colcon looks into no hidden folder"
    again = rospkg(*NEW, cwd=tmp_path)
    assert again.returncode == 0, again.stderr
    assert [path.name for path in tmp_path.iterdir()] == ["my_robot_nav"], "what the killed run left is gone"
    assert rospkg("lint", "--pedantic", "my_robot_nav", cwd=tmp_path).returncode == 0


def test_a_full_disk_is_said_and_nothing_is_left(tiny_disk: Path) -> None:
    with (tiny_disk / "ballast").open("wb", buffering=0) as ballast:
        ballast.write(b"x" * 4096 * 10)
    done = rospkg(*NEW, cwd=tiny_disk)
    assert done.returncode == 2
    assert "No space left on device; nothing was" in done.stderr
    assert [path.name for path in tiny_disk.iterdir()] == ["ballast"]


@pytest.mark.parametrize("given", [NEW, ["lint"]])
def test_a_folder_that_was_removed_under_the_shell(given: list[str], tmp_path: Path) -> None:
    code = (
        "import os, sys; from rospkg_cli.__main__ import main; os.rmdir(os.getcwd())\n"
        f"sys.argv = ['rospkg', *{given!r}]; sys.exit(main())"
    )
    ran = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True)
    assert ran.returncode == 2
    assert ran.stderr == "rospkg: the current folder was removed; change to one that is there (`cd`)\n"
