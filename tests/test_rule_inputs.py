"""What a rule is given: inputs by type, and none where a part is absent or can't be read."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from rospkg_cli.engine.run.rule_inputs import InputBuilder
from rospkg_cli.example import Example
from rospkg_cli.files import PackageFiles
from rospkg_cli.package.cmake.cmake_project import CMake
from rospkg_cli.package.launch.launch_file import LaunchFile
from rospkg_cli.package.manifest import Manifest
from rospkg_cli.package.package import Package
from rospkg_cli.package.package_facts import PackageFacts
from rospkg_cli.package.rule_settings import RuleSettings
from rospkg_cli.package.workspace import Workspace
from rospkg_cli.ros.distros import Targets
from rospkg_cli.tree import MemoryTree
from rospkg_cli.unreadable import READABLE

BROKEN = "find_package(rclcpp REQUIRED\n"


@dataclass(frozen=True)
class Both:
    manifest: Manifest
    cmake: CMake


@dataclass(frozen=True)
class Perhaps:
    manifest: Manifest
    cmake: CMake | None


@dataclass(frozen=True)
class Every:
    manifest: Manifest
    launch_files: tuple[LaunchFile, ...]


@dataclass(frozen=True)
class EveryReadable:
    manifest: Manifest
    launch_files: Annotated[tuple[LaunchFile, ...], READABLE]


def inputs(changed: dict[str, str], on: str = "ament_cmake") -> InputBuilder:
    package = Package(PackageFiles(MemoryTree.of(Example(bad=changed, good={}, on=on).bad_files()), ""))
    return InputBuilder(package, Workspace((PackageFacts("my_pkg", ""),)), Targets(), RuleSettings())


def test_an_input_is_put_together_by_the_types_of_its_fields() -> None:
    [both] = inputs({}).of(Both)
    assert isinstance(both.manifest, Manifest)
    assert isinstance(both.cmake, CMake)


def test_an_input_with_a_broken_part_is_not_built() -> None:
    """Law 7."""
    found = inputs({"CMakeLists.txt": BROKEN})
    assert found.of(Manifest)
    assert [found.of(kind) for kind in (CMake, Both, Perhaps)] == [[], [], []]
    assert [each.path for each in found.package.unreadable()] == ["CMakeLists.txt"]


def test_a_part_may_be_absent_only_where_the_type_says_so() -> None:
    found = inputs({}, "ament_python")
    assert found.of(Both) == []
    assert [each.cmake for each in found.of(Perhaps)] == [None]


def test_of_many_files_there_is_one_input_each_or_all_in_one_or_none_where_one_is_broken() -> None:
    launch = {f"launch/{name}.launch.xml": "<launch/>\n" for name in "ab"}
    assert len(inputs(launch).of(LaunchFile)) == 2
    assert [len(each.launch_files) for each in inputs(launch).of(Every)] == [2]
    broken = inputs({**launch, "launch/c.launch.xml": "<launch>\n"})
    assert len(broken.of(LaunchFile)) == 2
    assert broken.of(Every) == []


def test_an_input_may_do_with_the_files_that_can_be_read() -> None:
    launch = {"launch/a.launch.xml": "<launch/>\n", "launch/b.launch.xml": "<launch>\n"}
    assert [len(each.launch_files) for each in inputs(launch).of(EveryReadable)] == [1]
