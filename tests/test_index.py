"""`rospkg index`: where names are fetched from, what is kept of them, and that the old ones stay when that fails."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace

import pytest
from in_process import run_here as rospkg
from small_rosdistro import DISTROS, FILES, distribution, index, serve

from rospkg_cli.cli import app
from rospkg_cli.index import NamesError
from rospkg_cli.index.fetch import fetch
from rospkg_cli.index.file_url import FileUrl
from rospkg_cli.ros.name_index import parse

Run = Callable[..., SimpleNamespace]


@pytest.fixture
def surroundings(tmp_path: Path) -> dict[str, str]:
    """An environment with a cache, a config and no lists of the machine's own."""
    home = {"XDG_CACHE_HOME": str(tmp_path / "cache"), "XDG_CONFIG_HOME": str(tmp_path / "config")}
    return {**home, "ROSDEP_SOURCE_PATH": "", "ROSDISTRO_INDEX_URL": "", "no_proxy": "*"}


@pytest.fixture
def run(
    tmp_path: Path,
    surroundings: dict[str, str],
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> Run:
    """Run `rospkg index …` in this process."""

    def run_index(*arguments: object, **more: str) -> SimpleNamespace:
        with monkeypatch.context() as patch:
            patch.chdir(tmp_path)
            patch.setattr(sys, "argv", ["rospkg", "index", *map(str, arguments)])
            for name, value in {**surroundings, **more}.items():
                patch.setenv(name, value)
            status = app.run()
        said = capsys.readouterr()
        return SimpleNamespace(returncode=status, stdout=said.out, stderr=said.err)

    return run_index


@pytest.fixture
def folder(tmp_path: Path, write) -> Path:
    return write(tmp_path / "rosdistro", FILES)


@pytest.fixture
def cache(tmp_path: Path) -> Path:
    return tmp_path / "cache/rospkg/index.txt"


def test_a_folder_is_read(run: Run, folder: Path, cache: Path) -> None:
    done = run("update", "--source", folder)
    assert (done.returncode, done.stderr) == (0, "")
    assert f"source    {folder}\n" in done.stdout
    assert "(today)" in done.stdout
    assert "humble        5 packages,     4 keys on Ubuntu 22.04" in done.stdout
    assert "jazzy         4 packages,     3 keys on Ubuntu 24.04" in done.stdout
    assert run("status").stdout == done.stdout
    kept = parse(cache.read_text())
    assert kept.packages["only_in_humble"] == ("humble",)
    assert kept.packages["alone"] == DISTROS
    assert "unreleased" not in kept.packages
    assert kept.keys == {
        "gripper-lib": ("apt", "apt", "apt"),
        "old-lib": ("apt", "-", "-"),
        "everywhere-pip": ("pip", "pip", "pip"),
        "python3-gripper": ("apt", "apt", "apt"),
        "mac-only": ("-", "-", "-"),
    }
    assert kept.apt == {"libgripper-dev": ("gripper-lib",), "libold-dev": ("old-lib",)}
    assert kept.pip == {"everywhere": ("everywhere-pip",)}
    assert [path.name for path in cache.parent.iterdir()] == ["index.txt"]


def test_status_as_json(run: Run, folder: Path, cache: Path) -> None:
    assert json.loads(run("status", "--format", "json").stdout) is None
    run("update", "--source", folder, "--quiet")
    told = json.loads(run("status", "--format", "json").stdout)
    assert told["age_days"] == 0
    assert told["path"] == str(cache)
    assert told["distros"]["rolling"] == {"packages": 4, "keys": 3}


def test_without_an_index_status_says_so(run: Run) -> None:
    done = run("status")
    assert done.returncode == 0
    assert "No index fetched" in done.stdout


def test_a_mirror_is_read(run: Run, cache: Path) -> None:
    with serve() as mirror:
        done = run("update", "--source", f"{mirror.url}/index-v4.yaml?token=secret")
        assert (done.returncode, done.stderr) == (0, "")
        assert all(path.endswith("?token=secret") for path in mirror.asked)
        assert "secret" not in done.stdout + cache.read_text()
        assert run("update", "--source", mirror.url).returncode == 0
        assert run("update", ROSDISTRO_INDEX_URL=f"{mirror.url}/index-v4.yaml").returncode == 0


def test_file_urls_are_read(run: Run, folder: Path) -> None:
    for url in (folder.as_uri(), f"{folder.as_uri()}/index-v4.yaml", str(folder / "index-v4.yaml")):
        assert run("update", "--source", url).returncode == 0


def test_the_config_of_the_user_names_source_and_distributions(
    run: Run, folder: Path, tmp_path: Path, write, cache: Path
) -> None:
    write(tmp_path / "config", {"rospkg/config.toml": f'[index]\nsource = "{folder}"\ndistros = ["jazzy"]\n'})
    assert run("update").returncode == 0
    assert parse(cache.read_text()).distros == ("jazzy",)
    assert run("update", "--distro", "humble,lyrical").returncode == 0
    assert parse(cache.read_text()).distros == ("humble", "lyrical")
    assert "nowhere" in run("update", ROSDISTRO_INDEX_URL="/nowhere/index-v4.yaml").stderr


def test_no_repository_says_where_names_come_from(tmp_path: Path, write, clean, surroundings) -> None:
    package = write(tmp_path / "my_pkg", {**clean, "rospkg.toml": '[index]\nsource = "https://example.org"\n'})
    done = rospkg("lint", cwd=package, **surroundings)
    assert done.returncode == 2
    assert "rospkg.toml:1:1: `index` belongs in" in done.stderr


WITHOUT_LISTS = {path: text for path, text in FILES.items() if not path.startswith("rosdep/")}

BAD_COPIES = {
    "no index": ({"README.md": ""}, "is no copy of rosdistro: it has no index-v4.yaml"),
    "a page": ({**FILES, "index-v4.yaml": "<!DOCTYPE html><p>Log in"}, "is that a page for people?"),
    "no YAML": ({**FILES, "jazzy/distribution.yaml": "a: [b\nc: }"}, "distribution.yaml is not YAML, from line 2 on"),
    "not UTF-8": ({**FILES, "rosdep/base.yaml": "\udcff\udcfe: x"}, "base.yaml is not YAML"),
    "another index": ({**FILES, "index-v4.yaml": "packages: []"}, "is no index of rosdistro: it lists no distrib"),
    "a distribution is missing": (
        {**FILES, "index-v4.yaml": index("humble", "jazzy")},
        "has no kilted and no lyrical and no rolling; ask for what it has: --distro humble,jazzy",
    ),
    "a file is missing": (
        {path: text for path, text in FILES.items() if path != "kilted/distribution.yaml"},
        "kilted/distribution.yaml can't be read: No such file or directory",
    ),
    "another file": ({**FILES, "jazzy/distribution.yaml": "type: index"}, "is no distribution file of rosdistro"),
    "a file of nothing": ({**FILES, "jazzy/distribution.yaml": ""}, "it holds no mapping"),
    "nothing released": (
        {**FILES, "jazzy/distribution.yaml": "type: distribution\nversion: 2\nrepositories:\n"},
        "releases no package for jazzy",
    ),
    "no lists": (WITHOUT_LISTS, "rosdep/base.yaml can't be read: No such file or directory"),
    "an odd list": ({**FILES, "rosdep/sources.list.d/20-default.list": "deb x y\n"}, "20-default.list:1: `deb x y`"),
}


def fails(done: SimpleNamespace, says: str) -> None:
    assert done.returncode == 2, done.stdout + done.stderr
    assert done.stdout == ""
    assert says in done.stderr
    assert done.stderr.startswith("rospkg: ")
    assert done.stderr.count("\n") == 1


@pytest.mark.parametrize("name", BAD_COPIES)
def test_a_bad_copy_is_one_sentence_and_the_old_names_stay(
    run: Run, folder: Path, tmp_path: Path, cache: Path, name: str
) -> None:
    run("update", "--source", folder, "--quiet")
    before = cache.read_bytes()
    files, says = BAD_COPIES[name]
    for path, text in files.items():
        target = tmp_path / "bad" / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(text.encode("utf-8", "surrogateescape"))
    fails(run("update", "--source", tmp_path / "bad"), says)
    assert cache.read_bytes() == before


@pytest.mark.parametrize(
    "source, says",
    [
        ("nowhere", "--source: there is no folder and no file"),
        ("ftp://example.org/x", "--source: `ftp://example.org/x` can't be read"),
        ("https:///x", "names no host"),
        ("http://[x", "`http://[x` is no URL"),
        ("http://127.0.0.1:9/index-v4.yaml", "http://127.0.0.1:9/index-v4.yaml can't be read: Connection refused"),
        ("http://me:secret@127.0.0.1:9", "rospkg: http://127.0.0.1:9/index-v4.yaml can't be read"),
    ],
)
def test_a_source_that_is_none(run: Run, source: str, says: str) -> None:
    done = run("update", "--source", source)
    fails(done, says)
    assert "secret" not in done.stderr


def test_a_distribution_that_is_none(run: Run) -> None:
    fails(run("update", "--distro", "jazy"), "there is no distribution `jazy` (did you mean `jazzy`?)")


@pytest.mark.parametrize(
    "path, wrong, says",
    [
        ("index-v4.yaml", 404, "index-v4.yaml can't be read: the server answers 404"),
        ("index-v4.yaml", 503, "index-v4.yaml can't be read: the server answers 503"),
        ("lyrical/distribution.yaml", 404, "lyrical/distribution.yaml can't be read: the server answers 404"),
        ("rolling/distribution.yaml", "cut", "bytes came; try again"),
        ("rosdep/python.yaml", 500, "rosdep/python.yaml can't be read: the server answers 500"),
        ("rosdep/python.yaml", "cut", "bytes came; try again"),
        ("rosdep/sources.list.d/20-default.list", 500, "the server answers 500"),
    ],
)
def test_a_bad_mirror_is_one_sentence_and_the_old_names_stay(
    run: Run, folder: Path, cache: Path, path: str, wrong: int | str, says: str
) -> None:
    run("update", "--source", folder, "--quiet")
    before = cache.read_bytes()
    with serve() as mirror:
        mirror.broken[path] = wrong
        fails(run("update", "--source", mirror.url), says)
    assert cache.read_bytes() == before
    assert [each.name for each in cache.parent.iterdir()] == ["index.txt"]


def test_a_server_that_says_nothing_is_not_waited_for() -> None:
    with serve() as mirror:
        mirror.broken["index-v4.yaml"] = "stall"
        with pytest.raises(NamesError, match="nothing comes from there"):
            fetch(FileUrl(f"{mirror.url}/index-v4.yaml"), timeout=0.2)


@pytest.mark.parametrize("sent, status", [(signal.SIGKILL, -signal.SIGKILL), (signal.SIGINT, 130)])
def test_killed_in_the_middle_the_old_names_stay(
    run: Run, folder: Path, tmp_path: Path, cache: Path, surroundings: dict[str, str], sent: int, status: int
) -> None:
    run("update", "--source", folder, "--quiet")
    before = cache.read_bytes()
    with serve() as mirror:
        mirror.broken["rosdep/base.yaml"] = "stall"
        command = [sys.executable, "-m", "rospkg_cli", "index", "update", "--source", mirror.url]
        process = subprocess.Popen(command, cwd=tmp_path, env={**os.environ, **surroundings}, stderr=subprocess.PIPE)
        assert mirror.stalled.wait(30)
        process.send_signal(sent)
        process.communicate(timeout=30)
    assert process.returncode == status
    assert cache.read_bytes() == before
    assert [each.name for each in cache.parent.iterdir()] == ["index.txt"]
    assert run("status").returncode == 0


def test_where_the_cache_cannot_be_the_reason_is_told(run: Run, folder: Path, tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    done = run("update", "--source", folder, XDG_CACHE_HOME=str(tmp_path / "file"))
    fails(done, "can't be written")
    done = run("update", "--source", folder, XDG_CACHE_HOME="", HOME="", USERPROFILE="")
    fails(done, "neither XDG_CACHE_HOME nor HOME is set")


BROKEN = {
    "half of it": (lambda data: data[: len(data) // 2], "is broken or half of it is missing"),
    "one letter": (lambda data: data.replace(b"wheel", b"wheal"), "is broken or half of it is missing"),
    "nothing": (lambda _: b"", "it is no index of names"),
    "garbage": (lambda _: b"\xff\xfe\0", "it is broken"),
    "a later form": (lambda data: data.replace(b"rospkg-index 1", b"rospkg-index 9"), "another version of rospkg"),
}


@pytest.mark.parametrize("how", BROKEN)
def test_a_broken_index_is_said_and_passed_over(
    run: Run, folder: Path, tmp_path: Path, cache: Path, write, clean, surroundings, how: str
) -> None:
    run("update", "--source", folder, "--quiet")
    spoil, says = BROKEN[how]
    cache.write_bytes(spoil(cache.read_bytes()))
    fails(run("status"), says)
    done = rospkg("lint", write(tmp_path / "my_pkg", clean), cwd=tmp_path, **surroundings)
    assert done.returncode == 0
    assert says in done.stderr
    assert done.stderr.count("\n") == 1
    assert "`rospkg index update` makes it anew; until then, the built-in names are used" in done.stderr
    assert run("update", "--source", folder).returncode == 0
    assert run("status").returncode == 0


def test_later_files_of_a_distribution_replace_repositories(run: Run, tmp_path: Path, write, cache: Path) -> None:
    listed = "type: index\nversion: 4\ndistributions:\n  jazzy: {distribution: [jazzy/distribution.yaml, ours.yaml]}\n"
    own = distribution("our_driver")
    folder = write(tmp_path / "company", {**FILES, "index-v4.yaml": listed, "ours.yaml": own})
    assert run("update", "--source", folder, "--distro", "jazzy").returncode == 0
    assert set(parse(cache.read_text()).packages) == {"our_driver", "alone"}
