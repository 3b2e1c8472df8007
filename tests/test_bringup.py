"""Packages that start a robot: what they include, start and pass on, as far as it can be known."""

from __future__ import annotations

from itertools import cycle
from pathlib import Path

import pytest
import yaml
from planned import around, plan, texts

from rospkg_cli.checks.launch.entity_schema import entity_faults
from rospkg_cli.package.launch.launch_file import LaunchFile
from rospkg_cli.ros.distros import DISTROS
from rospkg_cli.ros.licenses import LICENSES
from rospkg_cli.scaffold import ScaffoldError
from rospkg_cli.scaffold.plan import Plan
from rospkg_cli.scaffold.workspace import WorkspacePackages
from rospkg_cli.scaffold.workspace import workspace_packages as around_on_disk
from rospkg_cli.scaffold.write import write_folder

ROBOT = around(
    plan("my_robot", nodes=("talker", "counter:timer")),
    plan("my_robot_description", template="description"),
    plan("my_drivers", template="ament_cmake", nodes=("adder:service",)),
    plan("my_interfaces", template="interfaces"),
)


def bringup(there: WorkspacePackages = ROBOT, **asked: object) -> Plan:
    return plan("my_robot_bringup", there, template="bringup", **asked)


def launch(planned: Plan) -> str:
    return texts(planned)["launch/my_robot_bringup.launch.py"]


ASKED = {
    "the robot around": {},
    "one launch file": {"depends": ("my_drivers",)},
    "all": {
        "depends": ("my_robot", "my_drivers", "my_interfaces", "nav2_bringup"),
        "nodes": ("demo_nodes_py/talker:ear",),
    },
    "nodes": {"nodes": ("demo_nodes_cpp/talker", "usb_cam/usb_cam_node_exe")},
    "no parameters": {"depends": ("my_robot",), "nodes": ("demo_nodes_cpp/talker",), "params": False},
    "nodes without": {"nodes": ("demo_nodes_cpp/talker",), "params": False, "tests": "none"},
    "nothing": {"depends": ("my_interfaces",), "tests": "minimal"},
}  # fmt: skip


FORMS_IN_TURN = list(zip([each.name for each in DISTROS], cycle(["py", "xml", "yaml"]), strict=False))


@pytest.mark.parametrize("asked", ASKED)
@pytest.mark.parametrize("distro, form", FORMS_IN_TURN)
def test_it_is_written_without_a_finding(asked: str, distro: str, form: str) -> None:
    planned = bringup(distro=distro, launch=form, **ASKED[asked])
    assert planned.findings == ()
    faultless_text(texts(planned))


@pytest.mark.parametrize("asked", ASKED)
def test_every_form_starts_the_same(asked: str) -> None:
    files = [launch_file(bringup(launch=form, **ASKED[asked])) for form in ("py", "xml", "yaml")]
    assert all(file.is_complete and not any(entity_faults(file)) for file in files)
    [wanted, *others] = [started(file) for file in files]
    assert others == [wanted, wanted]
    assert wanted[0] or wanted[1] or asked == "nothing"


def launch_file(planned: Plan) -> LaunchFile:
    package = around(planned).package("my_robot_bringup")
    [file] = package.parts(LaunchFile).good
    return file


def started(file: LaunchFile) -> tuple[object, ...]:
    """Return what a launch file starts, as far as the forms can be compared."""
    nodes = [(n.package.literal, n.executable.literal, n.name.literal, len(n.parameters)) for n in file.nodes]
    includes = [(i.file.in_share()[1], sorted(name.literal for name, _ in i.arguments)) for i in file.includes]
    return nodes, includes, [argument.name.literal for argument in file.arguments]


def faultless_text(files: dict[str, str]) -> None:
    for path, text in files.items():
        assert text == "" or (text.endswith("\n") and not text.endswith("\n\n")), path
        assert "\n\n\n" not in text or path.endswith((".py", "LICENSE")), path
        assert not [line for line in text.splitlines() if line != line.rstrip()], path
        if path.endswith(".yaml"):
            assert yaml.safe_load(text)


@pytest.mark.parametrize("license", [each.spdx for each in LICENSES])
def test_with_nothing_to_start_it_says_so(license: str) -> None:
    planned = bringup(WorkspacePackages(), license=license)
    assert planned.findings == ()
    assert "LogInfo(msg='Nothing is started yet" in launch(planned)
    assert "launch_ros" not in texts(planned)["package.xml"]
    assert not [path for path in texts(planned) if path.startswith(("config/", "test/"))]


def test_it_includes_the_packages_that_are_named_after_the_robot() -> None:
    planned = bringup()
    assert [(each.package, each.file) for each in planned.answers.started.includes] == [
        ("my_robot", "my_robot.launch.py"),
        ("my_robot_description", "my_robot_description.launch.py"),
    ]
    for name in ("my_robot", "my_robot_description"):
        assert texts(planned)["package.xml"].count(f"<exec_depend>{name}</exec_depend>") == 1
    assert launch(planned).count("GroupAction([") == 2


def test_it_hands_on_the_arguments_that_a_launch_file_has() -> None:
    first, second = bringup().answers.started.includes
    assert first.arguments == ("namespace", "log_level", "use_sim_time")
    assert second.arguments == ("namespace", "use_sim_time")


def test_the_parameters_of_what_it_includes_are_its_own() -> None:
    files = texts(bringup())
    assert set(yaml.safe_load(files["config/my_robot.yaml"])) == {"/**/talker", "/**/counter"}
    assert "'my_robot.yaml'" in files["launch/my_robot_bringup.launch.py"]
    assert "config/my_robot_description.yaml" not in files


def test_nodes_of_others_are_started() -> None:
    planned = bringup(nodes=("demo_nodes_cpp/talker", "my_drivers/adder:sum"))
    assert "executable='adder',\n            name='sum'," in launch(planned)
    assert set(yaml.safe_load(texts(planned)["config/params.yaml"])) == {"/**/talker", "/**/sum"}
    assert "<exec_depend>demo_nodes_cpp</exec_depend>" in texts(planned)["package.xml"]
    assert planned.notes == ()


def test_a_package_without_launch_files_has_all_its_nodes_started(tmp_path: Path) -> None:
    planned = plan("my_nodes", nodes=("one", "two"))
    kept = [file for file in planned.files if not file.path.startswith("launch/")]
    write_folder(tmp_path / "src" / "group" / "my_nodes", kept)
    found = bringup(around_on_disk(tmp_path / "src"), depends=("my_nodes",))
    assert [start.executable for start in found.answers.started.starts] == ["one", "two"]
    assert around_on_disk(tmp_path).trees == {}


def test_of_what_is_not_here_nothing_is_guessed() -> None:
    planned = bringup(depends=("nav2_bringup",))
    assert planned.answers.started.includes == ()
    assert "<exec_depend>nav2_bringup</exec_depend>" in texts(planned)["package.xml"]
    assert any("--node nav2_bringup/EXECUTABLE" in note for note in planned.notes)


def test_interfaces_have_nothing_to_start() -> None:
    assert bringup(depends=("my_interfaces",)).notes == ()


REFUSED = {
    ("talker",): "PACKAGE/EXECUTABLE, as demo_nodes_cpp/talker",
    ("talker:timer",): "PACKAGE/EXECUTABLE",
    ("a b/talker",): "PACKAGE/EXECUTABLE",
    ("my_drivers/ader",): "no executable `ader` \\(did you mean `adder`\\?\\); it has adder",
    ("demo_nodes_cpp/talker:2",): "no digit first",
    ("demo_nodes_cpp/talker", "demo_nodes_py/talker"): "two nodes would be called `talker`",
}


@pytest.mark.parametrize("nodes", REFUSED)
def test_what_cannot_be_started_is_refused(nodes: tuple[str, ...]) -> None:
    with pytest.raises(ScaffoldError, match=REFUSED[nodes]):
        bringup(nodes=nodes)


def test_a_package_of_the_workspace_is_no_unknown_dependency() -> None:
    there = around(plan("std_msg", template="interfaces"))
    assert plan("my_user", there, depends=("std_msg",)).findings == ()
    with pytest.raises(ScaffoldError, match="leave --depends out"):
        plan("my_user", depends=("std_msg",))
