"""Links: a package may be reached through one; what one leads to out of the package and its repository is not read."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest
from in_process import run_here as rospkg

from rospkg_cli.disk import DiskTree
from rospkg_cli.engine.discovery.locate import locate
from rospkg_cli.report import FORMATS

SECRET = "token = 'ghp_very_secret_0123456789'"


@pytest.fixture
def secret(tmp_path: Path) -> Path:
    target = tmp_path / "outside" / "secret.txt"
    target.parent.mkdir()
    target.write_text(SECRET + "\n")
    return target


def test_a_link_to_a_package_is_a_package(tmp_path: Path, write, clean) -> None:
    write(tmp_path / "dev/foo", clean)
    (tmp_path / "ws/src").mkdir(parents=True)
    (tmp_path / "ws/src/foo").symlink_to(tmp_path / "dev/foo")
    done = rospkg("lint", cwd=tmp_path / "ws")
    assert (done.returncode, done.stderr) == (0, "")
    assert "(1 package" in done.stdout
    located = locate([tmp_path / "ws/src/foo"])
    assert (located.root, located.scope.selected) == (tmp_path / "ws", {"src/foo"})


def test_a_linked_package_may_be_fixed(tmp_path: Path, write, clean) -> None:
    write(
        tmp_path / "dev/foo",
        {**clean, "package.xml": clean["package.xml"].replace("<package format", "<package  format")},
    )
    (tmp_path / "dev/foo/resource/my_pkg").unlink()
    (tmp_path / "ws/src").mkdir(parents=True)
    (tmp_path / "ws/src/foo").symlink_to(tmp_path / "dev/foo")
    done = rospkg("lint", "--fix", cwd=tmp_path / "ws")
    assert (tmp_path / "dev/foo/resource/my_pkg").is_file(), done.stdout + done.stderr


def test_links_to_folders_of_packages_circles_and_doubles(tmp_path: Path, write, clean) -> None:
    for name in ("a", "b"):
        write(tmp_path / "repo" / name, {"package.xml": clean["package.xml"].replace("my_pkg", name)})
    write(tmp_path / "ws/src/c", {"package.xml": clean["package.xml"].replace("my_pkg", "c")})
    (tmp_path / "ws/src/repo").symlink_to(tmp_path / "repo")
    (tmp_path / "ws/src/again").symlink_to(tmp_path / "repo/a")
    (tmp_path / "ws/src/up").symlink_to("..")
    (tmp_path / "repo/back").symlink_to(tmp_path / "ws")
    (tmp_path / "ws/root").symlink_to("/")
    assert locate([tmp_path / "ws"]).scope.folders == ("src/again", "src/c", "src/repo/b")


@pytest.mark.parametrize(
    "name", ["setup.py", "package.xml", "launch/x.launch.py", "launch/a.launch.yaml", "config/p.yaml"]
)
def test_a_link_out_is_neither_read_nor_shown_nor_rewritten(
    tmp_path: Path, write, clean, secret: Path, name: str
) -> None:
    package = write(tmp_path / "pkg", clean)
    (package / name).unlink(missing_ok=True)
    (package / name).parent.mkdir(exist_ok=True)
    (package / name).symlink_to(secret)
    shown = {}
    for form in FORMATS:
        done = rospkg("lint", "--pedantic", "--release", "--format", form, cwd=package)
        assert done.returncode in (0, 1), done.stderr
        assert "ghp_very" not in done.stdout + done.stderr
        shown[form] = done.stdout
    assert f"`{name}` is a link to `{secret}`" in shown["markdown"].replace("\\", "") or "config" in name
    for command in (("lint", "--fix", "--unsafe-fixes"), ("format",), ("inspect",), ("lint", "--add-ignores", "why")):
        done = rospkg(*command, cwd=package)
        assert done.returncode in (0, 1, 2), done.stderr
        assert "ghp_very" not in done.stdout + done.stderr
    assert secret.read_text() == SECRET + "\n"
    assert (package / name).is_symlink()


def test_a_link_within_the_repository_is_read(tmp_path: Path, write, clean) -> None:
    package = write(tmp_path / "repo/pkg", clean)
    write(tmp_path / "repo", {"shared/x.launch.py": "def generate_launch_description(:\n"})
    (package / "launch").mkdir()
    (package / "launch/x.launch.py").symlink_to("../../shared/x.launch.py")
    assert DiskTree(package).files()["launch/x.launch.py"] == "outside"
    (tmp_path / "repo/.git").mkdir()
    assert DiskTree(package).files()["launch/x.launch.py"] == "link"
    assert "is not valid Python" in rospkg("lint", cwd=package).stdout


def test_nothing_is_created_through_a_link_out(tmp_path: Path, write, clean) -> None:
    """A fix that makes the marker must not make it in a folder that a link leads to, nor where a dead link points."""
    for number, target in enumerate(("outside", "outside/my_pkg")):
        (tmp_path / f"{number}/outside").mkdir(parents=True)
        package = write(tmp_path / f"{number}/pkg", clean)
        (package / "resource/my_pkg").unlink()
        if target == "outside":
            (package / "resource").rmdir()
            (package / "resource").symlink_to("../outside")
        else:
            (package / "resource/my_pkg").symlink_to("../../outside/my_pkg")
        done = rospkg("lint", "--fix", "--unsafe-fixes", cwd=package)
        assert done.returncode in (0, 1, 2), done.stderr
        assert list((tmp_path / f"{number}/outside").iterdir()) == []


def test_devices_and_endless_files_are_not_opened(tmp_path: Path, write, clean) -> None:
    package = write(tmp_path / "pkg", clean)
    (package / "my_pkg/zero.py").symlink_to("/dev/zero")
    (package / "my_pkg/kmsg.py").symlink_to("/proc/kmsg")
    os.mkfifo(package / "my_pkg/pipe.py")
    done = rospkg("lint", cwd=package)
    assert done.returncode in (0, 1), done.stderr


@pytest.mark.parametrize("place", ["package.xml", "setup.py", "my_pkg/__init__.py", "resource/my_pkg"])
@pytest.mark.parametrize("kind", ["folder", "dead", "fifo"])
def test_another_thing_in_a_file_s_place(tmp_path: Path, write, clean, place: str, kind: str) -> None:
    package = write(tmp_path / "ws/src/pkg", clean)
    write(tmp_path / "ws/src/other", {**clean, "package.xml": clean["package.xml"].replace("my_pkg", "other")})
    (package / place).unlink()
    if kind == "folder":
        (package / place).mkdir()
    elif kind == "dead":
        (package / place).symlink_to("nowhere")
    else:
        os.mkfifo(package / place)
    for command in (
        ("lint", "--pedantic", "--release"),
        ("lint", "--fix"),
        ("lint", "--diff"),
        ("inspect",),
        ("format", "--check"),
    ):
        done = rospkg(*command, cwd=tmp_path / "ws")
        assert done.returncode in (0, 1, 2), done.stderr
        assert "RPK005" not in done.stdout
        assert "internal error" not in done.stderr


def test_siblings_are_known(tmp_path: Path, write, clean) -> None:
    for name in ("my_a", "my_b"):
        write(tmp_path / "e3" / name, {k.replace("my_pkg", name): v.replace("my_pkg", name) for k, v in clean.items()})
    located = locate([tmp_path / "e3/my_b"])
    assert (located.scope.folders, located.scope.selected) == (("my_a", "my_b"), {"my_b"})


@pytest.mark.parametrize("variable", ["HOME", "TMPDIR"])
def test_what_lies_in_a_home_is_no_sibling(tmp_path: Path, write, clean, monkeypatch, variable: str) -> None:
    monkeypatch.setenv(variable, str(tmp_path))
    for name in ("my_a", "my_b"):
        write(tmp_path / name, {"package.xml": clean["package.xml"].replace("my_pkg", name)})
    assert locate([tmp_path / "my_b"]).scope.folders == ("",)


def test_folders_thousands_deep(tmp_path: Path, write, clean) -> None:
    package = write(
        tmp_path / "pkg",
        {**clean, "setup.py": clean["setup.py"].replace("find_packages(exclude=['test'])", "find_packages()")},
    )
    try:
        dig(package / "my_pkg", 2_000)
        for command in (("lint", "--pedantic"), ("inspect",), ("lint", "--fix")):
            done = rospkg(*command, cwd=package)
            assert done.returncode == 0, done.stdout[:500] + done.stderr[:500]
    finally:
        subprocess.run(["rm", "-rf", package], check=True)  # Python's own rmtree recurses


def dig(folder: Path, depth: int) -> None:
    """Make folders in folders by their descriptors, since no path may be as long."""
    here = os.open(folder, os.O_RDONLY)
    for _ in range(depth):
        os.mkdir("d", dir_fd=here)
        inner = os.open("d", os.O_RDONLY, dir_fd=here)
        os.close(here)
        here = inner
    os.close(here)


@pytest.mark.parametrize(
    ("glob", "target", "count"),
    [
        ("glob('config/*.yaml')", "nowhere", 1),
        ("glob('config/*.yaml')", "a.yaml", 0),
        ("glob('config/*.yml')", "nowhere", 0),
        ("glob('*.yaml')", "nowhere", 0),
        ("[each for each in glob('config/*.yaml') if os.path.isfile(each)]", "nowhere", 0),
    ],
)
def test_a_glob_matches_a_link_to_nothing(tmp_path: Path, write, clean, glob: str, target: str, count: int) -> None:
    imports = "import os\nfrom glob import glob\n"
    entry = "('share/' + package_name, ['package.xml']),"
    more = f"{entry}\n        ('share/' + package_name + '/config', {glob}),"
    write(tmp_path, {**clean, "setup.py": imports + clean["setup.py"].replace(entry, more), "config/a.yaml": "a: 1\n"})
    (tmp_path / "config/b.yaml").symlink_to(target)
    done = rospkg("lint", "--select", "SET205", cwd=tmp_path)
    assert done.stdout.count("a link to nothing here: the build stops") == count
