"""PLG004 wrong-plugin-library."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.plugins.library_paths import PluginLibraries, WrongLibraryPath
from ...edits.cmake_commands import add_before
from ...edits.plain_names import only_plain_names
from ...example import CMAKE, Example, manifest
from ...finding import Edit, Fix, Hit, Safety, Severity
from ...rule import rule
from ...suggest import did_you_mean

INSTALL = """\
install(TARGETS my_planner
  ARCHIVE DESTINATION lib
  LIBRARY DESTINATION lib
  RUNTIME DESTINATION bin
)
"""
PACKAGE = CMAKE.replace(
    "ament_package()",
    f"""\
find_package(nav2_core REQUIRED)
find_package(pluginlib REQUIRED)
add_library(my_planner SHARED src/planner.cpp)
target_link_libraries(my_planner PUBLIC nav2_core::nav2_core pluginlib::pluginlib)
pluginlib_export_plugin_description_file(nav2_core plugins.xml)
install(DIRECTORY config DESTINATION share/${{PROJECT_NAME}})
{INSTALL}ament_package()""",
)
NAMED = "planner_server:\n  ros__parameters:\n    GridBased:\n      plugin: my_pkg/Planner\n"
"""What loads the plugin by its name."""
NEEDS = manifest("  <depend>nav2_core</depend>\n  <depend>pluginlib</depend>\n", "ament_cmake")
XML = """\
<library path="my_planner">
  <class name="my_pkg/Planner" type="my_pkg::Planner" base_class_type="nav2_core::GlobalPlanner"/>
</library>
"""
SOURCE = """\
#include <pluginlib/class_list_macros.hpp>
PLUGINLIB_EXPORT_CLASS(my_pkg::Planner, nav2_core::GlobalPlanner)
"""
FILES = {"package.xml": NEEDS, "CMakeLists.txt": PACKAGE, "src/planner.cpp": SOURCE, "config/nav2.yaml": NAMED}


@rule(
    "PLG004",
    "wrong-plugin-library",
    over=PluginLibraries,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "the path begins with `lib`: pluginlib finds it, and warns at each start; or nothing here "
        "loads the plugin by its name",
        Severity.INFO: "nothing names the plugin, where others of the package are named or code makes its class",
    },
    examples=(
        Example(
            on="ament_cmake",
            bad={**FILES, "plugins.xml": XML.replace('"my_planner"', '"«my_palnner»"')},
            good={"plugins.xml": XML},
            fix=Safety.SAFE,
        ),
        Example(
            on="ament_cmake",
            bad={**FILES, "plugins.xml": XML.replace('"my_planner"', '"«libmy_planner»"')},
            good={"plugins.xml": XML},
            fix=Safety.SAFE,
        ),
        Example(
            on="ament_cmake",
            bad={
                **FILES,
                "CMakeLists.txt": PACKAGE.replace(INSTALL, ""),
                "plugins.xml": XML.replace('"my_planner"', '"«my_planner»"'),
            },
            good={"CMakeLists.txt": PACKAGE, "plugins.xml": XML},
            fix=Safety.SAFE,
        ),
    ),
)
def wrong_plugin_library(libraries: PluginLibraries) -> Iterator[Hit]:
    """
    ## What it does
    Finds `<library path="…">` in plugin descriptions that pluginlib can't load.
    A target of the package builds the library, its name is given without `lib`, folder and suffix, it is no static
    library, and it is installed.

    ## Why is this bad?
    pluginlib looks for `lib<path>.so` below the prefix of the package, and only when the plugin is loaded: "Could not
    find library corresponding to plugin … Make sure the plugin description XML file has the correct name".

    ## When it is quiet
    Libraries that are fetched, prebuilt or of a name that CMake computes, and those for tests, are left alone; so are
    classes that no source exports, which PLG002 reports. It is an error where something here loads one of the plugins
    by its name, else a warning, and an info where others of the package are named or code makes it, as with PLG002.
    """
    for wrong in libraries.wrong():
        level, why = libraries.level(wrong)
        fix = only_plain_names(fixed(libraries, wrong), wrong.suggestion)
        message = sentence(libraries, wrong) + why
        yield Hit(wrong.entry.description.file, wrong.path.value_span, message, Severity(level), fix=fix)


def sentence(libraries: PluginLibraries, wrong: WrongLibraryPath) -> str:
    path, right, plugin = wrong.path.value, wrong.suggestion, wrong.entry.plugin.lookup_name
    match wrong.fault:
        case "prefixed":
            return f"`{path}` begins with `lib`: pluginlib finds it, and warns at each start; write `{right}`"
        case "static":
            return f"`{path}` is a static library: pluginlib can't load `{plugin}`; make it `SHARED`"
        case "absent":
            return f"`{path}` is not installed: `{plugin}` can't be loaded; add `install(TARGETS {right} …)`"
    if wrong.is_certain:
        return f"no target makes a library `{path}`: `{plugin}` can't be loaded; write `{right}`, where it is compiled"
    known = [each.name for each in libraries.cmake.targets if each.is_library and each.is_built]
    hint = f" (did you mean `{right}`?)" if right else did_you_mean(path, known)
    return f"no target makes a library `{path}`{hint}: `{plugin}` can't be loaded; correct the name"


def fixed(libraries: PluginLibraries, wrong: WrongLibraryPath) -> Fix | None:
    if wrong.fault in ("prefixed", "unknown") and wrong.suggestion:
        safety = Safety.SAFE if wrong.is_certain else Safety.UNSAFE
        edit = Edit(wrong.entry.description.file, wrong.path.value_span, wrong.suggestion)
        return Fix(f"write `{wrong.suggestion}`", (edit,), safety)
    root = libraries.cmake.root
    before = next(iter(libraries.cmake.named("ament_package", "ament_auto_package")), None)
    if wrong.fault == "absent" and before is not None and before.path == root.path and not before.function:
        places = ("ARCHIVE DESTINATION lib", "LIBRARY DESTINATION lib", "RUNTIME DESTINATION bin")
        lines = "".join(f"\n{root.indent}{place}" for place in places)
        edit = add_before(root, before.command, f"install(TARGETS {wrong.suggestion}{lines}\n)")
        return Fix(f"install `{wrong.suggestion}`", (edit,))
    return None
