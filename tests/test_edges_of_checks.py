"""Where a check is not sure, or stops looking: the last that it still says, and the first that it does not."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest
from cmaking import read

from rospkg_cli.checks.cmake.exported_names import UNKNOWN, ExportedNames
from rospkg_cli.checks.cmake.node_programs import MAX_DEPTH, NodePrograms
from rospkg_cli.checks.depends import transitive_dependencies
from rospkg_cli.checks.depends.compiled_sources import compiled_sources
from rospkg_cli.checks.depends.header_providers import HeaderProviders
from rospkg_cli.checks.depends.needed_find_packages import NeededFindPackages
from rospkg_cli.checks.launch.entity_values import substitution_faults
from rospkg_cli.checks.manifest.manifest_inputs import ManifestAndFiles
from rospkg_cli.checks.plugins.plugin_names import is_something_else
from rospkg_cli.checks.share.share_references import references_folder
from rospkg_cli.example import CMAKE, SETUP_PY, manifest
from rospkg_cli.package.package_facts import PackageFacts
from rospkg_cli.testing import lint_files


def test_where_the_sources_of_a_target_are_unknown_every_file_counts() -> None:
    files: list[Any] = [SimpleNamespace(path=path, includes=()) for path in ("src/a.cpp", "src/b.cpp")]
    assert compiled_sources(read("add_executable(a ${unheard_of})\n"), files) == [(each, "run") for each in files]
    assert compiled_sources(read("add_executable(a src/a.cpp)\n"), files) == [(files[0], "run")]


@pytest.mark.parametrize(
    "text, needed",
    [
        ("ament_target_dependencies(a rclcpp ${x})\n", {"rclcpp"}),
        ("if(UNHEARD_OF)\n  ament_target_dependencies(a rclcpp)\nendif()\n", set()),
        ("target_link_libraries(a tf2::tf2 m)\n", {"tf2"}),
        ("if(UNHEARD_OF)\n  target_link_libraries(a tf2::tf2)\nendif()\n", set()),
        ("if(UNHEARD_OF)\n  set(l tf2::tf2)\nendif()\ntarget_link_libraries(a ${l} rclcpp::rclcpp)\n", {"rclcpp"}),
    ],
)
def test_packages_that_a_target_certainly_needs(text: str, needed: set[str]) -> None:
    model: Any = SimpleNamespace(cmake=read(f"add_library(a a.cpp)\n{text}"))
    model.handed_to_ament = NeededFindPackages.handed_to_ament.func(model)
    assert NeededFindPackages.names.func(model) & {"rclcpp", "tf2"} == needed


@pytest.mark.parametrize(
    "unknown, name, is_other",
    [
        ((), "arm::Tool", False),
        (("components",), "arm::Tool", True),
        (("interfaces",), "arm::Tool", True),
        (("components", "interfaces"), "arm::Tool", True),
        ((), "arm::Node", True),
        ((), "arm/Pose", True),
    ],
)
def test_a_name_that_may_be_no_plugin_s(unknown: tuple[Any, ...], name: str, is_other: bool) -> None:
    owner = PackageFacts(
        "arm",
        "arm",
        components=frozenset({"arm::Node"}),
        interfaces=frozenset({"msg/Pose"}),
        unknown=frozenset(unknown),
    )
    assert is_something_else(owner, name) is is_other


@pytest.mark.parametrize("name, arguments, says", [
    ("zqrname", 1, None), ("dirnome", 1, "did you mean `$(dirname …)`?"), ("var", 1, None),
    ("var", 0, "takes 1 to 2 arguments"),
])  # fmt: skip
def test_a_substitution_that_is_nearly_one(name: str, arguments: int, says: str | None) -> None:
    found: Any = SimpleNamespace(name=name, arguments=[()] * arguments, span=None)
    told = [fault.message for fault in substitution_faults(found)]
    assert told == [] if says is None else says in told[0]


@pytest.mark.parametrize("distance, is_found", [(200, True), (201, False)])
def test_a_folder_far_behind_the_share_directory(distance: int, is_found: bool) -> None:
    lookup = "get_package_share_directory('arm')"
    text = f"{lookup}{' ' * (distance - len(lookup))}'config'"
    assert references_folder(text, "arm", "config") is is_found


@pytest.mark.parametrize("between, is_node", [(MAX_DEPTH, True), (MAX_DEPTH + 1, False)])
def test_ros_behind_other_targets(between: int, is_node: bool) -> None:
    lines = ["add_executable(l0 a.cpp)", *(f"add_library(l{n} a.cpp)" for n in range(1, between + 1))]
    lines += [f"target_link_libraries(l{n} l{n + 1})" for n in range(between)]
    model: Any = SimpleNamespace(
        cmake=read("\n".join([*lines, f"target_link_libraries(l{between} rclcpp::rclcpp)", ""]))
    )
    assert NodePrograms(model).uses_ros("l0") is is_node


@pytest.mark.parametrize("depth", [1, transitive_dependencies.MAX_DEPTH])
def test_metapackages_of_metapackages(monkeypatch: pytest.MonkeyPatch, depth: int) -> None:
    monkeypatch.setattr(transitive_dependencies, "metapackage_members", lambda name, _: (str(int(name) + 1),))
    workspace: Any = SimpleNamespace(named=lambda _: None)
    monkeypatch.setattr(transitive_dependencies, "MAX_DEPTH", depth)
    assert transitive_dependencies.with_members(["0"], workspace) == {str(n) for n in range(depth + 1)}


@pytest.mark.parametrize(
    "header, is_own",
    [
        ("my_pkg/made.hpp", True),
        ("parts/made.hpp", True),
        ("parts/deep/made.hpp", False),
        ("there.hpp", True),
        ("made.hpp", False),
        ("other/made.hpp", False),
    ],
)
def test_a_header_that_the_build_may_make(header: str, is_own: bool) -> None:
    model: Any = SimpleNamespace(
        inner=frozenset(),
        declared=SimpleNamespace(facts=SimpleNamespace(name="my_pkg")),
        path_endings={"parts", "there.hpp"},
    )
    assert HeaderProviders.is_own(model, header) is is_own


def test_interfaces_stand_in_the_folder_of_their_kind() -> None:
    names = ["msg/A.msg", "msg/sub/B.msg", "msg/README.md", "msg/C.srv", "srv/C.srv", "action/D.action", "E.msg"]
    below = {kind: [name for name in names if name.startswith(f"{kind}/")] for kind in ("msg", "srv", "action")}
    model: Any = SimpleNamespace(files=SimpleNamespace(below=below.__getitem__))
    found = ManifestAndFiles.interface_files.func(model)
    assert sorted(found) == ["action/D.action", "msg/A.msg", "srv/C.srv"]


def test_what_an_interface_target_passes_on() -> None:
    text = f"{UNKNOWN}_targets"
    target = SimpleNamespace(dependencies=[SimpleNamespace(text="rclcpp"), SimpleNamespace(text=text)])
    calls = [SimpleNamespace(texts=["tf2", f"a{UNKNOWN}"])]
    for given, targets, expected in (
        (calls, [], {"tf2", UNKNOWN}),
        ([], [target], {"rclcpp", UNKNOWN}),
    ):
        cmake = SimpleNamespace(interface_targets=targets, named=lambda _: [])
        model: Any = SimpleNamespace(calls=given, cmake=cmake)
        assert ExportedNames.packages.func(model) == expected


@pytest.mark.parametrize(
    "old, new, count",
    [
        ("", "", 1),
        ("  <export>", "  <buildtool_depend>catkin</buildtool_depend>\n  <export>", 0),
        ("<build_type>", '<build_type condition="$ROS_VERSION == 2">', 0),
    ],
)
def test_build_files_of_a_package_for_ros_1_and_2(old: str, new: str, count: int) -> None:
    text = manifest(build_type="ament_cmake").replace(old, new) if old else manifest(build_type="ament_cmake")
    assert text.count(new)
    files = {"package.xml": text, "CMakeLists.txt": CMAKE, "setup.py": SETUP_PY}
    assert len(lint_files(files, ["XML307"]).findings) == count
