"""`rospkg doctor`: config, workspace, packages, index, plugins, ROS and cache, on a screen and as JSON."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest
from in_process import Done, run_here
from writing import Write

HOME = {"XDG_CONFIG_HOME": "/nowhere", "XDG_CACHE_HOME": "/nowhere"}


@pytest.fixture
def ws(tmp_path: Path, write: Write, clean: dict[str, str]) -> Path:
    folder = tmp_path / "ws"
    write(folder, {f"src/my_pkg/{path}": text for path, text in clean.items()})
    return folder


def seen(cwd: Path, *arguments: str, status: int = 0, **environment: str) -> str:
    done = run_here("doctor", *arguments, cwd=cwd, COLUMNS="500", **{**HOME, **environment})
    assert (done.returncode, done.stderr) == (status, "")
    return done.stdout


def data(cwd: Path, *arguments: str, status: int = 0, **environment: str) -> Mapping[str, Any]:
    found: Mapping[str, Any] = json.loads(seen(cwd, "--format", "json", *arguments, status=status, **environment))
    return found


def test_a_screen_names_everything_in_one_order(ws: Path) -> None:
    lines = seen(ws).splitlines()
    labels = [line[:13].strip() for line in lines if line[:1] != " "]
    assert labels == (
        ["rospkg", "config", "workspace", "packages", "index", "not checked", "targets", "plugins", "ROS", "cache"]
    )
    assert "config       none: defaults (for the run, 1 package)" in lines
    assert f"workspace    {ws}, known by `src`" in lines
    assert "packages     1 linted, 1 in the workspace" in lines
    assert "             → `rospkg index update` fetches all names" in lines
    assert "not checked  unknown package names: no index of names was fetched" in lines
    assert "targets      all: humble, jazzy, kilted, lyrical, rolling" in lines
    assert "plugins      none" in lines
    assert "ROS          none is sourced, and none is needed" in lines


def test_a_narrow_terminal_wraps_below_the_text(ws: Path) -> None:
    lines = run_here("doctor", cwd=ws, COLUMNS="70", **HOME).stdout.splitlines()
    at = next(n for n, line in enumerate(lines) if line.startswith("targets"))
    assert lines[at : at + 2] == ["targets      all: humble, jazzy, kilted, lyrical, rolling", "plugins      none"]
    assert all(len(line) <= 70 or "/" in line for line in lines)


def test_the_configs_in_force_and_their_packages(ws: Path, write: Write) -> None:
    write(ws, {"rospkg.toml": "pedantic = true\n", "src/my_pkg/rospkg.toml": 'target = ["jazzy"]\n'})
    found = data(ws)["config"]
    assert found["files"] == (
        [{"path": f"{ws}/rospkg.toml", "packages": 0}, {"path": f"{ws}/src/my_pkg/rospkg.toml", "packages": 1}]
    )
    assert f"{ws}/rospkg.toml (for the run, 0 packages)" in seen(ws)


def test_the_users_own_config_is_named(ws: Path, tmp_path: Path, write: Write) -> None:
    write(tmp_path / "etc", {"rospkg/config.toml": ""})
    assert data(ws, XDG_CONFIG_HOME=str(tmp_path / "etc"))["config"]["user"] == f"{tmp_path}/etc/rospkg/config.toml"
    assert data(ws)["config"]["user"] is None


def test_a_wrong_config_is_one_of_the_answers(ws: Path, write: Write) -> None:
    write(ws, {"rospkg.toml": "selct = []\n"})
    found = data(ws, status=1)
    assert "there is no key `selct` (did you mean `select`?)" in found["config"]["problem"]
    assert found["config"]["advice"] == "lint stops at this; repair the file, or run with --isolated"
    assert found["packages"]["linted"] == 1


def test_a_wrong_config_of_the_user_is_one_as_well(ws: Path, tmp_path: Path, write: Write) -> None:
    write(tmp_path / "etc", {"rospkg/config.toml": "x = 1\n"})
    assert "there is no key `x`" in data(ws, status=1, XDG_CONFIG_HOME=str(tmp_path / "etc"))["config"]["problem"]


def test_hidden_packages_and_what_hides_them(ws: Path, write: Write, clean: dict[str, str]) -> None:
    for name in "abcd":
        write(ws / "src/old" / name, {"package.xml": clean["package.xml"]})
    (ws / "src/old/COLCON_IGNORE").touch()
    hidden = data(ws)["packages"]["hidden"]
    assert [each["path"] for each in hidden] == [f"{ws}/src/old/{name}" for name in "abcd"]
    assert {each["by"] for each in hidden} == {f"{ws}/src/old/COLCON_IGNORE"}
    assert "and 1 more hidden package; --format json lists them" in seen(ws)
    assert f"hidden: {ws}/src/old/a, by {ws}/src/old/COLCON_IGNORE" in seen(ws)


def test_without_a_package_it_says_so_and_fails(tmp_path: Path) -> None:
    found = data(tmp_path, status=1)
    assert found["packages"]["problem"] == "nothing is linted: there is no package.xml"
    assert found["workspace"] == {"root": None, "mark": None}


def test_a_path_that_is_not_there_is_one_sentence(tmp_path: Path) -> None:
    done: Done = run_here("doctor", "nothing", cwd=tmp_path)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == "rospkg: `nothing` does not exist; give the path of a package or of a workspace\n"


@pytest.mark.parametrize("mark", [".git", "colcon.meta", ".colcon"])
def test_what_makes_it_a_workspace(tmp_path: Path, write: Write, clean: dict[str, str], mark: str) -> None:
    write(tmp_path / "my_pkg", clean)
    assert data(tmp_path)["workspace"]["mark"] is None
    write(tmp_path, {f"{mark}/x": ""})
    assert data(tmp_path)["workspace"] == {"root": str(tmp_path), "mark": mark}


def test_a_built_workspace_is_known_by_what_colcon_made(ws: Path, write: Write) -> None:
    write(ws, {"build/x": "", "install/x": "", "log/x": ""})
    assert data(ws)["workspace"]["mark"] == "build, install, log"


def test_a_list_of_absent_repositories_switches_checks_off(ws: Path, write: Write) -> None:
    write(ws, {"my.repos": "repositories:\n  base:\n    type: git\n    url: https://example.org/base.git\n"})
    reasons = data(ws)["not_checked"]["unknown_names"]
    assert reasons == ["`my.repos` lists repositories that are not here (base)", "no index of names was fetched"]


def test_targets_come_from_the_config_or_the_sourced_ros(ws: Path, write: Write) -> None:
    assert data(ws, ROS_DISTRO="jazzy")["targets"] == {"names": ["jazzy"], "source": "$ROS_DISTRO"}
    assert "targets      jazzy (from $ROS_DISTRO)" in seen(ws, ROS_DISTRO="jazzy")
    write(ws, {"rospkg.toml": 'target = ["humble", "kilted"]\n'})
    found = data(ws, ROS_DISTRO="jazzy")["targets"]
    assert found == {"names": ["humble", "kilted"], "source": f"{ws}/rospkg.toml"}


def test_the_sourced_ros_and_its_packages(ws: Path, tmp_path: Path, write: Write) -> None:
    write(tmp_path / "opt", {"share/ament_index/resource_index/packages/rclpy": ""})
    sourced = {"ROS_DISTRO": "jazzy", "AMENT_PREFIX_PATH": str(tmp_path / "opt")}
    assert data(ws, **sourced)["ros"] == {"distro": "jazzy", "prefixes": [str(tmp_path / "opt")], "packages": 1}
    assert "ROS          jazzy, 1 package, AMENT_PREFIX_PATH names 1 folder" in seen(ws, **sourced)
    assert "$ROS_DISTRO is not used: " in seen(ws, ROS_DISTRO="jazy")


def test_a_plugin_that_is_missing_is_a_problem(ws: Path, write: Write) -> None:
    write(ws, {"rospkg.toml": 'plugins = ["house"]\n'})
    assert data(ws, status=1)["plugins"]["problem"].startswith("plugins: there is no plugin `house`")


def test_the_cache_and_its_size(ws: Path, tmp_path: Path) -> None:
    here = {"XDG_CACHE_HOME": str(tmp_path / "cache")}
    folder = tmp_path / "cache/rospkg/lint"
    assert f"cache        {folder}, nothing is kept yet" in seen(ws, **here)
    folder.mkdir(mode=0o700, parents=True)
    assert data(ws, **here)["cache"] == {"path": str(folder), "files": 0, "bytes": 0}
    assert f"cache        {folder}, 0 files, 0.0 MB" in seen(ws, **here)
    folder.chmod(0o777)
    assert data(ws, **here)["cache"]["advice"].startswith("it must be a folder of yours that no one else can write")


def test_a_broken_index_is_a_problem(ws: Path, tmp_path: Path, write: Write) -> None:
    write(tmp_path / "cache", {"rospkg/index.txt": "nonsense\n"})
    found = data(ws, status=1, XDG_CACHE_HOME=str(tmp_path / "cache"))["index"]
    assert found["advice"] == "until then, the built-in names are used"
    assert "rospkg index update" in found["problem"]
