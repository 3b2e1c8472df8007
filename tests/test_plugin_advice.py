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
            "to `src/other.cpp`, which no target compiles, and compile it in",
        ),
    ],
)
def test_what_helps_a_class_that_no_source_exports(files: dict[str, str], advice: str) -> None:
    (finding,) = lint(**files)
    assert finding.severity.value == ("warning" if "no target" in advice else "error")
    assert finding.message.endswith(advice)
    assert ("PLUGINLIB_EXPORT_CLASS(my_pkg::Planner, nav2_core::GlobalPlanner)" in finding.message) is (
        "nothing" not in advice
    )


REGISTERED = 'BT_REGISTER_NODES(factory) {\n  factory.registerNodeType<Planner>("Plan");\n}\n'


@pytest.mark.parametrize(
    ("nodes", "parameters", "level"),
    [
        (REGISTERED, plg002.UNNAMED, "info"),
        (REGISTERED.replace("NodeType<Planner", "Builder<my_pkg::Planner"), plg002.UNNAMED, "info"),
        (REGISTERED, plg002.NAMED, "error"),
        (REGISTERED.replace("<Planner>", "<Other>"), plg002.UNNAMED, "warning"),
        (REGISTERED.replace("  factory", "  // factory"), plg002.UNNAMED, "warning"),
        ("", plg002.UNNAMED, "warning"),
    ],
)
def test_a_node_of_behavior_trees_needs_no_description(nodes: str, parameters: str, level: str) -> None:
    (finding,) = lint(src__planner_DOT_cpp=CLASS + nodes, config__nav2_DOT_yaml=parameters)
    assert finding.severity.value == level
    assert ("PLUGINLIB_EXPORT_CLASS" in finding.message) is (level != "info")
    assert finding.message.endswith(
        "`src/planner.cpp` registers it for behavior trees, which need no description: remove it here"
    ) is (level == "info")


@pytest.mark.parametrize(
    ("path", "text", "level"),
    [
        ("README.md", "Set `plugin: my_pkg/Planner`.\n", "warning"),
        ("src/server.cpp", 'pluginlib::ClassLoader<B> one("nav2_core", "nav2_core::GlobalPlanner");\n', "error"),
    ],
)
def test_a_node_of_behavior_trees_that_may_be_loaded_as_a_plugin(path: str, text: str, level: str) -> None:
    files = {**FILES, "src/planner.cpp": CLASS + REGISTERED, "config/nav2.yaml": plg002.UNNAMED, path: text}
    (finding,) = lint_files(files, ["PLG002"]).findings
    assert (finding.severity.value, "behavior trees" in finding.message) == (level, False)


def test_a_source_that_nothing_compiles_exports_nothing() -> None:
    other = "PLUGINLIB_EXPORT_CLASS(old::Planner, nav2_core::GlobalPlanner)\n"
    (finding,) = lint(src__planner_DOT_cpp="\n", src__other_DOT_cpp=other)
    assert (finding.severity.value, finding.fix) == ("warning", None)
    assert finding.message == (
        "no target compiles `src/other.cpp`, which exports `old::Planner`: loading the plugin `my_pkg/Planner` fails; "
        "compile it into the library, and write `old::Planner` here"
    )
    assert [(where.path, text) for where, text in finding.related] == [("src/other.cpp", "exported here")]


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
    (finding,) = lint(src__planner_DOT_cpp=plg002.SOURCE + other + source, config__nav2_DOT_yaml=plg002.UNNAMED)
    assert finding.severity.value == level
    assert ("the base of `my_pkg::Planner`" in finding.message) is (level == "info")


ENTRY = '  <class name="{0}" type="my_pkg::{0}" base_class_type="nav2_core::GlobalPlanner"/>\n'
MACRO = "PLUGINLIB_EXPORT_CLASS(my_pkg::{}, nav2_core::GlobalPlanner)\n"


def test_classes_that_are_nowhere_are_one_finding_of_their_description() -> None:
    described = f'<library path="my_planner">\n{ENTRY.format("Left")}{ENTRY.format("Right")}</library>\n'
    (finding,) = lint(plugins_DOT_xml=described, src__planner_DOT_cpp="\n")
    assert finding.message == (
        "no source exports `my_pkg::Left` and `my_pkg::Right`: loading the plugins `Left` and `Right` fails; nothing "
        "here defines the classes: remove them here; nothing here names them, others may"
    )
    assert [(where.path, where.line, text) for where, text in finding.related] == [
        ("plugins.xml", 3, "`my_pkg::Right`")
    ]


def test_classes_that_no_description_has_are_one_finding() -> None:
    source = plg002.SOURCE + MACRO.format("Left") + MACRO.format("Right")
    (finding,) = lint(src__planner_DOT_cpp=source, config__nav2_DOT_yaml=plg002.UNNAMED)
    assert finding.severity.value == "warning"
    assert finding.message == (
        "`my_pkg::Left` and `my_pkg::Right` are exported here, and no plugin description has them: they can't be "
        'loaded by name; add `<class type="my_pkg::Left" base_class_type="nav2_core::GlobalPlanner">` to one, or '
        "remove the macro"
    )
    assert [(where.line, text) for where, text in finding.related] == [(4, "`my_pkg::Right`")]


def test_a_class_may_be_in_a_library_of_a_package_that_is_linked() -> None:
    """class_loader makes what any loaded library registered; the description may be elsewhere."""
    own = {f"my_pkg/{path}": str(text) for path, text in FILES.items()}
    other = {path.replace("my_pkg/", "core/", 1): text.replace("my_pkg", "core") for path, text in own.items()}
    own["my_pkg/src/planner.cpp"] = "\n"
    own["my_pkg/package.xml"] = own["my_pkg/package.xml"].replace("  <export>", "  <depend>core</depend>\n  <export>")
    (found,) = lint_files({**own, **other}, ["PLG002"]).findings
    assert found.severity.value == "warning"
    assert "remove it here, unless `core` has it (there is" in found.message
    other["core/plugins.xml"] = other["core/plugins.xml"].replace("core::Planner", "core::Other")
    other["core/src/planner.cpp"] = plg002.SOURCE + MACRO.format("Other").replace("my_pkg", "core")
    found = lint_files({**own, **other}, ["PLG002"]).findings
    assert [each.location.path for each in found] == ["my_pkg/plugins.xml"]
