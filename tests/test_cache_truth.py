"""The cache's truth: one thing after another changes, and a run with the cache says what one without it says."""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest
from keeping import Run, run_kept

from rospkg_cli import disk_trace
from rospkg_cli.example import manifest
from rospkg_cli.index.cache import cache_index
from rospkg_cli.ros.name_index import Index

ALL = ("--format", "json", "--pedantic", "--release", "--preview")


@pytest.fixture(params=["young", "old"])
def workspace(request, tmp_path: Path, write, clean, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Two packages in a workspace, in which files count as young (they are read again) or as old (they are not)."""
    monkeypatch.setattr(disk_trace, "YOUNG", 10**15 if request.param == "young" else -(10**15))
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    monkeypatch.delenv("TMPDIR", raising=False)
    folder = tmp_path / "ws"
    (folder / "src").mkdir(parents=True)
    write(folder / "src/my_pkg", clean)
    write(folder / "src/other", {path: text.replace("my_pkg", "other") for path, text in clean.items()})
    write(folder / "src/other", {"msg/Old.msg": "int32 x\n", "data/a.txt": "a"})
    (folder / "src/my_pkg/config").mkdir()
    (folder / "src/my_pkg/config/linked.yaml").symlink_to("../shared.yaml")
    write(folder / "src/my_pkg", {"shared.yaml": "my_node:\n  ros__parameters:\n    x: 1\n"})
    return folder


def edit(path: str, old: str, new: str) -> Callable[[Path], None]:
    def change(workspace: Path) -> None:
        target = workspace / path
        text = target.read_text()
        assert old in text
        target.write_text(text.replace(old, new))

    return change


def add(path: str, text: str = "") -> Callable[[Path], None]:
    def change(workspace: Path) -> None:
        target = workspace / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text)

    return change


def same_look(workspace: Path) -> None:
    """Change a file without changing its size or its time of modification."""
    target = workspace / "src/my_pkg/package.xml"
    before, text = target.stat(), target.read_text()
    target.write_text(text.replace("<version>1.0.0<", "<version>1.0.x<"))
    assert target.stat().st_size == before.st_size
    os.utime(target, ns=(before.st_atime_ns, before.st_mtime_ns))


def link_elsewhere(workspace: Path) -> None:
    link = workspace / "src/my_pkg/config/linked.yaml"
    link.unlink()
    link.symlink_to("/etc/hostname")


def replace_folder(workspace: Path) -> None:
    shutil.rmtree(workspace / "src/my_pkg/resource")
    (workspace / "src/my_pkg/resource").write_text("")


def old_index(workspace: Path) -> None:
    names = {"rclpy": ("jazzy",), "launch": ("jazzy",)}
    index = Index("file:///x", "2026-01-01T00:00:00Z", ("jazzy",), names, {})
    cache_index(index, {"XDG_CACHE_HOME": str(workspace.parent / "cache")})


CHANGES: dict[str, Callable[[Path], None]] = {
    "a file is edited": edit("src/my_pkg/package.xml", "Apache-2.0", "Apache"),
    "its looks stay": same_look,
    "a file is added": add("src/my_pkg/launch/b.launch.py", "def wrong(:\n"),
    "a file is removed": lambda ws: (ws / "src/my_pkg/setup.cfg").unlink(),
    "a file is renamed": lambda ws: Path(ws / "src/my_pkg/my_pkg").rename(ws / "src/my_pkg/their_pkg"),
    "a folder is a file": replace_folder,
    "a file may be executed": lambda ws: (ws / "src/my_pkg/setup.py").chmod(0o755),
    "a file can't be decoded": lambda ws: (ws / "src/my_pkg/setup.py").write_bytes(b"\xff\xfe\xfa"),
    "the target of a link is edited": edit("src/my_pkg/shared.yaml", "x: 1", "x: [1, a]"),
    "a link leads elsewhere": link_elsewhere,
    "a neighbour's version": edit("src/other/package.xml", "<version>1.0.0<", "<version>9.0.0<"),
    "a neighbour's name": edit("src/other/package.xml", "<name>other<", "<name>my_pkg<"),
    "a neighbour goes": lambda ws: shutil.rmtree(ws / "src/other"),
    "a package comes": add("src/third/package.xml", manifest().replace("my_pkg", "third")),
    "a package is marked as ignored": add("src/other/COLCON_IGNORE"),
    "a list of repositories": add("src/more.repos", "repositories: {elsewhere: {type: git}}\n"),
    "a config comes": add("rospkg.toml", 'ignore = { XML = "not now" }\n'),
    "a nearer config": add("src/pyproject.toml", "[tool.rospkg]\npedantic = false\nselect = ['SET']\n"),
    "a mark of a repository": lambda ws: (ws / "src/other/.git").mkdir(),
    "a license above": add("src/LICENSE", "Apache License\nVersion 2.0, January 2004\n"),
    "a list of ignored files": add("src/my_pkg/.gitignore", "my_pkg/\nconfig/\n"),
    "a marked workspace above": lambda ws: [(ws.parent / name).mkdir() for name in ("build", "install", "log")],
    "a build folder": add("src/my_pkg/build/COLCON_IGNORE"),
    "an index": old_index,
    "a comment that ignores": edit("src/my_pkg/setup.py", "import", "# rospkg: ignore[SET101] why not\nimport"),
}


@pytest.mark.parametrize("what", CHANGES)
def test_each_change_is_seen(workspace: Path, what: str) -> None:
    first = run_kept("src", *ALL, cwd=workspace)
    assert not first.is_served
    assert run_kept("src", *ALL, cwd=workspace) == first._replace(is_served=True)
    CHANGES[what](workspace)
    told = run_kept("src", *ALL, cwd=workspace)
    assert told == truth(workspace)
    assert run_kept("src", *ALL, cwd=workspace)[:3] == told[:3]


def truth(workspace: Path, *arguments: str, **environment: str) -> Run:
    return run_kept(*(arguments or ("src", *ALL)), "--no-cache", cwd=workspace, **environment)


@pytest.mark.parametrize("name, value", [("ROS_DISTRO", "humble"), ("AMENT_PREFIX_PATH", "{ws}/prefix")])
def test_the_environment_counts(workspace: Path, write, name: str, value: str) -> None:
    edit("src/my_pkg/package.xml", "</package>", "  <depend>sensor_msg</depend>\n</package>")(workspace)
    add("prefix/share/ament_index/resource_index/packages/else")(workspace)
    given = {name: value.format(ws=workspace)}
    run_kept("src", *ALL, cwd=workspace)
    told = run_kept("src", *ALL, cwd=workspace, **given)
    assert told == truth(workspace, **given)
    add("prefix/share/ament_index/resource_index/packages/sensor_msg")(workspace)
    after = run_kept("src", *ALL, cwd=workspace, **given)
    assert after[:3] == truth(workspace, **given)[:3]
    assert (after.out != told.out) == (name == "AMENT_PREFIX_PATH")


def test_options_and_the_current_folder_count(workspace: Path) -> None:
    for arguments in (("src",), ("src", "--pedantic"), ("src", "--select", "XML"), ("src", "--target", "humble")):
        assert not run_kept(*arguments, cwd=workspace).is_served
    assert run_kept("src", cwd=workspace).is_served
    assert not run_kept("../src", cwd=workspace / "src").is_served
    assert not run_kept("src", cwd=workspace, NO_COLOR="1").is_served


@pytest.mark.parametrize("jobs", ["1", "2"])
def test_what_worker_processes_read_counts(workspace: Path, jobs: str) -> None:
    first = run_kept("src", *ALL, "--jobs", jobs, cwd=workspace)
    assert run_kept("src", *ALL, "--jobs", jobs, cwd=workspace) == first._replace(is_served=True)
    edit("src/other/setup.py", "packages=", "zip_safe=3, packages=")(workspace)
    add("src/other/other/__init__.py", "import unheard_of\n")(workspace)
    told = run_kept("src", *ALL, "--jobs", jobs, cwd=workspace)
    assert told[:3] == truth(workspace)[:3]
    assert told.out != first.out


def test_names_that_are_never_source_change_nothing(workspace: Path) -> None:
    first = run_kept("src", cwd=workspace)
    add("src/my_pkg/__pycache__/x.pyc")(workspace)
    add("src/my_pkg/.pytest_cache/x")(workspace)
    assert run_kept("src", cwd=workspace) == first._replace(is_served=True)


def test_a_checkout_with_new_times_is_served_by_content(workspace: Path) -> None:
    first = run_kept("src", cwd=workspace)
    shutil.copytree(workspace, workspace.parent / "copy", symlinks=True)
    shutil.rmtree(workspace)
    (workspace.parent / "copy").rename(workspace)
    for path in workspace.rglob("*"):
        os.utime(path, follow_symlinks=False)
    assert run_kept("src", cwd=workspace) == first._replace(is_served=True)


@pytest.mark.parametrize("option", [["--fix"], ["--diff"], ["--output", "json:r.json"], ["--write-baseline", "b.json"]])
def test_what_writes_is_done_each_time(workspace: Path, option: list[str]) -> None:
    edit("src/my_pkg/package.xml", "Apache-2.0", "Apache")(workspace)
    run_kept("src", *option, cwd=workspace)
    assert not run_kept("src", *option, cwd=workspace).is_served


def test_a_baseline_counts(workspace: Path) -> None:
    edit("src/my_pkg/package.xml", "Apache-2.0", "Apache")(workspace)
    run_kept("src", "--write-baseline", "b.json", cwd=workspace)
    told = run_kept("src", "--baseline", "b.json", cwd=workspace)
    assert run_kept("src", "--baseline", "b.json", cwd=workspace) == told._replace(is_served=True)
    (workspace / "b.json").write_text('{"schema": 1, "findings": []}')
    after = run_kept("src", "--baseline", "b.json", cwd=workspace)
    assert (after.is_served, after.out == told.out) == (False, False)


def test_a_run_that_said_something_is_not_kept(workspace: Path) -> None:
    (workspace.parent / "cache/rospkg").mkdir(parents=True)
    (workspace.parent / "cache/rospkg/index.txt").write_text("no index")
    assert "is of no use" in run_kept("src", cwd=workspace).err
    again = run_kept("src", cwd=workspace)
    assert ("is of no use" in again.err, again.is_served) == (True, False)


@pytest.mark.parametrize("where", ["src/.cache", "src/my_pkg/.cache", "src/my_pkg"])
def test_a_cache_in_the_linted_tree_is_no_part_of_it(workspace: Path, where: str) -> None:
    """As where CI keeps only what lies in the project."""
    place = {"XDG_CACHE_HOME": str(workspace / where)}
    told = [run_kept("src", *ALL, cwd=workspace, **place) for _ in range(3)]
    assert told[2] == truth(workspace, **place)._replace(is_served=True)
    assert run_kept("src", "--pedantic", cwd=workspace, **place).status == told[0].status
    assert run_kept("src", *ALL, cwd=workspace, **place).is_served
