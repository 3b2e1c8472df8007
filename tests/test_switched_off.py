"""What switches the check of unknown names off is told once; a list of repositories that are all here does not."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from in_process import run_here as rospkg

from rospkg_cli.engine.discovery.listed_repositories import listed_repositories
from rospkg_cli.engine.discovery.locate import locate
from rospkg_cli.engine.run.switched_off import is_unsure
from rospkg_cli.light_dataclasses import replace
from rospkg_cli.package.package_facts import PackageFacts
from rospkg_cli.package.run_events import CheckSwitchedOff
from rospkg_cli.package.workspace import Workspace
from rospkg_cli.ros.name_index import Index, dump
from rospkg_cli.ros.names import BUILT_IN, FetchedNames
from rospkg_cli.rules.tool.rpk008_check_switched_off import check_switched_off
from rospkg_cli.source import Span
from rospkg_cli.unreadable import UnreadableError

LIST = """\
repositories:
  arm: {type: git, url: https://example.org/arm.git}
  tools/gripper: {type: git, url: https://example.org/gripper.git}
"""


@pytest.fixture
def workspace(tmp_path, write, clean) -> Path:
    """Two packages that depend on names nobody knows, and one on nothing at all, which XML210 tells."""
    for name, needs in (("one", ["", "acme_a", "acme_b"]), ("two", ["acme_b", "acme_c", "acme_d"])):
        lines = "".join(f"  <exec_depend>{need}</exec_depend>\n" for need in needs)
        text = clean["package.xml"].replace("my_pkg", name).replace("  <export>", f"{lines}  <export>")
        write(tmp_path / "ws/src" / name, {"package.xml": text})
    return tmp_path / "ws"


def notes(cwd: Path, *arguments: str) -> list[tuple[str, str, int, str]]:
    done = rospkg("lint", "--select", "RPK008", "--format", "json", *arguments, cwd=cwd)
    return [(f["severity"], f["path"], f["line"], f["message"]) for f in json.loads(done.stdout)["findings"]]


def test_without_an_index_it_is_said_once_at_the_first_name(workspace: Path) -> None:
    (found,) = notes(workspace)
    assert found[:2] == ("info", "src/one/package.xml")
    assert found[3] == (
        "whether `acme_a`, `acme_b`, `acme_c` and 1 other exist is not checked: no index of names was fetched; "
        "`rospkg index update` fetches one"
    )
    line = (workspace / found[1]).read_text().splitlines()[found[2] - 1]
    assert "acme_a" in line


def test_only_the_packages_that_are_linted_count(workspace: Path) -> None:
    (found,) = notes(workspace, "src/two")
    assert "`acme_b`, `acme_c`, `acme_d` exist is not" in found[3]


@pytest.mark.parametrize("name, code", [("std-msgs", "DEP001"), ("roscpp", "DEP203")])
def test_a_name_that_is_judged_all_the_same_is_left_out(workspace: Path, name: str, code: str) -> None:
    for package in ("one", "two"):
        path = workspace / "src" / package / "package.xml"
        path.write_text(path.read_text().replace("acme_b", name))
    assert f"`acme_a`, `{name}`, `acme_c` and 1 other exist" in notes(workspace)[0][3]
    done = rospkg("lint", "--select", f"RPK008,{code}", "--format", "json", cwd=workspace)
    told = {each["code"]: each["message"] for each in json.loads(done.stdout)["findings"]}
    assert told[code].startswith(f"`{name}`")
    assert told["RPK008"].startswith("whether `acme_a`, `acme_c`, `acme_d` exist is not checked")


def test_known_names_switch_nothing_off(workspace: Path) -> None:
    for name in ("one", "two"):
        path = workspace / "src" / name / "package.xml"
        path.write_text("".join(line for line in path.read_text().splitlines(True) if "acme" not in line))
    assert notes(workspace) == []


def test_a_list_of_repositories_is_named_until_all_are_here(workspace: Path) -> None:
    (workspace / "src/ours.repos").write_text(LIST)
    (found,) = notes(workspace)
    assert found[3].endswith("not checked: `src/ours.repos` lists repositories that are not here (arm, tools/gripper)")
    (workspace / "src/arm").mkdir()
    assert "(arm, tools/gripper)" in notes(workspace)[0][3]  # an empty folder
    (workspace / "src/arm/README.md").touch()
    assert "(tools/gripper)" in notes(workspace)[0][3]
    (workspace / "src/tools/gripper/docs").mkdir(parents=True)
    assert locate([workspace]).scope.incomplete == ""
    (workspace / "src/tools").rename(workspace / "src/others")
    assert "(tools/gripper)" in notes(workspace)[0][3]
    (workspace / "src/others/gripper").rename(workspace / "src/gripper")  # cloned beside the others
    assert locate([workspace]).scope.incomplete == ""
    assert "no index" in notes(workspace)[0][3]


@pytest.mark.parametrize("place", ["ours.repos", "src/one/deep.repos", "src/one/.rosinstall"])
def test_lists_are_looked_for_from_the_package_to_the_workspace(workspace: Path, place: str) -> None:
    text = (
        LIST if place.endswith("repos") else "- git: {local-name: arm, uri: x}\n- other: {local-name: tools/gripper}\n"
    )
    (workspace / place).write_text(text)
    assert locate([workspace]).scope.incomplete.startswith(f"`{place}` lists repositories that are not here (arm")
    for name in ("arm", "tools/gripper"):
        (workspace / "src" / name / "x").mkdir(parents=True)
    assert locate([workspace]).scope.incomplete == ""


@pytest.mark.parametrize(
    "number, told", [(1, "r0"), (3, "r0, r1, r2"), (4, "r0, r1, r2 and 1 other"), (5, "r0, r1, r2 and 2 others")]
)
def test_many_repositories_are_counted(workspace: Path, number: int, told: str) -> None:
    (workspace / "ours.repos").write_text("repositories:\n" + "".join(f"  r{n}: {{}}\n" for n in range(number)))
    assert locate([workspace]).scope.incomplete.endswith(f" ({told})")


@pytest.mark.parametrize(
    "number, told", [(1, "`a0` exists is"), (3, "`a2` exist is"), (4, "and 1 other exist"), (5, "and 2 others exist")]
)
def test_many_names_are_counted(number: int, told: str) -> None:
    off = CheckSwitchedOff("package.xml", Span(0, 0), tuple(f"a{n}" for n in range(number)), "because")
    (hit,) = check_switched_off.check(off)
    assert told in hit.message


def test_with_an_index_only_names_like_a_missing_repository_are_left_out() -> None:
    facts = PackageFacts("a", "a")
    around = Workspace((facts,), frozenset({"a"}), False, index=FetchedNames(dump(Index("", "", (), {}, {}))))
    listed = replace(around, missing_repositories=frozenset({"gripper"}))
    assert is_unsure(around, "acme_x")
    assert is_unsure(replace(listed, index=BUILT_IN), "acme_x")
    assert not is_unsure(listed, "acme_x")
    assert is_unsure(listed, "gripper_x")


@pytest.mark.parametrize("text", ["", "repositories: [", "\0"])
def test_a_list_that_cannot_be_read_may_name_anything(workspace: Path, text: str) -> None:
    (workspace / "ours.repos").write_text(text)
    assert locate([workspace]).scope.incomplete == "`ours.repos` lists repositories and can't be read"


@pytest.mark.parametrize(
    "text, names",
    [
        (LIST, ["arm", "tools/gripper"]),
        ("repositories: {}", []),
        ("repositories: [a]", []),
        ("other: {a: {}}", []),
        ("- git: {local-name: a}\n- svn: x\n- tar: {local-name: [b]}\n- c", ["a"]),
    ],
)
def test_what_a_list_names(text: str, names: list[str]) -> None:
    assert listed_repositories(text.encode()) == names


def test_no_list_and_a_long_one() -> None:
    for data in (b"", b"# nothing\n", b"\xff", b"repositories:\n" + b"".join(b"  r%d: 1\n" % n for n in range(1_001))):
        with pytest.raises((ValueError, UnreadableError)):
            listed_repositories(data)


def test_text_tells_it_behind_the_counts_and_it_never_fails(workspace: Path) -> None:
    done = rospkg("lint", "--select", "RPK008,XML104", "--fail-on", "info", cwd=workspace)
    assert done.returncode == 0
    summary, note = done.stdout.splitlines()
    assert summary.startswith("No problems found (2 packages")
    assert note.startswith("note: whether `acme_a`")
    assert rospkg("lint", "--select", "RPK008,XML104", "--quiet", cwd=workspace).stdout == ""


def test_an_empty_submodule_is_named(workspace: Path) -> None:
    (workspace / ".gitmodules").write_text('[submodule "x"]\n\tpath = src/x\n\turl = y\n')
    assert notes(workspace)[0][3].endswith("the submodule `src/x` is empty; `git submodule update --init` fills it")
