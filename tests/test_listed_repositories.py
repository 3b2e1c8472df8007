"""Names that a repository has which is listed and not here: they are no slips of others."""

from __future__ import annotations

from pathlib import Path

import pytest

from rospkg_cli.engine.discovery.incomplete_workspace import missing_packages
from rospkg_cli.engine.run.scope import Scope
from rospkg_cli.engine.run.session import Session
from rospkg_cli.example import CMAKE, SETUP_CFG, SETUP_PY, manifest
from rospkg_cli.package.missing_repositories import is_called
from rospkg_cli.ros.distros import Targets
from rospkg_cli.tree import MemoryTree

HEAD = "from ament_index_python import get_package_share_directory\n"
LAUNCH = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package='acme_assets', executable='talker')])
"""
PYTHON = {"resource/my_pkg": "", "my_pkg/__init__.py": "", "setup.cfg": SETUP_CFG, "setup.py": SETUP_PY}
MEANT = "  <depend>acme_asset</depend>\n"
SLIPS = {
    "DEP112": {"a/my_pkg/talker.py": f"{HEAD}get_package_share_directory('acme_assets')\n"},
    "DEP103": {"a/launch/robot.launch.py": LAUNCH},
    "DEP001": {"a/package.xml": manifest("  <depend>acme_assets</depend>\n")},
    "CMK117": {
        "a/CMakeLists.txt": CMAKE.replace("ament_package", "find_package(acme_assets REQUIRED)\nament_package"),
        "a/package.xml": manifest(MEANT, "ament_cmake"),
    },
}


def messages(code: str, *missing: str) -> list[str]:
    own = {f"a/{path}": text for path, text in PYTHON.items() if code != "CMK117"}
    beside = manifest(build_type="ament_cmake").replace("<name>my_pkg", "<name>acme_asset")
    files = {"b/package.xml": beside, "b/CMakeLists.txt": CMAKE.replace("my_pkg", "acme_asset")}
    files |= {**own, "a/package.xml": manifest(MEANT), **SLIPS[code]}
    why = "the submodule `x` is empty"
    scope = Scope(("a", "b"), frozenset({"a", "b"}), "my_ws", why, missing_repositories=frozenset(missing))
    found = Session(MemoryTree.of(files), scope, frozenset({code}), Targets()).run().findings
    return [each.message for each in found]


@pytest.mark.parametrize("code", SLIPS)
def test_the_name_of_a_repository_that_is_not_here_is_no_slip(code: str) -> None:
    assert any("`acme_asset`" in each for each in messages(code, "src/wheels"))
    assert not any("`acme_asset`" in each for each in messages(code, "src/acme_assets"))


@pytest.mark.parametrize(
    "repositories, is_so",
    [(["src/acme-Assets"], True), (["acme_assets"], True), (["acme_assets/robots"], False), ([], False)],
)
def test_the_last_word_of_a_repository_is_its_name(repositories: list[str], is_so: bool) -> None:
    assert is_called(repositories, "acme_assets") is is_so


def test_the_url_of_a_submodule_names_it_too(tmp_path: Path, write) -> None:
    text = '[submodule "x"]\n\tpath = src/x\n\turl = {}\n[submodule "y"]\n\tpath = src/y\n\turl = git@a.org:y.git\n'
    for url in ("https://github.com/acme/acme_assets.git", "git@github.com:acme_assets.git", "../acme_assets/"):
        write(tmp_path, {"a/package.xml": "", ".gitmodules": text.format(url)})
        found = missing_packages(tmp_path, [tmp_path / "a"])
        assert found.repositories == {"src/x", "src/y", "acme_assets"}
    write(tmp_path, {"src/x/README": ""})
    assert missing_packages(tmp_path, [tmp_path / "a"]).repositories == {"src/y"}
