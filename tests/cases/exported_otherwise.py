"""Plugins that are exported without a plain call of pluginlib's: by the index, foreign and own macros (PLG002)."""

from __future__ import annotations

from rospkg_cli.example import Example
from rospkg_cli.rules.plugins import plg002_unexported_plugin as plg002

FILES = {**plg002.PLUGIN, "plugins.xml": plg002.XML, "src/planner.cpp": plg002.SOURCE}
REGISTERS = (
    'ament_index_register_resource("nav2_core__pluginlib__plugin" CONTENT "share/my_pkg/plugins.xml\\n")\n',
    "ament_index_register_resource(${KIND})\n",
    'ament_index_register_resource("other" CONTENT "plugins.xml")\n',
    "find_package(our_macros REQUIRED)\nour_macros_share(FILES plugins.xml)\n",
    "find_package(our_macros REQUIRED)\nour_macros_share(FILES other.xml)\n",
)
WRAPPED = """\
#define EACH(SHOWN) SHOWN(Planner)
#define SHOWN(name) PLUGINLIB_EXPORT_CLASS(my_pkg::name, nav2_core::GlobalPlanner)
EACH(SHOWN)
"""
ELSEWHERE = plg002.XML.replace('path="my_planner"', 'path="{}"').replace("my_pkg::Planner", "our::Planner")


def on_cmake(**more: str) -> Example:
    return Example(
        bad={**FILES, **{p.replace("__", "/").replace("_DOT_", "."): t for p, t in more.items()}},
        good={},
        on="ament_cmake",
    )


IN_HEADER = {
    "src__planner_DOT_cpp": '#include "my_pkg/all.hpp"\n',
    "include__my_pkg__planner_DOT_hpp": plg002.SOURCE.replace("my_pkg::Planner", "our_pkg::Planner"),
    "include__my_pkg__all_DOT_hpp": '#include "planner.hpp"\n',
}
CASES = {
    "PLG002": (
        *(on_cmake(CMakeLists_DOT_txt=plg002.PACKAGE.replace(plg002.EXPORT, text)) for text in REGISTERS),
        on_cmake(src__planner_DOT_cpp=WRAPPED),
        on_cmake(**IN_HEADER),
        on_cmake(**{**IN_HEADER, "src__planner_DOT_cpp": "int planner() {return 1;}\n"}),
        *(on_cmake(plugins_DOT_xml=ELSEWHERE.format(name), src__planner_DOT_cpp="") for name in ("our", "my_planner")),
    ),
}
