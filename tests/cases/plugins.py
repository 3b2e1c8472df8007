"""Sentences about plugins that no example shows."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example
from rospkg_cli.rules.plugins import plg003_unknown_plugin as plg003
from rospkg_cli.rules.plugins import plg004_wrong_plugin_library as plg004
from rospkg_cli.rules.plugins import plg005_wrong_plugin_base as plg005
from rospkg_cli.rules.plugins import plg006_unlisted_rqt_plugin as plg006

STATIC = plg004.PACKAGE.replace("my_planner SHARED", "my_planner STATIC")
TWICE = plg004.PACKAGE.replace(
    "add_library(my_planner SHARED src/planner.cpp)",
    "add_library(my_planner SHARED src/planner.cpp)\nadd_library(my_other SHARED src/planner.cpp)",
)
"""The class is in two libraries, so that it can't be told which one is meant."""
THIRD = TWICE.replace("add_library(my_other", "add_library(my_third SHARED src/third.cpp)\nadd_library(my_other")
"""And there is one without it, which the path may mean all the same."""
LOADER = """\
#include <pluginlib/class_loader.hpp>
#include <nav2_core/global_planner.hpp>
int main() {pluginlib::ClassLoader<nav2_core::GlobalPlanner> loader("nav2_coer", "nav2_core::GlobalPlanner");}
"""


def on_cmake(files: dict[str, str], **changed: str) -> Example:
    named = {name.replace("__", "/").replace("_DOT_", "."): text for name, text in changed.items()}
    return Example(bad={**files, **named}, good={}, on="ament_cmake")


def described(path: str, cmake: str = plg004.PACKAGE, source: str = plg004.SOURCE) -> Example:
    """A plugin whose description names a library."""
    text = plg004.XML.replace('"my_planner"', f'"{path}"')
    return on_cmake(plg004.FILES, CMakeLists_DOT_txt=cmake, plugins_DOT_xml=text, src__planner_DOT_cpp=source)


def of_template(name: str) -> Example:
    """A plugin of a template, in a library that no target makes; tinyxml2 takes a `<` in a value."""
    kind = "my_pkg::Planner<nav_msgs::msg::Path>"
    text = plg004.XML.replace("my_pkg::Planner", name).replace('"my_planner"', '"my_plannre"')
    source = plg004.SOURCE.replace("my_pkg::Planner", kind)
    return on_cmake(plg004.FILES, plugins_DOT_xml=text, src__planner_DOT_cpp=source)


def asked_for(name: str) -> Example:
    return on_cmake(plg003.FILES, config__nav2_DOT_yaml=plg003.CONFIG.replace("my_pkg/Planner", name))


def exported_to(name: str) -> Example:
    return on_cmake(plg005.FILES, CMakeLists_DOT_txt=plg005.PACKAGE.replace("file(nav2_core", f"file({name}"))


UNNAMED = ("{}\n", plg004.NAMED.replace("my_pkg/Planner", "my_pkg/Second"))
"""Nothing names the plugin; only another one of the package is named."""
SECOND = '<class name="my_pkg/Second" type="my_pkg::Planner" base_class_type="nav2_core::GlobalPlanner"/></library>'
LOST = (
    "<class_libraries>\n"
    + plg004.XML.replace('"my_planner"', '"my_palnner"')
    + '<library path="my_planner">\n'
    + SECOND
    + "\n</class_libraries>\n"
)
BASE = plg005.XML.replace("nav2_core::GlobalPlanner", "nav2_core::Planner").replace("</library>", SECOND)

RQT = plg006.XML.replace("«", "").replace("»", "")

CASES = {
    "PLG006": (
        Example(
            bad={
                "package.xml": plg006.LISTED.replace("ament_python", "ament_cmake"),
                "CMakeLists.txt": CMAKE.replace(
                    "ament_package",
                    "pluginlib_export_plugin_description_file(rqt_gui plugin.xml)\n"
                    "pluginlib_export_plugin_description_file(rqt_gui other.xml)\nament_package",
                ),
                "plugin.xml": RQT,
                "other.xml": RQT.replace("Panel", "Other"),
            },
            good={},
            on="ament_cmake",
        ),
    ),
    "PLG003": (
        asked_for("my_pkg/SomethingElse"),
        asked_for("my_pkg/Plannr"),
        asked_for("my_pgk/Planner"),
        on_cmake(
            {
                **plg003.FILES,
                **{f"config/{name}.yaml": plg003.CONFIG.replace("my_pkg/", "my_pkg::") for name in ("a", "b")},
            }
        ),
    ),
    "PLG004": (
        *(on_cmake(plg004.FILES, plugins_DOT_xml=LOST, config__nav2_DOT_yaml=text) for text in UNNAMED),
        described("my_planner", STATIC),
        described("lib/libmy_planner.so", TWICE),
        described("my_planer", TWICE),
        described("nothing_alike", TWICE),
        described("lib/libmy_third.so", THIRD),
        of_template("my_pkg::Planner<nav_msgs::msg::Path>"),
        of_template("my_pkg::Planner&lt;nav_msgs::msg::Path&gt;"),
    ),
    "PLG005": (
        *(on_cmake(plg005.FILES, plugins_DOT_xml=BASE, config__nav2_DOT_yaml=text) for text in UNNAMED),
        exported_to("rviz_common"),
        *(
            on_cmake(
                plg005.FILES,
                plugins_DOT_xml=plg005.XML.replace("nav2_core::GlobalPlanner", base),
                src__planner_DOT_cpp=plg005.FILES["src/planner.cpp"].replace("nav2_core::GlobalPlanner", "a::B<c::D>"),
            )
            for base in ("a::B<c::E>", "a::B< c::D >", "a::B<D>", "b::B<c::E>", "a::B")
        ),
        *(
            on_cmake(
                plg005.FILES,
                plugins_DOT_xml=plg005.XML.replace("nav2_core::GlobalPlanner", base),
                src__planner_DOT_cpp=plg005.FILES["src/planner.cpp"].replace("nav2_core::Global", "of_us::Far"),
            )
            for base in ("of_us::FarPlaner", "of_us::FarPlanner", "of_us::Planner", "of_them::FarPlaner")
        ),
        on_cmake(plg005.FILES, src__planner_DOT_cpp=plg005.FILES["src/planner.cpp"] + LOADER),
    ),
}
