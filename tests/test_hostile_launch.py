"""Launch files and XML that hold too much, or themselves: read in bounded time, or skipped and said to be."""

from __future__ import annotations

import pytest

from rospkg_cli.checks.read_sentences import what_is_wrong
from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.files import PackageFiles
from rospkg_cli.languages.python.evaluate.sandbox_filesystem import SandboxFilesystem
from rospkg_cli.languages.python.file import parse_python
from rospkg_cli.languages.xml.parser import MAX_ATTRIBUTES, MAX_ELEMENTS, read_xml
from rospkg_cli.package.launch.configuration_events import ConfigurationSummary
from rospkg_cli.package.launch.included_arguments import IncludedArguments
from rospkg_cli.package.launch.launch_evaluator import LaunchEvaluator
from rospkg_cli.package.launch.launch_signature import LaunchSignature
from rospkg_cli.package.launch.python_events import MAX_VISITS, ExecutionOrder
from rospkg_cli.package.launch.read_python import read_python_launch
from rospkg_cli.package.launch.workspace_launch_files import WorkspaceLaunchFiles
from rospkg_cli.package.setup.parse_setup_cfg import parse_setup_cfg
from rospkg_cli.source import Source
from rospkg_cli.testing import lint_files
from rospkg_cli.tree import MemoryTree
from rospkg_cli.unreadable import UnreadableError

HEAD = "from launch import LaunchDescription\nfrom launch.actions import *\n"
OPAQUE = f"""{HEAD}
def f(context):
    return [OpaqueFunction(function=f)] * 9

def generate_launch_description():
    return LaunchDescription([OpaqueFunction(function=f)] * 9)
"""
GROUPS = f"{HEAD}g = GroupAction([])\n" + "g = GroupAction([g, g])\n" * 40
CLASSES = "class A0:\n    def f(self): pass\n" + "".join(
    f"class A{i + 1}:\n    x = A{i}\n    y = A{i}\n" for i in range(40)
)
END = "def generate_launch_description():\n    return LaunchDescription([g])\n"


def folder() -> SandboxFilesystem:
    return SandboxFilesystem(PackageFiles(MemoryTree.of({})))


@pytest.mark.parametrize("text", [OPAQUE, GROUPS + END, CLASSES])
def test_what_holds_itself_comes_to_an_end(text: str) -> None:
    read_python_launch(parse_python(Source("a.launch.py", text)), folder())


def test_visits_are_bounded() -> None:
    evaluator = LaunchEvaluator(parse_python(Source("a.launch.py", OPAQUE)), folder())
    evaluator.run_all()
    visit = ExecutionOrder(evaluator)
    ((_, value),) = [each for each in evaluator.results.values() if each[0].name == "generate_launch_description"]
    assert sum(1 for _ in visit.visit(value, 0)) < 10 * MAX_VISITS


@pytest.mark.parametrize(
    "text",
    [
        "<a " + " ".join(f"b{i}='1'" for i in range(MAX_ATTRIBUTES + 1)) + "/>",
        "<a>" + "<b/>" * MAX_ELEMENTS + "</a>",
        "<a>" + "<!---->" * MAX_ELEMENTS + "</a>",
    ],
)
def test_xml_that_is_too_large_is_skipped(text: str) -> None:
    with pytest.raises(UnreadableError) as caught:
        read_xml(Source("a.xml", text))
    assert caught.value.unreadable.skipped
    assert what_is_wrong(caught.value.unreadable).startswith("`a.xml` is skipped: ")


def test_an_option_of_blanks_is_skipped() -> None:
    with pytest.raises(UnreadableError) as caught:
        parse_setup_cfg(Source("setup.cfg", "[a]\nb" + " " * 100_000 + "c = 1\n"))
    assert caught.value.unreadable.skipped


def test_files_that_include_each_other_are_followed_once() -> None:
    names = [f"{i}.launch.xml" for i in range(200)]
    files = WorkspaceLaunchFiles(
        ConfigurationSummary(name, frozenset({name}), frozenset(names), False) for name in names
    )
    first = files.defined_by(names[0])
    assert first == frozenset(names)
    assert all(files.defined_by(names[0]) is first for _ in range(100_000))
    inherited = files.inherited(names[0])
    assert inherited == frozenset(names)
    assert files.inherited(names[0]) is inherited


@pytest.mark.parametrize("before", [b"<?xml", b"Drives"])
@pytest.mark.parametrize("text", ["<node pkg='a' type='b' name='c'/>", "<let name='a' value='$(find b)'/>"])
def test_a_manifest_that_is_no_text_breaks_no_launch_rule(before: bytes, text: str) -> None:
    """LCH006 asks package.xml whether the package is one for ROS 1 too; what it knows without it, it still says."""
    files = {
        "package.xml": manifest("", "ament_cmake").encode().replace(before, b"\xff" + before),
        "CMakeLists.txt": CMAKE.replace(
            "ament_package", "install(DIRECTORY launch DESTINATION share/my_pkg)\nament_package"
        ),
        "launch/a.launch.xml": f"<launch>{text}</launch>",
    }
    found = {(finding.code, finding.location.path) for finding in lint_files(files).findings}
    assert ("RPK001", "package.xml") in found
    assert {code for code, path in found if path.startswith("launch/")} == ({"LCH006"} if "find" in text else set())
    assert "RPK005" not in {code for code, _ in found}


def test_what_files_that_include_each_other_take_is_found_out_once() -> None:
    names = [f"launch/{i}.launch.xml" for i in range(150)]
    includes = tuple(("", name) for name in names)
    known = IncludedArguments(
        ("my_pkg", LaunchSignature(name, frozenset(), frozenset({name}), includes=includes)) for name in names
    )
    first = known.takes("my_pkg", names[0])
    assert first == frozenset(names)
    assert all(known.takes("my_pkg", name) == first for name in names for _ in range(50))
    assert known.takes("my_pkg", names[0]) is first


def test_a_long_chain_of_includes() -> None:
    chain = [
        (
            "my_pkg",
            LaunchSignature(f"{i}", frozenset({f"{i}"}), frozenset({f"a{i}"}), includes=(("my_pkg", f"{i + 1}"),)),
        )
        for i in range(3_000)
    ]
    assert IncludedArguments(chain).takes("my_pkg", "0") is None
    last = ("my_pkg", LaunchSignature("3000", frozenset({"3000"})))
    taken = IncludedArguments([*chain, last]).takes("my_pkg", "0")
    assert taken is not None
    assert len(taken) == 3_000


def test_launch_files_that_are_too_long_together_are_skipped_and_that_is_said() -> None:
    one = f"<launch><!--{'a' * 120_000}--></launch>"
    files = {f"launch/{i}.launch.xml": one for i in range(6)}
    found = lint_files({"package.xml": manifest("", "ament_cmake"), "CMakeLists.txt": CMAKE, **files}, ["RPK007"])
    assert [each.location.path for each in found.findings] == ["launch/4.launch.xml", "launch/5.launch.xml"]
    assert "500,000 characters" in found.findings[0].message
