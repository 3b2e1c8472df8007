"""PLG005 wrong-plugin-base."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.fault import Level
from ...checks.plugins.base_classes import PluginBases, WrongBaseClass, WrongBaseExport
from ...edits.cmake_commands import literal_span
from ...edits.loader_hits import at_loader
from ...edits.plain_names import only_plain_names
from ...example import CMAKE, Example, manifest
from ...finding import Edit, Fix, Hit, Safety, Severity
from ...light_dataclasses import replace
from ...rule import rule
from ...source import Source

PACKAGE = CMAKE.replace(
    "ament_package()",
    """\
find_package(nav2_core REQUIRED)
find_package(pluginlib REQUIRED)
add_library(my_planner SHARED src/planner.cpp)
target_link_libraries(my_planner PUBLIC nav2_core::nav2_core pluginlib::pluginlib)
install(TARGETS my_planner DESTINATION lib)
install(DIRECTORY config DESTINATION share/${PROJECT_NAME})
pluginlib_export_plugin_description_file(nav2_core plugins.xml)
ament_package()""",
)
NAMED = "planner_server:\n  ros__parameters:\n    GridBased:\n      plugin: my_pkg/Planner\n"
"""What loads the plugin by its name."""
XML = """\
<library path="my_planner">
  <class name="my_pkg/Planner" type="my_pkg::Planner" base_class_type="nav2_core::GlobalPlanner"/>
</library>
"""
FILES = {
    "package.xml": manifest("  <depend>nav2_core</depend>\n  <depend>pluginlib</depend>\n", "ament_cmake"),
    "CMakeLists.txt": PACKAGE,
    "plugins.xml": XML,
    "config/nav2.yaml": NAMED,
    "src/planner.cpp": """\
#include <pluginlib/class_list_macros.hpp>
PLUGINLIB_EXPORT_CLASS(my_pkg::Planner, nav2_core::GlobalPlanner)
""",
}


@rule(
    "PLG005",
    "wrong-plugin-base",
    over=PluginBases,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "nothing here loads the plugin by its name",
        Severity.INFO: "nothing names the plugin, where others of the package are named or code makes its class",
    },
    examples=(
        Example(
            on="ament_cmake",
            bad={**FILES, "CMakeLists.txt": PACKAGE.replace("file(nav2_core", "file(«my_core»")},
            good={"CMakeLists.txt": PACKAGE},
            fix=Safety.UNSAFE,
        ),
        Example(
            on="ament_cmake",
            bad={**FILES, "plugins.xml": XML.replace("nav2_core::GlobalPlanner", "«nav2_core::Planner»")},
            good={"plugins.xml": XML},
            fix=Safety.SAFE,
        ),
    ),
)
def wrong_plugin_base(bases: PluginBases) -> Iterator[Hit]:
    """
    ## What it does
    Finds plugins whose base class or package differs from what their loader uses.
    A description must be exported to the package that the loader names (`pluginlib::ClassLoader<Base>("package",
    "Base")`), and its `base_class_type` must be the string that the loader has, and the base in PLUGINLIB_EXPORT_CLASS
    where both are of one template or differ by a slip. Known are the loaders of the workspace, and those of
    navigation2, moveit2, ros2_control and rviz; plugins of other base classes are left alone.

    ## Why is this bad?
    The plugin does not exist for the loader: "According to the loaded plugin descriptions the class … with base class
    type … does not exist". A loader for a package that isn't there throws at once.

    ## When it is quiet
    But for such a slip, plugins of base classes whose loaders are not known are left alone. A package is believed to be
    a loader's where any loader around is not known. It is an error where something here loads the plugin by its name,
    else a warning, and an info where others of the package are named or code makes it, as with PLG002.

    ## Fix safety
    The base class is written as the loader has it. The package is changed only with `--unsafe-fixes`.
    """
    for misplaced in bases.misplaced():
        yield softer(at_export(bases, misplaced), *bases.named.worst(misplaced.description.classes))
    for misnamed in bases.misnamed():
        yield softer(at_class(misnamed), *bases.named.worst([misnamed.plugin]))
    for unmatched in bases.unmatched_loaders():
        yield at_loader(unmatched)


def softer(hit: Hit, level: Level, why: str) -> Hit:
    return replace(hit, message=f"{hit.message}{why}", level=Severity(level))


def at_export(bases: PluginBases, found: WrongBaseExport) -> Hit:
    at, file = found.exported, found.description.file
    if not found.owners:
        message = f"`{file}` is exported to `{at.base}`, which is no known package: nothing loads its plugins"
        return Hit(at.path, at.base_span, f"{message}; export it to the package of the base class")
    owners = " and ".join(f"`{owner}`" for owner in found.owners)
    message = f"`{file}` is exported to `{at.base}`, but `{found.base}` is loaded from {owners}: it is not found there"
    if len(found.owners) > 1:
        return Hit(at.path, at.base_span, f"{message}; export it to one of these")
    fix = written(bases, found)
    return Hit(at.path, at.base_span, f"{message}; export it to {owners}", fix=only_plain_names(fix, found.owners[0]))


def written(bases: PluginBases, found: WrongBaseExport) -> Fix | None:
    """Return the fix that writes another package, where this one is written literally."""
    assert bases.package is not None
    source: Source = bases.package.cmake.file(found.exported.path).source
    span = literal_span(source, found.exported.base_span, found.exported.base)
    edit = None if span is None else Edit(source.path, span, found.owners[0])
    return Fix(f"export it to `{found.owners[0]}`", (edit,), Safety.UNSAFE) if edit else None


def at_class(found: WrongBaseClass) -> Hit:
    base, file = found.plugin.base, found.description.file
    lost = f"`{found.plugin.lookup_name}` is never found"
    why = f"nothing loads plugins of `{base.value}`"
    if found.is_of_macro:
        why = f"`{base.value}` is not the base in the macro of `{found.plugin.type.value}`"
    message = f"{why}: {lost}; write `{found.suggestion}`"
    fix = Fix(f"write `{found.suggestion}`", (Edit(file, base.value_span, found.suggestion),))
    return Hit(file, base.value_span, message, fix=only_plain_names(fix, found.suggestion))
