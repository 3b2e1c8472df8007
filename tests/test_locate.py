"""Which packages a path means, and which workspace lies around it."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from rospkg_cli.config.file import Config
from rospkg_cli.config.hierarchy import ConfigTree
from rospkg_cli.disk import DiskTree
from rospkg_cli.engine.discovery.locate import LocateError, locate


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    for folder in ("ws/src/a", "ws/src/group/b", "ws/src/hidden/c", "ws/src/third_party/d", "ws/build/a"):
        (tmp_path / folder).mkdir(parents=True)
        (tmp_path / folder / "package.xml").write_text("<package/>")
    (tmp_path / "ws/src/hidden/COLCON_IGNORE").touch()
    (tmp_path / "ws/build/COLCON_IGNORE").touch()
    (tmp_path / "ws/src/a/launch").mkdir()
    (tmp_path / "ws/src/a/launch/x.launch.py").touch()
    return tmp_path / "ws"


def given(*paths: Path, **more) -> list[str]:
    located = locate(paths, **more)
    return sorted(Path(located.root, folder).name for folder in located.scope.selected)


def test_a_folder_means_the_packages_below_it(workspace: Path) -> None:
    assert given(workspace) == ["a", "b"]


def test_a_file_or_folder_inside_means_its_package(workspace: Path) -> None:
    assert given(workspace / "src/a/launch/x.launch.py") == ["a"]
    assert given(workspace / "src/a/launch") == ["a"]


def test_what_is_hidden_is_linted_when_given(workspace: Path) -> None:
    assert given(workspace / "src/hidden") == ["c"]
    assert given(workspace / "src/hidden/c") == ["c"]
    assert given(workspace / "src/third_party/d") == ["d"]


def test_colcon_looks_into_no_folder_that_begins_with_a_dot(workspace: Path) -> None:
    (workspace / "src/.old/e").mkdir(parents=True)
    (workspace / "src/.old/e/package.xml").write_text("<package/>")
    assert given(workspace) == ["a", "b"]
    assert given(workspace / "src/.old") == given(workspace / "src/.old/e") == ["e"]


@pytest.mark.parametrize("output, mark", [("made", "CMakeCache.txt"), ("install", "local_setup.bash")])
def test_what_a_build_left_is_linted_when_given(workspace: Path, output: str, mark: str) -> None:
    (workspace / output / "e").mkdir(parents=True)
    (workspace / output / "e/package.xml").write_text("<package/>")
    assert given(workspace) == ["a", "b", "e"]
    (workspace / output / mark).touch()
    assert given(workspace) == ["a", "b"]
    assert given(workspace / output) == ["e"]


def test_a_package_inside_another_is_meant_by_its_own_path(workspace: Path) -> None:
    (workspace / "src/a/inner").mkdir()
    (workspace / "src/a/inner/package.xml").write_text("<package/>")
    assert given(workspace / "src/a") == ["a"]
    assert given(workspace / "src/a/inner") == ["inner"]


def test_siblings_are_known_not_given(workspace: Path) -> None:
    located = locate([workspace / "src/a"])
    assert located.root == workspace.resolve()
    assert located.scope.folders == ("src/a", "src/group/b", "src/third_party/d")
    assert located.scope.selected == {"src/a"}


def test_a_repos_file_says_that_more_belongs_here(workspace: Path) -> None:
    assert not locate([workspace / "src/a"]).scope.incomplete
    (workspace / "all.repos").touch()
    assert locate([workspace / "src/a"]).scope.incomplete


def test_the_outermost_workspace(workspace: Path) -> None:
    (workspace / "src/group/.git").mkdir()
    assert locate([workspace / "src/group/b"]).root == workspace.resolve()


def test_a_built_workspace_around_another_is_not_that_of_its_packages(workspace: Path) -> None:
    """colcon, started in the inner one, sees only what is there: both may have a package of one name."""
    for folder in ("install", "log", "tried/inner/src/a", "src/repository/src/e"):
        (workspace / folder).mkdir(parents=True)
    (workspace / "tried/inner/src/a/package.xml").write_text("<package/>")
    (workspace / "src/repository/src/e/package.xml").write_text("<package/>")
    assert locate([workspace / "tried/inner/src"]).scope.folders == ("src/a",)
    outer = locate([workspace / "src/repository/src/e"])
    assert outer.root == workspace
    assert "src/group/b" in outer.scope.folders
    (workspace / "log").rmdir()
    (workspace / ".git").mkdir()
    assert locate([workspace / "tried/inner/src"]).root == workspace


def test_exclude(workspace: Path) -> None:
    config = Config(workspace / "rospkg.toml", exclude=("src/group",))
    assert given(workspace, configs=ConfigTree(config, is_only=True)) == ["a"]
    assert given(workspace, configs=ConfigTree(replace(config, exclude=("src/*",)), is_only=True)) == []


def test_a_lone_package_is_its_own_workspace(tmp_path: Path) -> None:
    lone = tmp_path / "nobody_beside/lone"
    lone.mkdir(parents=True)
    (lone / "package.xml").touch()
    located = locate([lone])
    assert (located.root, located.scope.folders) == (lone.resolve(), ("",))


def test_a_missing_path_is_said(tmp_path: Path) -> None:
    with pytest.raises(LocateError, match="does not exist"):
        locate([tmp_path / "nowhere"])


def test_repositories(workspace: Path) -> None:
    assert locate([workspace]).scope.repositories == ()
    (workspace / "src/group/.git").write_text("gitdir: elsewhere")
    (workspace / "src/.git").mkdir()
    found = locate([workspace]).scope.repositories
    assert found == ({"src/a", "src/third_party/d"}, {"src/group/b"})


def test_plain_projects_are_named(workspace: Path) -> None:
    """One in a package, in another project, or around packages is none; nor is one of ament, or one with a marker."""
    lists = ("src", "src/a", "src/a/deep", "src/group/lib", "src/group/lib/deep", "src/hidden/lib", "src/unnamed/deep")
    for folder in lists:
        (workspace / folder).mkdir(parents=True, exist_ok=True)
        (workspace / folder / "CMakeLists.txt").write_text(f'PROJECT("{folder.replace("/", "-")}" CXX)\n')
    (workspace / "src/lost").mkdir()
    (workspace / "src/lost/CMakeLists.txt").write_text("project(lost)\nfind_package(ament_cmake_auto REQUIRED)\n")
    (workspace / "src/unnamed/CMakeLists.txt").write_text("project(${NAME})\n")
    own, deep = ("src-group-lib", "src/group/lib"), ("src-unnamed-deep", "src/unnamed/deep")
    assert locate([workspace]).scope.cmake_projects == (own, deep)
    assert locate([workspace / "src/group"]).scope.cmake_projects == (own, deep)


def test_without_a_workspace_plain_projects_lie_beside_the_packages(tmp_path: Path) -> None:
    for folder, name in (("a", "package.xml"), ("lib", "CMakeLists.txt")):
        (tmp_path / folder).mkdir()
        (tmp_path / folder / name).write_text("project(wheel)\n")
    assert locate([tmp_path / "a"]).scope.cmake_projects == (("wheel", "../lib"),)


def test_a_copy_of_a_repository_belongs_to_the_one_around_it(workspace: Path) -> None:
    """What the copy's former host read is still in it."""
    (workspace / "src/group/.github").mkdir()
    assert locate([workspace]).scope.repositories == ({"src/group/b"},)
    (workspace / "src/.git").mkdir()
    assert locate([workspace]).scope.repositories == ({"src/a", "src/group/b", "src/third_party/d"},)


@pytest.mark.parametrize(
    "marks, says",
    [
        (["a/COLCON_IGNORE"], "2 packages below, hidden by `a/COLCON_IGNORE`"),
        (["a/AMENT_IGNORE", "a/one/COLCON_IGNORE"], "2 packages below, hidden by `a/AMENT_IGNORE`"),
        (["a/one/CATKIN_IGNORE", "a/two/COLCON_IGNORE"], "hidden by `a/one/CATKIN_IGNORE` and another marker"),
        (["a/one/CATKIN_IGNORE", "a/two/COLCON_IGNORE", "a/three/COLCON_IGNORE"], "and 2 other markers"),
    ],
)
def test_it_says_what_hides_the_packages(tmp_path: Path, marks: list[str], says: str) -> None:
    for name in {"one", "two", *(Path(mark).parent.name for mark in marks)} - {"a"}:
        (tmp_path / "a" / name).mkdir(parents=True)
        (tmp_path / "a" / name / "package.xml").write_text("<package/>")
    for mark in marks:
        (tmp_path / mark).touch()
    assert says in locate([tmp_path]).hidden


@pytest.mark.parametrize(
    "files, says",
    [
        (["ws/install/setup.sh", "ws/install/local_setup.sh"], ""),
        (
            ["ws/install/local_setup.sh", "ws/install/share/a/package.xml"],
            "the packages below `ws/install/` are made by",
        ),
        (
            ["install/.colcon_install_layout", "install/a/share/a/package.xml"],
            "the packages below `install/` are made by",
        ),
        (
            [
                "ws/install/COLCON_IGNORE",
                "ws/install/a/package.xml",
                "ws/build/COLCON_IGNORE",
                "ws/build/a/package.xml",
            ],
            "the packages below `ws/build/` and another folder are made by colcon and do not count",
        ),
        (["ws/env/pyvenv.cfg", "ws/env/share/a/package.xml"], ""),
        (["install/a/share/a/package.xml", "install/a/lib/a/go"], "the packages below `install/a/share/a/` are made"),
        (
            ["install/local_setup.sh", "install/a/package.xml", "b/AMENT_IGNORE", "b/package.xml"],
            "1 package below, hid",
        ),
    ],
)
def test_it_says_that_colcon_made_the_packages(tmp_path: Path, write, files: list[str], says: str) -> None:
    write(tmp_path, dict.fromkeys(files, ""))
    found = locate([tmp_path]).hidden
    assert found.startswith(says)
    assert bool(found) is bool(says)


@pytest.mark.parametrize(
    ("files", "says"),
    [
        (["skel/.template/a/package.xml"], "colcon does not look into `skel/.template/`, which holds 1 package"),
        ([".ws/a/package.xml", ".ws/b/package.xml"], "colcon does not look into `.ws/`, which holds 2 packages"),
        ([".a/package.xml", "b/.c/package.xml"], "colcon does not look into `.a/` and another folder that"),
        ([".git/modules/a/package.xml", ".venv/a/package.xml"], ""),
        ([".ws/README.md"], ""),
    ],
)
def test_it_says_that_packages_lie_below_a_dot(tmp_path: Path, write, files: list[str], says: str) -> None:
    write(tmp_path, dict.fromkeys(files, ""))
    found = locate([tmp_path]).hidden
    assert found.startswith(says)
    assert bool(found) is bool(says)


@pytest.mark.parametrize(
    ("made", "beside"),
    [
        ("install/a/share/a", "cmake/aConfig.cmake"),
        ("install/share/a", "launch/a.launch.py"),
        ("old_install/a/share/a", "local_setup.dsv"),
        ("sysroot/opt/ros/humble/share/a", "environment/path.sh"),
        ("image/share/a", "hook/path.dsv"),
        ("build_arm/a", "colcon_build.rc"),
        ("build/a", "prefix_override/sitecustomize.py"),
        ("overlay/opt/ros/humble/share/a", "launch/a.launch.py"),
    ],
)
def test_what_a_build_made_of_a_package_is_none(tmp_path: Path, write, made: str, beside: str) -> None:
    write(tmp_path, {f"{each}/package.xml": "" for each in ("src/a", "src/b", made)} | {f"{made}/{beside}": ""})
    assert locate([tmp_path]).scope.selected == {"src/a", "src/b"}
    write(tmp_path, {"package.xml": ""})
    assert "src/a/package.xml" in (found := DiskTree(tmp_path).files())
    assert f"{made}/package.xml" not in found


@pytest.mark.parametrize(
    ("folder", "beside"),
    [
        ("share/a", "launch/a.launch.py"),
        ("share/a", "CMakeLists.txt"),
        ("install/share/a", "setup.py"),
        ("install/a", "CMakeLists.txt"),
        ("a", "hook/go.sh"),
    ],
)
def test_folders_that_are_only_called_so_are_packages(tmp_path: Path, write, folder: str, beside: str) -> None:
    write(tmp_path, {f"{folder}/package.xml": "", f"{folder}/{beside}": "", "b/package.xml": ""})
    assert locate([tmp_path]).scope.selected == {folder, "b"}


def test_folders_of_others_hide_packages_too(tmp_path: Path) -> None:
    (tmp_path / "third_party" / "one").mkdir(parents=True)
    (tmp_path / "third_party" / "one" / "package.xml").write_text("<package/>")
    assert locate([tmp_path]).hidden == "1 package below, hidden by `third_party`"
    assert locate([tmp_path / "third_party"]).scope.selected
