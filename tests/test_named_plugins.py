"""How grave it is that a plugin can't be loaded: by who names it."""

from __future__ import annotations

import pytest

from rospkg_cli.finding import Finding
from rospkg_cli.rules.plugins import plg002_unexported_plugin as plg002
from rospkg_cli.rules.plugins import plg003_unknown_plugin as plg003
from rospkg_cli.rules.plugins import plg004_wrong_plugin_library as plg004
from rospkg_cli.rules.plugins import plg005_wrong_plugin_base as plg005
from rospkg_cli.rules.plugins import plg006_unlisted_rqt_plugin as plg006
from rospkg_cli.testing import lint_files

RENAMED = plg002.XML.replace("my_pkg::Planner", "my_pkg::Plannr")
UNNAMED = {
    **plg002.PLUGIN,
    "config/nav2.yaml": plg002.UNNAMED,
    "plugins.xml": RENAMED,
    "src/planner.cpp": plg002.SOURCE,
}
LOADER = 'pluginlib::ClassLoader<nav2_core::GlobalPlanner> loader("nav2_core", "nav2_core::GlobalPlanner");\n'
MORE = '  <class name="my_pkg/{0}" type="my_pkg::{0}" base_class_type="nav2_core::GlobalPlanner"/>\n</library>'


def lint(code: str, files: dict[str, str | None], *others: dict[str, str]) -> Finding:
    every = {f"my_pkg/{path}": str(text) for path, text in files.items() if text is not None}
    (finding,) = lint_files({**every, **{k: v for each in others for k, v in each.items()}}, [code]).findings
    return finding


@pytest.mark.parametrize(
    "path, text, level",
    [
        ("config/nav2.yaml", plg002.NAMED, "error"),
        ("config/nav2.yaml", "# plugin: my_pkg/Planner\na: 1\n", "warning"),
        ("test/nav2.yaml", plg002.NAMED, "warning"),
        ("config/old/nav2.yaml", plg002.NAMED, "warning"),
        ("launch/nav2.launch.py", "nodes = [{'plugin': 'my_pkg/Planner'}]\n", "error"),
        ("src/server.cpp", 'auto one = loader.createSharedInstance("my_pkg/Planner");\n', "error"),
        ("src/server.cpp", "auto one = my_pkg/Planner;\n", "warning"),
        ("src/server.cpp", LOADER, "error"),
        ("scripts/give.py", "give('my_pkg/Planner2')\n", "warning"),
        ("README.md", "Set `plugin: my_pkg/Planner`.\n", "warning"),
    ],
)
def test_a_plugin_is_met_by_who_names_it(path: str, text: str, level: str) -> None:
    finding = lint("PLG002", {**UNNAMED, path: text})
    assert finding.severity.value == level
    assert finding.message.endswith("; only a page names it") is (path == "README.md")


@pytest.mark.parametrize(
    "text, level",
    [
        ("auto one = std::make_shared<my_pkg::Planner>();\n", "info"),
        ("auto one = std::make_shared<Planners>();\n", "warning"),
        ("class More : public my_pkg::Planner {};\n", "warning"),
    ],
)
def test_code_makes_it_itself(text: str, level: str) -> None:
    cmake = plg002.PACKAGE.replace("src/planner.cpp", "src/planner.cpp src/server.cpp")
    cmake = cmake.replace(plg002.EXPORT, "")
    files = {**UNNAMED, "CMakeLists.txt": cmake, "plugins.xml": plg002.XML, "src/server.cpp": text}
    assert lint("PLG002", files).severity.value == level
    assert lint("PLG002", {**files, "config/nav2.yaml": plg002.NAMED}).severity.value == "error"


def test_another_package_names_it() -> None:
    other = {"bringup/package.xml": "<package/>", "bringup/config/nav2.yaml": plg002.NAMED}
    other["bringup/package.xml"] = plg002.NEEDS.replace("my_pkg", "bringup")
    assert lint("PLG002", dict(UNNAMED), other).severity.value == "error"


def test_beside_plugins_that_are_named() -> None:
    described = plg002.XML.replace("</library>", MORE.format("Left"))
    finding = lint("PLG002", {**UNNAMED, "config/nav2.yaml": plg002.NAMED, "plugins.xml": described})
    assert (finding.severity.value, finding.message.rpartition("; ")[2]) == ("info", "nothing here names it")
    other = plg002.SOURCE + "PLUGINLIB_EXPORT_CLASS(my_pkg::Other, nav2_core::GlobalPlanner)\n"
    files = {**UNNAMED, "config/nav2.yaml": plg002.NAMED, "plugins.xml": plg002.XML, "src/planner.cpp": other}
    finding = lint("PLG002", dict(files))
    assert finding.severity.value == "info"
    assert finding.message.endswith("; nothing here names it, as it does `my_pkg/Planner`")
    named = plg002.NAMED + "    Other:\n      plugin: my_pkg::Other\n"
    assert lint("PLG002", {**files, "config/nav2.yaml": named}).severity.value == "warning"


@pytest.mark.parametrize(
    "base, level", [("image_transport::PublisherPlugin", "error"), ("rviz_common::Panel", "warning")]
)
def test_a_class_whose_kind_is_loaded_or_offered_as_a_whole(base: str, level: str) -> None:
    described = plg002.XML.replace("</library>", MORE.format("Left")).replace("nav2_core::GlobalPlanner", base)
    files = {**UNNAMED, "config/nav2.yaml": plg002.NAMED, "plugins.xml": described}
    assert lint("PLG002", dict(files)).severity.value == level


def test_class_loader_needs_no_description() -> None:
    files = {**UNNAMED, "src/main.cpp": 'int main() {class_loader::ClassLoader loader("libmy_planner.so");}\n'}
    files["CMakeLists.txt"] = plg002.PACKAGE.replace(plg002.EXPORT, "")
    finding = lint("PLG002", {**files, "plugins.xml": None})
    assert finding.severity.value == "info"
    assert finding.message.endswith("class_loader, which this package uses, needs no description")


def test_libraries_and_bases_of_plugins_that_nothing_names() -> None:
    lost = {**plg004.FILES, "plugins.xml": plg004.XML.replace('"my_planner"', '"my_palnner"')}
    assert lint("PLG004", dict(lost)).severity.value == "error"
    assert lint("PLG004", {**lost, "config/nav2.yaml": "a: 1\n"}).severity.value == "warning"
    wrong = {**plg005.FILES, "plugins.xml": plg005.XML.replace("nav2_core::GlobalPlanner", "nav2_core::Planner")}
    assert lint("PLG005", dict(wrong)).severity.value == "error"
    assert lint("PLG005", {**wrong, "config/nav2.yaml": "a: 1\n"}).severity.value == "warning"


ROBOT = "<robot name='a'><ros2_control><hardware><plugin>my_pkg/Plannr</plugin></hardware></ros2_control></robot>\n"
OPENS = "def generate_launch_description():\n    return open('urdf/{}')\n"


@pytest.mark.parametrize("opened, level", [("r.urdf.xacro", "warning"), ("other.urdf.xacro", "info")])
def test_what_a_robot_loads_that_nothing_names(opened: str, level: str) -> None:
    files = {**plg003.FILES, "urdf/r.urdf.xacro": ROBOT, "launch/a.launch.py": OPENS.format(opened)}
    assert lint("PLG003", dict(files)).severity.value == level


@pytest.mark.parametrize(
    "changed, level",
    [
        ({}, "error"),
        ({"my_pkg/panel.py": None}, "info"),
        ({"plugin.xml": None, "plugin_old.xml": plg006.XML}, "info"),
    ],
)
def test_rqt_plugins_that_nobody_misses(changed: dict[str, str | None], level: str) -> None:
    files = {"package.xml": plg006.NEEDS, "plugin.xml": plg006.XML, "my_pkg/panel.py": "class Panel:\n    pass\n"}
    files |= {"setup.py": plg006.SETUP_PY, "my_pkg/__init__.py": "", "resource/my_pkg": ""}
    every = {
        path: text.replace("«", "").replace("»", "") for path, text in {**files, **changed}.items() if text is not None
    }
    (finding,) = lint_files(every, ["PLG006"]).findings
    assert finding.severity.value == level
