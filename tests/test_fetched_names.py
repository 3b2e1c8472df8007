"""What an index that was fetched changes in `rospkg lint`: unknown names are told, and nothing is asked in vain."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from in_process import run_here as rospkg
from small_rosdistro import DISTROS

from rospkg_cli.cli import UsageError
from rospkg_cli.cli.new.run import new
from rospkg_cli.engine.discovery.incomplete_workspace import missing_packages
from rospkg_cli.engine.run.scope import Scope
from rospkg_cli.engine.run.session import Session
from rospkg_cli.example import BACKDROPS, existing_files, manifest
from rospkg_cli.finding import Finding, Severity
from rospkg_cli.index.cache import cache_index
from rospkg_cli.ros.distros import Targets
from rospkg_cli.ros.name_index import Index, dump, parse
from rospkg_cli.ros.names import FetchedNames
from rospkg_cli.scaffold.answers import Request
from rospkg_cli.tree import MemoryTree

INDEX = Index(
    "/a/copy",
    "2026-11-01T12:00:00Z",
    DISTROS,
    {"rclpy": DISTROS, "wheel_odometry": DISTROS[1:], "only_in_humble": ("humble",), "gone": ("humble", "jazzy")},
    {
        "gripper-lib": ("apt", "apt", "apt"),
        "old-lib": ("apt", "-", "-"),
        "nowhere-lib": ("-", "-", "-"),
        "python3-gripper": ("apt", "apt", "apt"),
        "now-pip": ("apt", "pip", "pip"),
    },
    {"gripperlib": ("python3-gripper",)},
    {"libgripper-dev": ("gripper-lib",)},
)


VCS = "repositories:\n  x:\n    type: git\n    url: https://example.org/x.git\n"


def lint(body: str, *targets: str, codes: str = "DEP001", complete: bool = True) -> list[Finding]:
    """Lint a package that declares something, where the index is known."""
    scope = Scope(
        ("",), frozenset({""}), "my_pkg", "" if complete else "packages are missing", index=FetchedNames(dump(INDEX))
    )
    files = existing_files({**BACKDROPS["ament_python"], "package.xml": manifest(body)})
    return list(Session(MemoryTree.of(files), scope, frozenset({codes}), Targets(targets)).run().findings)


@pytest.mark.parametrize("missing", [frozenset(), frozenset({"wheels"})])
def test_a_plain_project_of_the_workspace_is_no_misspelt_name(missing: frozenset[str]) -> None:
    """It is told at the same level, whatever repositories are missing: it is here."""
    projects = (("wheel_odometri", "libs/odometry"), ("my_math", "math"))
    more = {"missing_repositories": missing, "cmake_projects": projects, "index": FetchedNames(dump(INDEX))}
    scope = Scope(("",), frozenset({""}), "my_pkg", "repositories are missing" if missing else "", **more)
    body = need("wheel_odometri") + need("my_math")
    files = existing_files({**BACKDROPS["ament_python"], "package.xml": manifest(body)})
    found = Session(MemoryTree.of(files), scope, frozenset({"DEP001"}), Targets()).run().findings
    assert [(each.severity, each.fix) for each in found] == [(Severity.WARNING, None)] * 2
    assert "it is a plain CMake project here (`libs/odometry`): give it a package.xml" in found[0].message
    assert found[1].message.endswith("or have rosdep skip it (`--skip-keys my_math`)")


def said(body: str, *targets: str, complete: bool = True) -> list[str]:
    return [finding.message.partition(": `rosdep")[0] for finding in lint(body, *targets, complete=complete)]


def need(name: str, condition: str = "") -> str:
    attribute = f' condition="{condition}"' if condition else ""
    return f"  <exec_depend{attribute}>{name}</exec_depend>\n"


@pytest.mark.parametrize(
    "name, targets, says",
    [
        ("wheel_odometry", (), None),
        ("gripper-lib", ("jazzy", "humble"), None),
        ("wheel_odometri", (), "`wheel_odometri` is no known ROS package or rosdep key"),
        ("my_companys_driver", ("rolling",), "`my_companys_driver` is no ROS package and no rosdep key"),
        ("gripperlib", (), "`gripperlib` is its name on PyPI"),
        ("libgripper-dev", (), "`libgripper-dev` is its name in Ubuntu"),
        ("only_in_humble", (), None),
        ("only_in_humble", ("humble",), None),
        ("only_in_humble", ("humble", "jazzy"), "`only_in_humble` is released for humble and not for jazzy"),
        ("gone", ("kilted", "lyrical"), "`gone` is released for humble and jazzy and not for kilted and lyrical"),
        ("gone", ("rolling",), None),
        ("old-lib", (), None),
        ("old-lib", ("humble",), None),
        ("old-lib", ("jazzy", "kilted"), "`old-lib` is a rosdep key without a rule for Ubuntu 24.04"),
        ("nowhere-lib", (), "`nowhere-lib` is a rosdep key without a rule for Ubuntu 22.04, 24.04 and 26.04"),
        ("sensor_msgs", (), None),
    ],
)
def test_what_is_said_of_a_name(name: str, targets: tuple[str, ...], says: str | None) -> None:
    """A package that the index lacks and that is built in (`sensor_msgs`) can't be told."""
    assert said(need(name), *targets) == ([says] if says else [])


def test_what_to_do_is_told() -> None:
    (finding,) = lint(need("wheel_odometri"))
    assert finding.message.endswith('[wheel_odometri]"; did you mean `wheel_odometry`?')
    assert finding.fix
    (finding,) = lint(need("old-lib"), "jazzy")
    assert 'ends with "No definition of [old-lib] for OS version [noble]"' in finding.message
    (finding,) = lint(need("only_in_humble"), "jazzy")
    assert finding.message.endswith('or do without it there: condition="$ROS_DISTRO != jazzy"')
    assert finding.severity is Severity.INFO


@pytest.mark.parametrize(
    "body, targets, count",
    [
        (need("only_in_humble", "$ROS_DISTRO == humble"), ("humble", "jazzy"), 0),
        (need("only_in_humble", "$ROS_DISTRO != humble"), ("humble", "jazzy"), 1),
        (need("only_in_humble", "$ROS_DISTRO != humble"), (), 1),
        (need("my_companys_driver", "$ROS_VERSION == 1"), (), 0),
        (need("my_companys_driver", "$WITH_OURS == 1"), ("jazzy",), 1),
        ("  <doc_depend>my_companys_docs</doc_depend>\n", ("jazzy",), 0),
        (need("rospy"), ("jazzy",), 0),
    ],
)
def test_conditions_and_tags_count(body: str, targets: tuple[str, ...], count: int) -> None:
    assert len(said(body, *targets)) == count


def test_where_packages_are_missing_nothing_can_be_told() -> None:
    assert said(need("my_companys_driver"), "jazzy", complete=False) == []
    assert said(need("only_in_humble"), "jazzy", complete=False) == []


def test_keys_from_pypi_are_those_of_the_index() -> None:
    assert [f.code for f in lint(need("now-pip"), "jazzy", codes="DEP002")] == ["DEP002"]
    assert lint(need("now-pip"), "humble", codes="DEP002") == []


@pytest.mark.parametrize(
    "files, incomplete",
    [
        ({}, False),
        ({"ours.repos": ""}, True),
        ({"tools/underlay.repos": ""}, True),
        ({"a/b/pkg/sim.repos": ""}, True),
        ({"a/b/deps.rosinstall": ""}, True),
        ({"other/deep/down.repos": ""}, False),
        ({".vcs/ros2_packages": VCS}, True),
        ({"underlay": VCS, "x/a.cpp": ""}, False),
        ({"docker/sources.yaml": VCS.replace("  x", "# ours\n  x")}, True),
        ({"installs.txt": "- git: {local-name: x, uri: 'https://example.org/x'}\n"}, True),
        ({"docs/notes.txt": "The file has a line\nrepositories:\nand what belongs to it.\n"}, False),
        ({"a/b/pkg/config/x.yaml": VCS, "a/b/pkg/y.yaml": VCS}, False),
        ({f"data/{n}.txt": "" for n in range(30)} | {"data/zzz.txt": VCS}, False),
        ({f"data/{n}.txt": "" for n in range(30)} | {"data/repositories.txt": VCS}, True),
        ({".gitmodules": '[submodule "x"]\n\tpath = x\n'}, True),
        ({".gitmodules": '[submodule "x"]\n\tpath = x\n', "x/README": ""}, False),
    ],
)
def test_what_says_that_packages_lie_elsewhere(tmp_path: Path, write, files: dict[str, str], incomplete: bool) -> None:
    write(tmp_path, {"a/b/pkg/package.xml": "", **files})
    assert bool(missing_packages(tmp_path, [tmp_path / "a/b/pkg"]).why) is incomplete


def test_without_a_workspace_the_folder_of_the_packages_is_asked(tmp_path: Path, write) -> None:
    write(tmp_path, {"pkg/package.xml": "", "ours.repos": ""})
    assert missing_packages(None, [tmp_path / "pkg"]).why
    assert not missing_packages(None, []).why
    write(tmp_path / "deep", {"a/one/package.xml": "", "b/two/package.xml": "", "ours.repos": ""})
    assert missing_packages(None, [tmp_path / "deep/a/one", tmp_path / "deep/b/two"]).why


def test_lint_reads_the_cache_and_so_do_its_workers(tmp_path: Path, write, clean) -> None:
    surroundings = {"XDG_CACHE_HOME": str(tmp_path / "cache")}
    cache_index(INDEX, surroundings)
    files = {**clean, "package.xml": manifest(need("wheel_odometri"))}
    for name in ("one", "two"):
        named = {path: text.replace("my_pkg", name) for path, text in files.items()}
        write(tmp_path / "src" / name, {path.replace("my_pkg", name): text for path, text in named.items()})
    for jobs in ("1", "2"):
        arguments = ("lint", "--select", "DEP001", "--format", "concise", "--jobs", jobs)
        done = rospkg(*arguments, cwd=tmp_path / "src", **surroundings)
        assert done.stdout.count("did you mean `wheel_odometry`?") == 2, done.stderr


@pytest.mark.parametrize("name, says", [("my_companys_driver", True), ("gripper-lib", False)])
def test_an_old_index_is_said_where_it_told_a_name(tmp_path: Path, write, clean, name: str, says: bool) -> None:
    surroundings = {"XDG_CACHE_HOME": str(tmp_path / "cache")}
    cache_index(replace(INDEX, fetched="2020-01-01T00:00:00Z"), surroundings)
    write(tmp_path / "my_pkg", {**clean, "package.xml": manifest(need(name))})
    done = rospkg("lint", "--select", "DEP001", "my_pkg", cwd=tmp_path, **surroundings)
    assert ("days old; `rospkg index update` fetches a new one" in done.stderr) is says


def test_the_index_is_read_when_a_name_is_asked_for(tmp_path: Path) -> None:
    parse.cache_clear()
    lint(need("wheel_odometri"), codes="XML001")
    assert parse.cache_info().misses == 0
    lint(need("wheel_odometri"))
    lint(need("gone"))
    assert parse.cache_info().misses == 1


@pytest.fixture
def fetched(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    cache_index(INDEX, {"XDG_CACHE_HOME": str(tmp_path / "cache")})
    monkeypatch.chdir(tmp_path)


def noted(capsys: pytest.CaptureFixture[str], *depends: str) -> str:
    """Return what `rospkg new` says on stderr of its dependencies."""
    asked = Request("my_robot", depends=depends, maintainer="Ada", email="ada@example.org", distro="jazzy")
    assert new(asked, dry_run=True) == 0
    return capsys.readouterr().err


@pytest.mark.usefixtures("fetched")
def test_new_checks_what_the_package_is_to_depend_on(tmp_path: Path, write, clean, capsys) -> None:
    assert noted(capsys, "wheel_odometry", "gripper-lib") == ""
    with pytest.raises(UsageError, match="write `--depends wheel_odometry,gripper-lib`"):
        noted(capsys, "wheel_odometri", "gripper-lib")
    assert "is released for humble and not for jazzy" in noted(capsys, "only_in_humble")
    assert "is a rosdep key without a rule for Ubuntu 24.04" in noted(capsys, "old-lib")
    assert "is no ROS package and no rosdep key" in noted(capsys, "my_pkg")
    write(tmp_path / "my_pkg", clean)
    assert noted(capsys, "my_pkg") == ""


@pytest.mark.usefixtures("fetched")
def test_new_can_tell_nothing_where_packages_are_missing(tmp_path: Path, capsys) -> None:
    assert noted(capsys, "my_companys_driver")
    (tmp_path / "ours.repos").touch()
    assert noted(capsys, "my_companys_driver") == ""


@pytest.mark.usefixtures("fetched")
def test_new_does_without_an_index_that_is_broken(tmp_path: Path, capsys) -> None:
    (tmp_path / "cache/rospkg/index.txt").write_text("rospkg-index 1 0\n")
    assert noted(capsys, "my_companys_driver") == ""
