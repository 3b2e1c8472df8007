"""What helps a plugin that is described and not exported, or exported and not described."""

from __future__ import annotations

import pytest

from rospkg_cli.finding import Finding
from rospkg_cli.rules.plugins import plg002_unexported_plugin as plg002
from rospkg_cli.testing import lint_files

CLASS = "class Planner : public nav2_core::GlobalPlanner {};\n"
FILES = {**plg002.PLUGIN, "plugins.xml": plg002.XML, "src/planner.cpp": plg002.SOURCE}


def lint(**changed: str) -> tuple[Finding, ...]:
    files = {**FILES, **{name.replace("__", "/").replace("_DOT_", "."): text for name, text in changed.items()}}
    return lint_files(files, ["PLG002"]).findings


@pytest.mark.parametrize(
    "files, advice",
    [
        ({"src__planner_DOT_cpp": "\n"}, "; nothing here defines the class: remove it here"),
        ({"src__planner_DOT_cpp": "void Planner::plan() {}\n"}, "to its source, or remove it here"),
        ({"src__planner_DOT_cpp": CLASS}, "to its source, or remove it here"),
        ({"src__planner_DOT_cpp": "\n", "include__planner_DOT_hpp": CLASS}, "to its source, or remove it here"),
        ({"src__planner_DOT_cpp": "int Planners = 1;\n"}, "; nothing here defines the class: remove it here"),
        (
            {"src__planner_DOT_cpp": "\n", "src__other_DOT_cpp": CLASS},
            "to `src/other.cpp`, which no target compiles, and compile it into the library",
        ),
    ],
)
def test_what_helps_a_class_that_no_source_exports(files: dict[str, str], advice: str) -> None:
    (finding,) = lint(**files)
    assert finding.severity.value == "error"
    assert finding.message.endswith(advice)
    assert ("PLUGINLIB_EXPORT_CLASS(my_pkg::Planner, nav2_core::GlobalPlanner)" in finding.message) is (
        "nothing" not in advice
    )


def test_who_has_a_class_of_that_name_is_said() -> None:
    files = {f"my_pkg/{path}": text for path, text in FILES.items()} | {"my_pkg/src/planner.cpp": "\n"}
    other = {f"other/{path}": str(text).replace("my_pkg", "other") for path, text in FILES.items()}
    found = lint_files({**files, **other}, ["PLG002"]).findings
    assert [each.message.rpartition("; ")[2] for each in found] == [
        "nothing here defines the class: remove it here (there is `other/Planner`)"
    ]


@pytest.mark.parametrize(
    "source, level",
    [
        ("class Planner : public Other {};\n", "info"),
        ("class API Planner final : public my_pkg::Other {};\n", "info"),
        ("struct Planner : Base, Other {};\n", "info"),
        ("class Planner : public Others {};\n", "warning"),
        ("class Planner {}; class Third : public Other {};\n", "warning"),
        ("class Planner; int a = b ? c : Other;\n", "warning"),
    ],
)
def test_a_base_of_another_plugin_is_an_info(source: str, level: str) -> None:
    other = "PLUGINLIB_EXPORT_CLASS(my_pkg::Other, nav2_core::GlobalPlanner)\n"
    (finding,) = lint(src__planner_DOT_cpp=plg002.SOURCE + other + source)
    assert finding.severity.value == level
    assert ("the base of `my_pkg::Planner`" in finding.message) is (level == "info")
