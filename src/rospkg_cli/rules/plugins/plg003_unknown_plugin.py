"""PLG003 unknown-plugin."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...checks.plugins.unknown_plugins import PluginReferences, UnknownPlugin
from ...edits.plain_names import only_plain_names
from ...edits.well_known_plugins import same_renames, well_known
from ...example import CMAKE, Example, manifest
from ...finding import Edit, Fix, Hit, Related, Safety, Severity
from ...package.workspace import Workspace
from ...rule import rule

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
CONFIG = """\
planner_server:
  ros__parameters:
    planner_plugins: [GridBased]
    GridBased:
      plugin: my_pkg/Planner
"""
FILES = {
    "package.xml": manifest("  <depend>nav2_core</depend>\n  <depend>pluginlib</depend>\n", "ament_cmake"),
    "CMakeLists.txt": PACKAGE,
    "plugins.xml": """\
<library path="my_planner">
  <class name="my_pkg/Planner" type="my_pkg::Planner" base_class_type="nav2_core::GlobalPlanner"/>
</library>
""",
    "src/planner.cpp": """\
#include <pluginlib/class_list_macros.hpp>
PLUGINLIB_EXPORT_CLASS(my_pkg::Planner, nav2_core::GlobalPlanner)
""",
}


@rule(
    "PLG003",
    "unknown-plugin",
    over=Workspace,
    severity=Severity.WARNING,
    levels={
        Severity.INFO: "an old distribution had the plugin, none has it and another package may, it is the `type` of "
        "what may be no plugin, no list of plugins names its block, it is in the block of another plugin that may not "
        "read it, nothing spawns the controller though others are spawned, nothing names the file, or it "
        "is a panel of RViz, which goes on without it"
    },
    examples=(
        Example(
            on="ament_cmake",
            bad={**FILES, "config/nav2.yaml": CONFIG.replace("my_pkg/Planner", "«my_pkg::Planner»")},
            good={"config/nav2.yaml": CONFIG},
            fix=Safety.UNSAFE,
        ),
    ),
)
def unknown_plugin(workspace: Workspace) -> Iterator[Hit]:
    """
    ## What it does
    Finds plugin names in parameters, RViz configs and robots that no plugin description has.
    For a name such as `plugin: my_pkg/Planner` a package of the workspace should have it: the one that the name begins
    with, or, where that is no package, the one that has a plugin of the same class: an info where both names have no
    word in common. Components and interfaces, whose names may be alike, are left alone. Where only the package with the
    description is checked, it is reported there. Of packages that everybody uses it knows the plugins: it says what is
    a letter or two away from one, what differs by words such as `Plugin` and `Layer`, what only distributions had that
    are no longer supported, and what none has.

    ## Why is this bad?
    A plugin is found by its exact name; `my_pkg/Planner` and `my_pkg::Planner` are two names. The server that should
    load it stops when it starts: "… with base class type … does not exist".

    ## When it is quiet
    Packages whose plugins are not all known, plugins in Python, names of components and interfaces are left alone, and
    so are names of packages that exist or are declared but are not here, and a `plugin` in the block of a well-known
    plugin that reads no such key: DWB knows its critics by `class`. It is an info for a controller that no other file
    names, where its siblings are named, in a parameter file or robot that nothing names, though nodes are launched, for
    a panel of an RViz config, which goes on without it, and where a comment says that nothing reads it, or a comment or
    page has people write it. What is offered there is of the same kind: a panel, a display, a tool or a view.

    ## Fix safety
    The name is changed only with `--unsafe-fixes`: the description may be what is wrong.
    """
    references = PluginReferences(workspace)
    yield from map(well_known, same_renames(references.misspelt()))
    for unknown, *others in same_names(references.unknown()):
        if unknown.user.folder in workspace.selected:
            yield at_use(unknown, others)
        elif unknown.suggestion is not None and unknown.owner.folder in workspace.selected:
            yield at_description(unknown)


def same_names(found: Iterable[UnknownPlugin]) -> Iterable[list[UnknownPlugin]]:
    """Return the uses of each name in each package: one cause, often one slip in the description."""
    by_name: dict[tuple[str, str], list[UnknownPlugin]] = {}
    for each in found:
        by_name.setdefault((each.user.folder, each.use.name), []).append(each)
    return by_name.values()


def at_use(unknown: UnknownPlugin, others: Iterable[UnknownPlugin]) -> Hit:
    use, owner, near = unknown.use, unknown.owner, unknown.suggestion
    path = unknown.user.at(use.path)
    is_unsure = unknown.is_guess or (near is None and use.is_plain_type)
    level = None if any(each.use.is_listed for each in (unknown, *others)) and not is_unsure else Severity.INFO
    again = [(unknown.user.at(other.use.path), other.use.span) for other in others]
    places = tuple(Related(*place, "here too") for place in again)
    if near is None:
        known = ", ".join(f"`{plugin.name}`" for plugin in owner.plugins[:5])
        message = f"`{owner.name}` describes no plugin `{use.name}`: loading it fails; it has {known}"
        return Hit(path, use.span, message, level, places)
    fails = f"loading it fails{', unless a package elsewhere has it' if unknown.is_guess else ''}"
    message = f"no plugin is called `{use.name}`: {fails}; write `{near.name}`, as `{owner.name}` has it"
    related = (Related(owner.at(near.path), near.span, "described here"), *places)
    edits = tuple(Edit(*place, near.name) for place in ((path, use.span), *again))
    fix = Fix(f"write `{near.name}`", edits, Safety.UNSAFE)
    return Hit(path, use.span, message, level, related, fix=only_plain_names(fix, near.name))


def at_description(unknown: UnknownPlugin) -> Hit:
    use, near = unknown.use, unknown.suggestion
    assert near is not None
    message = (
        f"`{unknown.user.name}` uses the plugin `{use.name}`, and this one is called `{near.name}`: it is not found; "
        f"rename one of them"
    )
    level = None if use.is_listed and not unknown.is_guess else Severity.INFO
    related = (Related(unknown.user.at(use.path), use.span, "used here"),)
    return Hit(unknown.owner.at(near.path), near.span, message, level, related)
