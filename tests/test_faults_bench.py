"""The bench that puts single faults into packages: what it finds, changes, puts back and counts."""

from __future__ import annotations

import ast
import json
import stat
import sys
from collections import Counter
from dataclasses import replace
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[1]))

from bench.faults.__main__ import Copies, as_record, read_records
from bench.faults.comments import without_comments
from bench.faults.draw import draw
from bench.faults.fault import typo
from bench.faults.kinds import KINDS
from bench.faults.load import load
from bench.faults.source_package import SourcePackage, packages_of
from bench.faults.table import table
from bench.faults.trial import Linter, Trial, attempt, is_named, replaced
from bench.faults.working_copy import WorkingCopy

load()

MANIFEST = """\
<?xml version="1.0"?>
<package format="3">
  <name>{name}</name>
  <version>0.1.0</version>
  <description>Drives a robot</description>
  <maintainer email="a@b.org">A</maintainer>
  <license>Apache-2.0</license>
  <!-- <depend>old_dependency</depend> -->
  <exec_depend>{depend}</exec_depend>
  <exec_depend>rclpy</exec_depend>
  <export><build_type>ament_python</build_type></export>
</package>
"""
SETUP = """\
from glob import glob
from setuptools import setup

package_name = 'drive'
setup(
    name=package_name,
    version='0.1.0',
    packages=[package_name],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
        ('share/' + package_name + '/launch', glob('launch/*.launch.py')),
    ],
    entry_points={'console_scripts': ['wheel = drive.wheel:main']},
)
"""
LAUNCH = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='drive', executable='wheel'),  # package='commented'
    ])
"""
FILES = {
    "drive/package.xml": MANIFEST.format(name="drive", depend="steer"),
    "drive/setup.py": SETUP,
    "drive/setup.cfg": "[develop]\nscript_dir=$base/lib/drive\n[install]\ninstall_scripts=$base/lib/drive\n",
    "drive/resource/drive": "",
    "drive/drive/__init__.py": "",
    "drive/drive/wheel.py": "import rclpy\n\n\ndef main():\n    rclpy.init()\n",
    "drive/launch/drive.launch.py": LAUNCH,
    "steer/package.xml": MANIFEST.format(name="steer", depend="rclpy").replace(
        "<exec_depend>rclpy</exec_depend>", "", 1
    ),
    "ignored/COLCON_IGNORE": "",
    "ignored/package.xml": MANIFEST.format(name="ignored", depend="steer"),
}


@pytest.fixture(scope="module")
def packages(tmp_path_factory: pytest.TempPathFactory) -> list[SourcePackage]:
    repository = tmp_path_factory.mktemp("repository")
    for path, text in FILES.items():
        (repository / path).parent.mkdir(parents=True, exist_ok=True)
        (repository / path).write_text(text, encoding="utf-8")
    return packages_of(repository)


def test_packages_and_their_files(packages: list[SourcePackage]) -> None:
    assert [each.name for each in packages] == ["drive", "steer"]
    assert packages[0].siblings == {"drive": "drive", "steer": "steer"}
    assert "launch/drive.launch.py" in packages[0].files


@pytest.mark.parametrize(
    ("file", "text", "bare"),
    [
        ("a.py", 'x = "#1" # two\n', 'x = "#1"      \n'),
        ("a.py", '"""a\nb"""\nc\n', "    \n    \nc\n"),
        ("CMakeLists.txt", 'set(A "#") # b\n#[[ c\n]] d\n', 'set(A "#")    \n     \n   d\n'),
        ("a.xml", "<a/><!-- b\n--><c/>", "<a/>      \n   <c/>"),
        ("a.yaml", "a: b#c # d\n", "a: b#c    \n"),
        ("a.cpp", '"//" // a\n/* b */ c', '"//"     \n        c'),
    ],
)
def test_comments_are_blanks(file: str, text: str, bare: str) -> None:
    assert without_comments(file, text) == bare


def test_a_typo_is_another_word_and_always_the_same() -> None:
    for word in ("rclcpp", "a", "tf2_ros", "x1", "aaaa", "nav2_util", "ab"):
        assert typo(word) != word
        assert typo(word) == typo(word)
        assert typo(word)[:1] == word[:1]


def test_there_are_many_kinds_and_each_says_what_it_names(packages: list[SourcePackage]) -> None:
    assert len(KINDS) >= 100
    for kind in KINDS.values():
        for package, fault in draw(kind, packages, 2, 1):
            assert fault.names, kind.name
            assert fault.path.startswith(f"{package.folder}/"), kind.name


def test_a_draw_follows_from_its_seed(packages: list[SourcePackage]) -> None:
    kind = KINDS["manifest-mistyped-tag"]
    assert [fault for _, fault in draw(kind, packages, 2, 1)] == [fault for _, fault in draw(kind, packages, 2, 1)]
    assert len(list(draw(kind, packages, 1, 1))) == 1


def text_of(packages: list[SourcePackage], kind: str) -> str:
    """The faulty file after the first fault of a kind."""
    _package, fault = next(draw(KINDS[kind], packages, 1, 1))
    return (fault.files[fault.path] or b"").decode()


def test_a_lost_dependency_leaves_no_tag_of_it(packages: list[SourcePackage]) -> None:
    assert "rclpy" not in text_of(packages, "depend-lost-that-is-imported")
    assert "old_dependency" in text_of(packages, "depend-lost-that-is-imported")


def test_what_stands_in_a_comment_is_left_alone(packages: list[SourcePackage]) -> None:
    faults = [fault for package in packages for fault in KINDS["launch-mistyped-sibling"].places(package)]
    assert [fault.names for fault in faults] == [("drive", typo("drive"))]


def test_a_setup_py_that_raises_is_still_python(packages: list[SourcePackage]) -> None:
    ast.parse(text_of(packages, "setup-without-import-of-glob"))
    ast.parse(text_of(packages, "setup-comma-between-tuples"))


def tried(packages: list[SourcePackage], kind: str, copy: WorkingCopy) -> Trial:
    package, fault = next(draw(KINDS[kind], packages, 1, 1))
    return attempt(Linter(), copy, KINDS[kind], package, fault)


@pytest.fixture
def copy(packages: list[SourcePackage], tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> WorkingCopy:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    return WorkingCopy(packages[0].repository, tmp_path / "copy")


def test_a_fault_is_put_in_and_taken_out_of_the_copy_alone(packages: list[SourcePackage], copy: WorkingCopy) -> None:
    _package, fault = next(draw(KINDS["registered-module-renamed"], packages, 1, 1))
    with copy.with_fault(fault):
        assert not (copy.folder / "drive/drive/wheel.py").exists()
        assert (copy.original / "drive/drive/wheel.py").exists()
    for path, text in FILES.items():
        assert (copy.folder / path).read_text("utf-8") == (copy.original / path).read_text("utf-8") == text
    assert {path.name for path in (copy.folder / "drive/drive").iterdir()} == {"__init__.py", "wheel.py"}


def test_a_bit_is_lost_in_the_copy_alone(packages: list[SourcePackage], copy: WorkingCopy) -> None:
    copy.put("drive/setup.py", b"pass\n", is_executable_no_more=True)
    assert not (copy.folder / "drive/setup.py").stat().st_mode & stat.S_IXUSR
    assert (copy.original / "drive/setup.py").read_text("utf-8") == SETUP


def test_what_is_told_counts_and_what_stands_beside(packages: list[SourcePackage], copy: WorkingCopy) -> None:
    lost = tried(packages, "marker-lost", copy)
    assert lost.told
    assert lost.told[0].startswith("SET")
    assert lost.beside_count == len(lost.told) + len(lost.beside) - 1
    lines = list(table([lost]))
    assert lines[1].split() == ["files", "1", "1", str(lost.beside_count), str(lost.added_count), "0"]
    old = ("DEP104", "a", "x")
    assert [replaced([new], Counter([old])) for new in (old, ("DEP104", "a", "y"), ("DEP104", "b", "x"))] == [1, 1, 1]
    assert [replaced([new], Counter([old])) for new in (("DEP105", "a", "x"), ("DEP104", "b", "y"))] == [0, 0]
    assert replaced([old, old], Counter([old])) == 1
    assert "killed 100.0% of all" in lines[-1]


def test_a_fault_in_a_file_that_nobody_could_read_before_is_excluded(
    packages: list[SourcePackage], copy: WorkingCopy
) -> None:
    package, fault = next(draw(KINDS["registered-module-renamed"], packages, 1, 1))
    path, kind = "drive/setup.py", KINDS["registered-module-renamed"]
    again = replace(fault, path=path, files={path: SETUP.encode() + b"\n"}, names=("nothing",), line=0)
    assert not attempt(Linter(), copy, kind, package, again).excluded
    with copy.with_fault(replace(again, files={path: b"def (:\n"})):
        assert attempt(Linter(), copy, kind, package, again).excluded.startswith("the file could not be read")


def test_what_was_killed_is_not_tried_again(packages: list[SourcePackage], copy: WorkingCopy, tmp_path: Path) -> None:
    lost = tried(packages, "marker-lost", copy)
    records = tmp_path / "trials.jsonl"
    silent = {**as_record(lost), "place": "elsewhere", "killed": False}
    records.write_text(f"{json.dumps(as_record(lost))}\n{json.dumps(silent)}\n", "utf-8")
    assert len(read_records(records)) == 1
    again = Copies(Linter(), tmp_path, read_records(records)).trial(lost.kind, lost.package, lost.fault)
    assert again == lost


def test_a_finding_names_by_word_by_file_or_by_line(packages: list[SourcePackage]) -> None:
    _, fault = next(draw(KINDS["depend-mistyped-sibling"], packages, 1, 1))
    finding = {"message": "", "path": "other/setup.py", "line": fault.line}
    assert not is_named(fault, finding)
    assert is_named(fault, {**finding, "message": "no package is called `steer`"})
    assert not is_named(fault, {**finding, "message": "no package is called `steer_more`, nor `my-steer`"})
    assert is_named(fault, {**finding, "path": fault.path})
    assert not is_named(fault, {**finding, "path": fault.path, "line": fault.line + 1})
