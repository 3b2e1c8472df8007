"""PLG002 unexported-plugin."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.plugins.export_advice import PluginExports
from ...checks.plugins.exported_classes import ExportedClass
from ...edits.cmake_commands import add_before
from ...edits.plain_names import only_plain_names
from ...edits.plugin_hits import undefined_classes, undescribed_classes, without_source
from ...example import CMAKE, Example, manifest
from ...finding import Fix, Hit, Related, Safety, Severity
from ...package.plugins.description import PluginDescription
from ...rule import rule

EXPORT = "pluginlib_export_plugin_description_file(nav2_core plugins.xml)\n"
PACKAGE = CMAKE.replace(
    "ament_package()",
    f"""\
find_package(nav2_core REQUIRED)
find_package(pluginlib REQUIRED)
add_library(my_planner SHARED src/planner.cpp)
target_link_libraries(my_planner PUBLIC nav2_core::nav2_core pluginlib::pluginlib)
install(TARGETS my_planner DESTINATION lib)
install(DIRECTORY config DESTINATION share/${{PROJECT_NAME}})
{EXPORT}ament_package()""",
)
NAMED = "planner_server:\n  ros__parameters:\n    GridBased:\n      plugin: my_pkg/Planner\n"
"""What loads the plugin by its name."""
UNNAMED = "planner_server:\n  ros__parameters:\n    use_sim_time: true\n"
NEEDS = manifest("  <depend>nav2_core</depend>\n  <depend>pluginlib</depend>\n", "ament_cmake")
PLUGIN = {"package.xml": NEEDS, "CMakeLists.txt": PACKAGE, "config/nav2.yaml": NAMED}
XML = """\
<library path="my_planner">
  <class name="my_pkg/Planner" type="my_pkg::Planner" base_class_type="nav2_core::GlobalPlanner"/>
</library>
"""
SOURCE = """\
#include <pluginlib/class_list_macros.hpp>
PLUGINLIB_EXPORT_CLASS(my_pkg::Planner, nav2_core::GlobalPlanner)
"""


@rule(
    "PLG002",
    "unexported-plugin",
    over=PluginExports,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "nothing here loads the plugin by its name; a source exports a class, and no description has "
        "it, or no target compiles the source",
        Severity.INFO: "nothing names the plugin, where others of the package are named, or code makes its class "
        "itself or registers it for behavior trees, or nothing defines it, or makes its library; the class is the base "
        "of another one that is exported, or class_loader loads it",
    },
    examples=(
        Example(
            on="ament_cmake",
            bad={
                **PLUGIN,
                "plugins.xml": XML.replace("my_pkg::Planner", "«my_pgk::Planner»"),
                "src/planner.cpp": SOURCE,
            },
            good={"plugins.xml": XML},
            fix=Safety.SAFE,
        ),
        Example(
            on="ament_cmake",
            bad={
                **PLUGIN,
                "config/nav2.yaml": UNNAMED,
                "plugins.xml": XML,
                "src/planner.cpp": SOURCE + "PLUGINLIB_EXPORT_CLASS(«my_pkg::Other», nav2_core::GlobalPlanner)\n",
            },
            good={"src/planner.cpp": SOURCE},
        ),
        Example(
            on="ament_cmake",
            bad={
                **PLUGIN,
                "CMakeLists.txt": PACKAGE.replace(EXPORT, ""),
                "plugins.xml": "«" + XML.replace('">\n', '">»\n', 1),
                "src/planner.cpp": SOURCE,
            },
            good={"CMakeLists.txt": PACKAGE},
            fix=Safety.UNSAFE,
        ),
    ),
)
def unexported_plugin(exports: PluginExports) -> Iterator[Hit]:
    """
    ## What it does
    Finds plugins that are exported in C++ and not described, or described and not exported.
    It compares the descriptions (`<class type="…">`) with PLUGINLIB_EXPORT_CLASS in the sources, and finds descriptions
    that CMake does not export with `pluginlib_export_plugin_description_file`.

    ## Why is this bad?
    pluginlib finds a plugin by its description, and in the library by exactly the string that the macro was given. With
    one and not the other it is not offered, or can't be created; nothing fails at build time.

    ## When it is quiet
    Only sources that certainly become part of a library count. What a macro of another package or one of the package's
    own may register, a description that such a macro or the ament index is given, what is compiled conditionally,
    libraries that are fetched or prebuilt, and sources that could not be read, are left alone. A class from which
    another exported class derives may well be there for that alone: an info. A plugin is an error where parameters,
    robots, views, launch files or code of the workspace name it, or a loader of its base class is here, or one that
    loads all plugins (image_transport). Where only a page names it, or nothing, others may load it: a warning. It is an
    info where other plugins of the package are named, where nothing names the class and code of the package makes
    objects of it itself or registers it as a node of behavior trees (BehaviorTree.CPP loads the library, and reads no
    description), where nothing defines or names the class, or no target makes its library, and for a class without a
    description where the package uses class_loader, which needs none.

    ## Fix safety
    The type of a description is set to what the source exports. A missing export of the description in CMake is added
    only with `--unsafe-fixes`: its package is taken from the base class.
    """
    package = exports.package
    yield from undefined_classes(exports)
    yield from (without_source(exports, each) for each in package.without_source() if not exports.is_nowhere(each))
    for description, exported in package.unexported():
        yield unexported(exports, description, exported)
    yield from undescribed_classes(exports)


def unexported(exports: PluginExports, description: PluginDescription, exported: ExportedClass) -> Hit:
    package = exports.package
    base = exported.base.lstrip(":").partition("::")[0]
    call = f"pluginlib_export_plugin_description_file({base} {description.file})"
    start = f"CMakeLists.txt does not export `{description.file}`: `{exported.type}` is not found at run time"
    message = f"{start}; add `{call}` (`{base}`: the package that loads it)"
    where = next(((e.path, e.span) for e in description.exported), (description.file, description.document.root.open))
    before, fix = next(iter(package.cmake.named("ament_package", "ament_auto_package")), None), None
    if before is not None and before.path == package.cmake.root.path and not before.function:
        edit = add_before(package.cmake.root, before.command, call)
        added = Fix(f"export `{description.file}` to `{base}`", (edit,), Safety.UNSAFE)
        fix = only_plain_names(added, description.file, base)
    message, level = exports.weighed(message, "error", description.classes)
    return Hit(*where, message, Severity(level), (Related(exported.path, exported.span, "this class"),), fix)
