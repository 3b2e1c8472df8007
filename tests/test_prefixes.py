"""What is installed on the machine: it may silence a finding, never cause one."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from rospkg_cli.engine.discovery.installed_packages import installed_package_names
from rospkg_cli.engine.run.scope import Scope
from rospkg_cli.engine.run.session import Session
from rospkg_cli.example import BACKDROPS, existing_files, manifest
from rospkg_cli.tree import MemoryTree

INDEX = "share/ament_index/resource_index/packages"


def prefix(folder: Path, *names: str) -> Path:
    (folder / INDEX).mkdir(parents=True)
    for name in names:
        (folder / INDEX / name).touch()
    return folder


def test_every_prefix_of_the_path_counts(tmp_path: Path) -> None:
    first, second = prefix(tmp_path / "a", "one"), prefix(tmp_path / "b", "two", "three")
    path = os.pathsep.join([str(first), str(second), str(tmp_path / "gone"), ""])
    assert installed_package_names({"AMENT_PREFIX_PATH": path}, tmp_path / "none") == {"one", "two", "three"}


def test_the_distribution_that_is_named_counts_else_all_that_are_there(tmp_path: Path) -> None:
    prefix(tmp_path / "humble", "old")
    prefix(tmp_path / "jazzy", "new")
    assert installed_package_names({"ROS_DISTRO": "jazzy"}, tmp_path) == {"new"}
    assert installed_package_names({}, tmp_path) == {"old", "new"}
    assert installed_package_names({}, tmp_path / "nowhere") == frozenset()


def said(files: dict[str, str | None], installed: str) -> list[str]:
    scope = Scope(("",), frozenset({""}), "my_pkg", prefix_names=frozenset({installed} - {""}))
    tree = MemoryTree.of(existing_files({**existing_files(BACKDROPS["ament_python"]), **files}))
    codes = frozenset({"DEP001", "DEP101", "DEP103"})
    return [finding.code for finding in Session(tree, scope, codes).run().findings]


@pytest.mark.parametrize("name", ["sensor_msg", "opencv-python"])
def test_a_prefix_silences(name: str) -> None:
    files = {"package.xml": manifest(f"  <exec_depend>{name}</exec_depend>\n")}
    assert said(files, "") == ["DEP001"]
    assert said(files, name) == []


def test_a_prefix_causes_nothing() -> None:
    files = {"my_pkg/node.py": "import our_own_driver\n"}
    assert said(files, "our_own_driver") == said(files, "") == []
