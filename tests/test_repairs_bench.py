"""The bench of repairs: how it reads two commits, and when a repair counts as seen."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[1]))

from bench.repairs.__main__ import LIST, judged
from bench.repairs.checkout import checkout
from bench.repairs.fitting import FITTING, NAMELESS
from bench.repairs.verdict import naming
from rospkg_cli.rule_table import rule_entries

MANIFEST = """\
<?xml version="1.0"?>
<package format="3">
  <name>drive</name>
  <version>0.1.0</version>
  <description>Drives a robot</description>
  <maintainer email="a@b.org">A</maintainer>
  <license>Apache-2.0</license>
  <exec_depend>rclpy</exec_depend>
</package>
"""
PYTHON = "  <export><build_type>ament_python</build_type></export>\n</package>"


def git(folder: Path, *arguments: str) -> str:
    names = {f"GIT_{who}_{what}": "a@b.org" for who in ("AUTHOR", "COMMITTER") for what in ("NAME", "EMAIL")}
    command = ["git", "-C", str(folder), "-c", "init.defaultBranch=main", *arguments]
    return subprocess.run(command, capture_output=True, text=True, check=True, env={**os.environ, **names}).stdout


@pytest.fixture(scope="module")
def mirror(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("mirror")
    work = folder / "owner+name" / "work"
    (work / "drive" / "drive").mkdir(parents=True)
    (work / "drive/package.xml").write_text(MANIFEST, "utf-8")
    (work / "drive/run.py").write_text("#!/usr/bin/env python3\n", "utf-8")
    (work / "drive/run.py").chmod(0o755)
    (work / "drive/big.bin").write_bytes(b"0" * 1_000_001)
    (work / "drive/near").symlink_to("run.py")
    (work / "drive/far").symlink_to("../../../../../etc/hosts")
    git(work, "init", "-q")
    git(work, "add", "-A")
    git(work, "commit", "-qm", "before")
    (work / "drive/package.xml").write_text(MANIFEST.replace("</package>", PYTHON), "utf-8")
    git(work, "commit", "-qam", "after")
    (work / ".git").rename(folder / "owner+name" / "repo")
    return folder


def repair(mirror: Path, **other: str) -> dict[str, str]:
    before, after = git(mirror / "owner+name" / "repo", "log", "--format=%H", "--reverse").split()
    known = {"repo": "owner/name", "before": before, "after": after, "package": "drive", "token": ""}
    return {**known, "class": "missing-build-type", **other}


def test_a_tree_as_it_was(mirror: Path, tmp_path: Path) -> None:
    checkout(mirror / "owner+name" / "repo", repair(mirror)["before"], tmp_path)
    assert (tmp_path / "drive/package.xml").read_text("utf-8") == MANIFEST
    assert os.access(tmp_path / "drive/run.py", os.X_OK)
    assert not os.access(tmp_path / "drive/package.xml", os.X_OK)
    assert (tmp_path / "drive/near").readlink() == Path("run.py")
    assert not (tmp_path / "drive/far").exists()
    assert (tmp_path / "drive/big.bin").read_bytes() == b""


def test_told_before_and_not_after_is_solved(mirror: Path) -> None:
    assert judged(mirror, repair(mirror)) == "solved"


def test_told_before_and_after_is_not(mirror: Path) -> None:
    assert judged(mirror, repair(mirror, after=repair(mirror)["before"])) == "still told"


def test_a_silent_rule_finds_nothing(mirror: Path) -> None:
    assert judged(mirror, {**repair(mirror), "class": "cmake-syntax-error"}) == "not found"


def test_a_commit_that_is_not_there(mirror: Path) -> None:
    assert judged(mirror, repair(mirror, before="0" * 40)) == "absent"


def test_a_finding_names_a_token_as_a_word() -> None:
    known = {"class": "missing-exec-depend", "token": "tf2_ros"}
    finding = {"code": "DEP101", "message": "`tf2_ros` is imported and not declared", "path": "a.py"}
    assert naming(known, [finding]) == ["DEP101"]
    assert naming(known, [{**finding, "code": "XML104"}]) == []
    assert naming(known, [{**finding, "message": "`tf2_ros-py` is imported and not declared"}]) == []
    brought = "`rclpy` is imported and not declared: it comes with `tf2_ros` today; declare what you use"
    assert naming(known, [{**finding, "message": brought}]) == []
    by_file = {"class": "launch-missing-file", "token": "robot.rviz"}
    assert naming(by_file, [{"code": "LCH003", "message": "", "path": "config/Robot.rviz"}]) == ["LCH003"]


def test_the_list_of_repairs_is_whole() -> None:
    repairs = [json.loads(line) for line in LIST.read_text("utf-8").splitlines()]
    assert len({each["id"] for each in repairs}) == len(repairs) >= 80
    assert len({each["repo"] for each in repairs}) >= 20
    assert {each["class"] for each in repairs} <= set(FITTING)
    assert {each["verdict"] for each in repairs} <= {"solved", "not found", "still told"}
    assert all(each.get("excluded", "why") for each in repairs)
    assert all(each["token"] or each["class"] in NAMELESS for each in repairs)


def test_the_rules_that_fit_are_there() -> None:
    codes = set(rule_entries())
    for rules in FITTING.values():
        assert all(any(code.startswith(rule) for code in codes) for rule in rules), rules
