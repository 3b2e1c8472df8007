"""What `add` and `remove` make of the record that `new --update` reads: nothing that they wrote is in conflict."""

from __future__ import annotations

from pathlib import Path

import pytest
from adding import put
from in_process import run_here
from planned import plan

from rospkg_cli.addition import kept_record
from rospkg_cli.addition.asked_dependencies import asked_dependencies
from rospkg_cli.addition.kept_record import keep_record
from rospkg_cli.addition.part import take_out
from rospkg_cli.addition.wanted import Wanted, parts_to_remove
from rospkg_cli.change.draft import Draft
from rospkg_cli.disk import DiskTree
from rospkg_cli.engine.fixing.write_all import write_all
from rospkg_cli.scaffold import OwnFaultError, ScaffoldError
from rospkg_cli.scaffold.answers_record import RECORD, AnswersRecord, read_record, with_record
from rospkg_cli.scaffold.update import UpdatedFile, updates
from rospkg_cli.scaffold.workspace import WorkspacePackages
from rospkg_cli.scaffold.write import write_folder
from rospkg_cli.tree import MemoryTree


def made(folder: Path, name: str = "my_pkg", **asked: object) -> Path:
    """Write a package as `new` does, with its record; return its folder."""
    write_folder(folder / name, with_record(plan(name, tests="none", **asked)).files)
    return folder / name


def content(package: Path) -> dict[str, bytes]:
    return {str(path.relative_to(package)): path.read_bytes() for path in package.rglob("*") if path.is_file()}


def added(package: Path, what: str, *names: str, tag: str = "") -> AnswersRecord:
    """Add as the command does, without its lint; return the record."""
    tree = DiskTree(package)
    draft, wanted = Draft(tree), Wanted(what, names, tag=tag)
    put(draft, wanted)
    keep_record(draft, package.parent, "", wanted, adds=True)
    write_all(package, tree, draft.changes, tree.fence)
    return read_record(package)


def removed(package: Path, what: str, name: str) -> AnswersRecord:
    """Remove as the command does, without its lint; return the record."""
    tree = DiskTree(package)
    draft, wanted = Draft(tree), Wanted(what, (name,))
    take_out(draft, "", parts_to_remove(draft.package(""), wanted, name, WorkspacePackages()))
    keep_record(draft, package.parent, "", wanted, adds=False)
    write_all(package, tree, draft.changes, tree.fence)
    return read_record(package)


def updated(package: Path, name: str = "my_pkg", **asked: object) -> dict[str, UpdatedFile]:
    new = with_record(plan(name, tests="none", **asked))
    return {each.path: each for each in updates(package, read_record(package), name, new.files)}


def test_an_update_after_an_addition_conflicts_with_nothing(tmp_path: Path) -> None:
    package = made(tmp_path, template="ament_cmake", nodes=("talker",))
    before = content(package)
    record = added(package, "node", "extra:timer", "watch:timer")
    assert record.request.nodes == ("talker", "extra:timer", "watch:timer")
    found = updated(package, template="ament_cmake", nodes=(*record.request.nodes, "more:service"))
    assert {each.status for each in found.values()} == {"created", "updated", "identical"}
    assert (found["CMakeLists.txt"].status, found["README.md"].status) == ("updated", "updated")
    removed(package, "node", "watch")
    removed(package, "node", "extra")
    assert content(package) == before


def test_what_the_user_edited_stays_the_users(tmp_path: Path) -> None:
    package = made(tmp_path, nodes=("talker",))
    setup = package / "setup.py"
    setup.write_text(setup.read_text() + "\n# mine\n")
    record = added(package, "node", "extra:timer")
    found = updated(package, nodes=(*record.request.nodes, "more:service"))["setup.py"]
    assert (found.status, found.after and found.after.data.endswith(b"\n# mine\n")) == ("merged", True)


def test_a_package_that_was_renamed_is_compared_under_its_old_name(tmp_path: Path) -> None:
    before = made(tmp_path, "old_name", nodes=("talker",))
    text = (before / RECORD).read_text()
    told = run_here("rename", "old_name", "new_name", "--allow-dirty", cwd=tmp_path)
    assert (told.returncode, RECORD in told.stdout) == (0, False)
    [manifest] = tmp_path.glob("*/package.xml")
    package = manifest.parent
    assert (package / RECORD).read_text() == text
    record = added(package, "node", "extra:timer")
    assert (record.request.name, record.request.nodes) == ("old_name", ("talker", "extra:timer"))
    assert "old_name/extra.py" in record.lines
    found = updated(package, "new_name", nodes=(*record.request.nodes, "more:service"))
    assert [path for path, each in found.items() if each.status == "conflict"] == []
    assert found["new_name/extra.py"].status == "identical"


@pytest.mark.parametrize(
    ("what", "name", "tag"),
    [("launch", "up", ""), ("params", "more", ""), ("dependency", "sensor_msgs", "test_depend")],
)
def test_what_new_would_not_write_stays_the_users_own(tmp_path: Path, what: str, name: str, tag: str) -> None:
    package = made(tmp_path, nodes=("talker",))
    before = read_record(package)
    assert added(package, what, name, tag=tag) == before
    assert "removed" not in {each.status for each in updated(package, nodes=("talker",)).values()}


def test_the_last_node_stays_an_answer(tmp_path: Path) -> None:
    """No nodes would ask for the one that a package has as always."""
    package = made(tmp_path, nodes=("talker",))
    before = read_record(package)
    assert removed(package, "node", "talker") == before
    assert updated(package, nodes=("talker",))["my_pkg/talker.py"].status == "skipped"


def test_a_dependency_is_an_answer_and_the_record_no_use_of_it(tmp_path: Path) -> None:
    package = made(tmp_path, nodes=("talker",))
    assert added(package, "dependency", "sensor_msgs").request.depends == ("sensor_msgs",)
    assert removed(package, "dependency", "sensor_msgs").request.depends == ()


def test_both_commands_keep_the_record(tmp_path: Path) -> None:
    package = made(tmp_path, "my_interfaces", template="interfaces", msgs=("Status",))
    before = content(package)
    assert f"edit   {RECORD}" in run_here("add", "srv", "Go:float32 speed --- bool done", cwd=package).stdout
    record = read_record(package)
    assert (record.request.srvs, "srv/Go.srv" in record.lines) == (("Go:float32 speed --- bool done",), True)
    assert f"edit   {RECORD}" in run_here("remove", "srv", "Go", "--allow-dirty", cwd=package).stdout
    assert content(package).keys() == before.keys()


@pytest.mark.parametrize("text", ["", "[answers]\nnodes = 1\n[lines]\n", '[answers]\nown_template = "x"\n[lines]\n'])
def test_a_record_that_can_not_be_kept_hinders_nothing(tmp_path: Path, text: str) -> None:
    package = made(tmp_path, nodes=("talker",))
    (package / RECORD).write_text(text)
    tree = DiskTree(package)
    draft, wanted = Draft(tree), Wanted("node", ("extra:timer",))
    put(draft, wanted)
    keep_record(draft, tmp_path, "", wanted, adds=True)
    assert RECORD not in draft.changes


@pytest.mark.parametrize("fault", [ScaffoldError("no"), OwnFaultError("no")])
def test_an_addition_that_new_can_not_plan_stays_the_users_own(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, fault: Exception
) -> None:
    def make_plan(*_: object) -> None:
        raise fault

    package = made(tmp_path, nodes=("talker",))
    before = read_record(package)
    monkeypatch.setattr(kept_record, "make_plan", make_plan)
    assert added(package, "node", "extra:timer") == before


def test_a_dependency_that_was_asked_for_stays_without_the_node_that_uses_it(tmp_path: Path) -> None:
    package = made(tmp_path, template="ament_cmake", nodes=("talker",), depends=("std_srvs",))
    before = content(package)
    added(package, "node", "extra:service:std_srvs/SetBool")
    removed(package, "node", "extra")
    assert content(package) == before
    assert asked_dependencies(Draft(MemoryTree.of({RECORD: "no record\n"})).package("")) == ()


def test_a_dependency_that_cmake_does_not_look_for_stays_the_users_own(tmp_path: Path) -> None:
    package = made(tmp_path, template="ament_cmake", nodes=("talker",))
    assert added(package, "dependency", "std_srvs").request.depends == ()
    record = added(package, "node", "extra:service:std_srvs/SetBool")
    found = updated(package, template="ament_cmake", nodes=record.request.nodes)
    assert [path for path, each in found.items() if each.status == "conflict"] == []
