"""The files of the cache: damaged, foreign, half written, too many; folders that can't be used."""

from __future__ import annotations

import os
import shutil
import signal
import stat
import subprocess
import sys
import time
from pathlib import Path

import pytest
from in_process import run_here
from keeping import run_kept

from rospkg_cli.cache import kept_file, prune
from rospkg_cli.cache.folder import TAG, cache_folder
from rospkg_cli.cache.kept_file import load, save
from rospkg_cli.cache.own_code import HERE, code_digest, code_signature


@pytest.fixture
def package(tmp_path: Path, write, clean, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    return write(tmp_path / "ws/my_pkg", clean)


@pytest.fixture
def kept(tmp_path: Path) -> Path:
    return tmp_path / "cache/rospkg/lint"


def run_file(kept: Path) -> Path:
    (found,) = kept.glob("run-*")
    return found


def test_the_folder_is_marked_and_for_the_user_alone(package: Path, kept: Path) -> None:
    run_kept(cwd=package)
    assert stat.S_IMODE(kept.stat().st_mode) == 0o700
    assert (kept / "CACHEDIR.TAG").read_text() == TAG
    assert {stat.S_IMODE(path.stat().st_mode) for path in kept.glob("run-*")} == {0o600}


DAMAGES = {
    "cut": lambda data: data[: len(data) // 2],
    "empty": lambda data: b"",
    "one bit": lambda data: data[:-3] + bytes([data[-3] ^ 1]) + data[-2:],
    "another form": lambda data: data.replace(kept_file.MAGIC, b"rospkg-cache-0"),
    "noise": lambda data: os.urandom(len(data)),
    "fields": lambda data: whole(b"3\0a\0b\0c"),
    "no fields": lambda data: whole(b""),
    "not the key": lambda data: whole(data.partition(b"\n")[2].replace(b"lint", b"LINT")),
    "a field more": lambda data: whole(data.partition(b"\n")[2] + b"\0more"),
    "a status": lambda data: whole(data.partition(b"\n")[2].replace(b"\x000\0No problems", b"\0x\0No problems")),
    "no text": lambda data: whole(b"\xff\xfe"),
    "not a question": lambda data: whole(data.partition(b"\n")[2].replace(b"\0k/", b"\0?/", 1)),
}


def whole(body: bytes) -> bytes:
    return kept_file.header(body) + b"\n" + body


@pytest.mark.parametrize("how", DAMAGES)
def test_a_damaged_file_counts_as_absent_and_is_written_anew(package: Path, kept: Path, how: str) -> None:
    first = run_kept(cwd=package)
    data = run_file(kept).read_bytes()
    assert DAMAGES[how](data) != data
    run_file(kept).write_bytes(DAMAGES[how](data))
    assert run_kept(cwd=package) == first
    assert run_kept(cwd=package) == first._replace(is_served=True)


@pytest.mark.parametrize("name", ["code", "pruned"])
def test_other_damaged_files(package: Path, kept: Path, name: str) -> None:
    first = run_kept(cwd=package)
    for path in kept.glob(f"{name}*"):
        path.write_bytes(b"noise")
    run_file(kept).unlink()
    assert run_kept(cwd=package) == first
    assert run_kept(cwd=package).is_served


def test_folders_that_others_may_write_are_not_used(package: Path, kept: Path) -> None:
    run_kept(cwd=package)
    kept.chmod(0o770)
    assert run_kept(cwd=package) == run_kept(cwd=package, HOME="")
    assert "no one else can write" in run_here("cache", cwd=package).stdout
    kept.chmod(0o755)
    assert run_kept(cwd=package).is_served


@pytest.mark.skipif(os.geteuid() != 0, reason="only root can give a folder away")
def test_folders_of_others_are_not_used(package: Path, kept: Path) -> None:
    run_kept(cwd=package)
    os.chown(kept, 12345, 12345)
    assert not run_kept(cwd=package).is_served


def test_a_link_in_place_of_the_folder_is_not_used(package: Path, kept: Path) -> None:
    run_kept(cwd=package)
    kept.rename(kept.parent / "there")
    kept.symlink_to("there")
    assert not run_kept(cwd=package).is_served


@pytest.mark.parametrize("where", ["/dev/null", "/proc/nowhere", "relative"])
def test_without_a_place_nothing_is_kept_and_nothing_said(package: Path, where: str) -> None:
    first = run_kept(cwd=package, XDG_CACHE_HOME=where, HOME="")
    assert (first.status, first.err, first.is_served) == (0, "", False)
    assert run_kept(cwd=package, XDG_CACHE_HOME=where, HOME="") == first


def test_a_place_that_is_read_only(package: Path, kept: Path) -> None:
    """Root may write everywhere: a file stands in the way."""
    kept.parent.mkdir(parents=True)
    kept.write_text("in the way")
    first = run_kept(cwd=package)
    assert (first.status, first.err) == (0, "")
    assert run_kept(cwd=package) == first


def test_where_systems_have_their_caches(monkeypatch: pytest.MonkeyPatch) -> None:
    home = {"HOME": "/home/me"}
    assert cache_folder({**home, "XDG_CACHE_HOME": "/x"}) == "/x/rospkg/lint"
    monkeypatch.setattr(sys, "platform", "linux")
    assert cache_folder({**home, "XDG_CACHE_HOME": "x"}) == "/home/me/.cache/rospkg/lint"
    assert cache_folder({}) == cache_folder({"HOME": "here"}) == ""
    monkeypatch.setattr(sys, "platform", "darwin")
    assert cache_folder(home) == "/home/me/Library/Caches/rospkg/lint"
    monkeypatch.setattr(sys, "platform", "win32")
    assert cache_folder({**home, "LOCALAPPDATA": "/local"}) == "/local/rospkg/lint"


def test_fields_come_back_as_they_were(tmp_path: Path) -> None:
    path = str(tmp_path / "run-x")
    for fields in (["a", "", "é\n\udcff\ud800"], [""]):
        save(path, fields)
        assert load(path) == fields
    save(path, ["a\0b"])
    assert load(path) == [""]
    assert [each.name for each in tmp_path.iterdir()] == ["run-x"]


def test_a_full_disk_leaves_nothing_behind(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "replace", full)
    save(str(tmp_path / "run-x"), ["a"])
    assert list(tmp_path.iterdir()) == []


def test_old_files_and_too_many_go(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def kept(name: str, days: float) -> None:
        (tmp_path / name).write_bytes(b"x" * 100)
        os.utime(tmp_path / name, (time.time() - days * 86_400,) * 2)

    for name, days in {"run-new": 1, "run-old": 29, "run-gone": 31, "packages-new": 2, "mine": 99}.items():
        kept(name, days)
    kept("run-half.1.rospkg-tmp", 1)
    kept("run-now.1.rospkg-tmp", 0)
    prune.prune(str(tmp_path))
    assert names(tmp_path) == {"run-new", "run-old", "packages-new", "run-now.1.rospkg-tmp", "mine"}
    monkeypatch.setattr(prune, "MAX_TOTAL", 250)
    prune.prune(str(tmp_path))
    assert names(tmp_path) == {"run-new", "run-now.1.rospkg-tmp", "mine"}


def names(folder: Path) -> set[str]:
    return {path.name for path in folder.iterdir()}


def test_pruning_is_done_once_an_hour(tmp_path: Path) -> None:
    prune.prune_sometimes(str(tmp_path))
    stray = tmp_path / "run-x"
    stray.touch()
    os.utime(stray, (0, 0))
    prune.prune_sometimes(str(tmp_path))
    assert stray.exists()
    os.utime(tmp_path / "pruned", (0, 0))
    prune.prune_sometimes(str(tmp_path))
    assert not stray.exists()


def test_what_is_served_is_not_old(package: Path, kept: Path) -> None:
    run_kept(cwd=package)
    os.utime(run_file(kept), (time.time() - 90_000,) * 2)
    assert run_kept(cwd=package).is_served
    assert time.time() - run_file(kept).stat().st_mtime < 1_000


def test_the_command_shows_and_clears(package: Path, kept: Path) -> None:
    assert "nothing is kept yet" in run_here("cache", cwd=package).stdout
    run_kept(cwd=package)
    (kept / "mine").touch()
    shown = run_here("cache", cwd=package).stdout
    assert str(kept) in shown
    assert "MB" in shown
    assert run_here("cache", "clear", cwd=package).returncode == 0
    assert names(kept) == {"CACHEDIR.TAG", "mine"}
    assert not run_kept(cwd=package).is_served
    assert "no place" in run_here("cache", cwd=package, XDG_CACHE_HOME="", HOME="", USERPROFILE="").stdout


COMMAND = [sys.executable, "-m", "rospkg_cli", "lint"]


def test_many_at_once(package: Path, kept: Path) -> None:
    runs = [subprocess.Popen(COMMAND, cwd=package, stdout=subprocess.PIPE, text=True) for _ in range(6)]
    assert len({run.communicate()[0] for run in runs}) == 1
    assert not list(kept.glob("*.rospkg-tmp"))
    assert load(str(run_file(kept))) is not None


def test_a_process_that_is_killed_leaves_no_damage(package: Path, kept: Path) -> None:
    code = (
        "import os, signal, sys; sys.argv = ['rospkg', 'lint']\n"
        "os.replace = lambda *_: os.kill(os.getpid(), signal.SIGKILL)\n"
        "from rospkg_cli.__main__ import main; main()"
    )
    done = subprocess.run([sys.executable, "-c", code], cwd=package, capture_output=True)
    assert done.returncode == -signal.SIGKILL
    assert len(list(kept.glob("*.rospkg-tmp"))) == 1
    first = run_kept(cwd=package)
    assert (first.status, first.is_served) == (0, False)
    assert run_kept(cwd=package).is_served


def test_a_served_run_imports_next_to_nothing(package: Path) -> None:
    code = (
        "import atexit, sys; sys.argv = ['rospkg', 'lint']; before = set(sys.modules)\n"
        "atexit.register(lambda: print(*(set(sys.modules) - before), file=sys.stderr))\n"
        "from rospkg_cli.__main__ import main; sys.exit(main())"
    )
    command = [sys.executable, "-I", "-S", "-c", f"import sys; sys.path.append({str(Path(HERE).parent)!r})\n{code}"]
    site = [entry for entry in sys.path if entry.endswith("site-packages")]
    command[-1] = command[-1].replace("; sys.argv", f"; sys.path += {site!r}; sys.argv", 1)
    for _ in range(2):
        done = subprocess.run(command, cwd=package, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
    own = {name for name in done.stderr.split() if name.startswith("rospkg_cli")}
    assert len(own) < 15
    others = {name.partition(".")[0] for name in done.stderr.split()} - {"rospkg_cli"}
    assert not others & {"typer", "pathlib", "re", "json", "typing", "dataclasses", "importlib.metadata"}


def test_own_sources_are_part_of_the_key(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from rospkg_cli.cache import own_code

    shutil.copytree(HERE, tmp_path / "rospkg_cli", ignore=shutil.ignore_patterns("__pycache__"))
    monkeypatch.setattr(own_code, "HERE", str(tmp_path / "rospkg_cli"))
    monkeypatch.setattr(own_code, "YOUNG", -(10**15))
    before = code_signature(), code_digest()
    assert before == (code_signature(), code_digest())
    (tmp_path / "rospkg_cli/__pycache__").mkdir()
    (tmp_path / "rospkg_cli/__pycache__/x.pyc").touch()
    assert before == (code_signature(), code_digest())
    for change in ("rospkg_cli/rules/setup/new_rule.py", "rospkg_cli/ros/tables/more.txt"):
        (tmp_path / change).write_text("x")
        after = code_signature(), code_digest()
        assert after[0] != before[0]
        assert after[1] != before[1]
        before = after
    monkeypatch.setattr(own_code, "YOUNG", 10**15)
    assert code_signature() == ""


def test_a_plugin_s_code_counts(package: Path, tmp_path: Path, kept: Path) -> None:
    site = tmp_path / "elsewhere"
    (site / "our_house-1.0.dist-info").mkdir(parents=True)
    (site / "our_house-1.0.dist-info/METADATA").write_text("Metadata-Version: 2.1\nName: our-house\nVersion: 1.0\n")
    (site / "our_house-1.0.dist-info/entry_points.txt").write_text("[rospkg_cli.rules]\nhouse = our_house.rules\n")
    (site / "our_house").mkdir()
    (site / "our_house/__init__.py").touch()
    (site / "our_house/words.py").write_text("WORDS = 'said once'\n")
    (site / "our_house/rules.py").write_text(PLUGIN)
    (package / "rospkg.toml").write_text('plugins = ["house"]\n')
    code = f"import sys; sys.path.append({str(site)!r}); from rospkg_cli.__main__ import main; sys.exit(main())"
    command = [sys.executable, "-c", code, "lint"]

    def lint() -> str:
        return subprocess.run(command, cwd=package, capture_output=True, text=True).stdout

    assert "said once" in lint()
    assert f"{site}/our_house/words.py" in run_file(kept).read_text("utf-8", "replace")
    (site / "our_house/words.py").write_text("WORDS = 'said twice'\n")
    assert "said twice" in lint()
    (site / "our_house-1.0.dist-info").rename(site / "our_house-1.1.dist-info")
    (site / "our_house/rules.py").write_text(PLUGIN.replace("package.xml", "setup.py"))
    assert "setup.py:1:1" in lint()


PLUGIN = '''
from our_house.words import WORDS
from rospkg_cli.finding import Hit, Severity
from rospkg_cli.package.manifest import Manifest
from rospkg_cli.rule import rule
from rospkg_cli.source import Span


@rule("OUR001", "our-name", over=Manifest, severity=Severity.WARNING, examples=())
def our_name(manifest):
    """
    ## What it does
    Wants the names of our house.
    """
    yield Hit("package.xml", Span(0, 5), WORDS)
'''
