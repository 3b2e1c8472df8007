"""LCH011 unknown-component."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.launch.loaded_components import LoadedComponents
from ...checks.launch.one_cause import CausedPlace
from ...checks.launch.unknown_component import UnknownComponent
from ...edits.caused_places import level_of, other_places
from ...example import CMAKE, Example, manifest
from ...finding import Edit, Fix, Hit, Safety, Severity
from ...rule import rule

BAD = """\
<launch>
  <node_container pkg="rclcpp_components" exec="component_container" name="c" namespace="">
    <composable_node pkg="my_pkg" plugin="«my_pkg::Taker»" name="talker"/>
  </node_container>
</launch>
"""
COMPONENT = """\
find_package(rclcpp REQUIRED)
find_package(rclcpp_components REQUIRED)
add_library(talker SHARED src/talker.cpp)
target_link_libraries(talker rclcpp::rclcpp rclcpp_components::component)
rclcpp_components_register_nodes(talker "my_pkg::Talker")
install(TARGETS talker DESTINATION lib)
install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})
"""
FILES = {
    "package.xml": manifest(
        "  <depend>rclcpp</depend>\n  <depend>rclcpp_components</depend>\n  <exec_depend>ros2launch</exec_depend>\n",
        "ament_cmake",
    ),
    "CMakeLists.txt": CMAKE.replace("ament_package", COMPONENT + "ament_package"),
    "src/talker.cpp": (
        "#include <rclcpp/rclcpp.hpp>\n#include <rclcpp_components/register_node_macro.hpp>\n\n"
        "RCLCPP_COMPONENTS_REGISTER_NODE(my_pkg::Talker)\n"
    ),
    "launch/a.launch.xml": BAD,
}


@rule(
    "LCH011",
    "unknown-component",
    over=LoadedComponents,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "the condition of its container is not known, or an old distribution had the name, and the "
        "repository is for later ones",
        Severity.INFO: "its container is off by default or never added, or an old distribution had the name, and "
        "nothing shows that the repository is for later ones",
    },
    examples=(
        Example(
            bad=FILES,
            good={"launch/a.launch.xml": BAD.replace("«my_pkg::Taker»", "my_pkg::Talker")},
            on="ament_cmake",
            fix=Safety.UNSAFE,
        ),
    ),
)
def unknown_component(loaded: LoadedComponents) -> Iterator[Hit]:
    """
    ## What it does
    Finds components in launch files that the CMakeLists.txt of their package does not register.
    Composable nodes of this package, or of another one of the workspace, have to be in
    `rclcpp_components_register_node`. A component of an unknown package is reported where another package registers its
    class. Of well-known packages it knows the components: it reports names a letter or two away from one, and those
    that only old distributions had. All places of a name in the launch files of a package are one finding, at the worst
    of them.

    ## Why is this bad?
    The container starts, and says "Failed to find class with the requested plugin name" (or, of a package that
    registers none, "Could not find requested resource in ament index"); it goes on without the node.

    ## When it is quiet
    Left alone are packages whose components are not all known. Where CMake calls a macro of another package, or
    includes a file that can't be read, these may register more: then only a misspelt registered name is reported. Where
    this package's source registers the class and CMake names another, CMK108 reports it there.

    It is an info

    - where the container is off by default or never added to the launch description;
    - for names of Foxy or Galactic, unless the run checks for a distribution (`--target`), or pages and scripts name
      Humble or later ones alone;
    - where package.xml declares a package of the same prefix that no distribution has: a fork may have the component.

    ## Fix safety
    The name is replaced by the only similar class; another one may be right.
    """
    for places in loaded.unknown_together():
        first = places[0]
        _, why = loaded.level_of(first.item)
        message = message_for(first.item, f", {why}" if why else "")
        yield Hit(first.path, first.span, message, level_of(places), other_places(places), rename(places))


def message_for(each: UnknownComponent, why: str) -> str:
    if each.wrong is not None:
        now = "it is called `{}` now" if each.wrong.is_removed else "did you mean `{}`?"
        hint = f"; {now.format(each.wrong.better)}" if each.wrong.better else ""
        more = " any more" if each.wrong.is_removed else ""
        return f"`{each.package}` has no component `{each.name}`{more}: the container can't load it{why}{hint}"
    if each.facts is None:
        whose = " or ".join(f"`{name}` of `{package}`" for package, name in each.elsewhere[:3])
        return f"no package `{each.package}` is known, so the container can't load `{each.name}`{why}; there is {whose}"
    if each.suggestion:
        hint = f"did you mean `{each.suggestion}`?"
    elif each.elsewhere:
        hint = "there is " + " or ".join(f"`{name}` of `{package}`" for package, name in each.elsewhere[:3])
    else:
        there = ", ".join(f"`{name}`" for name in sorted(each.facts.components)[:6]) or "no component at all"
        hint = f"it registers {there}"
    return f"`{each.facts.name}` registers no component `{each.name}`: the container can't load it{why}; {hint}"


def rename(places: list[CausedPlace[UnknownComponent]]) -> Fix | None:
    better = places[0].item.suggestion
    if better is None or not all(each.item.plain for each in places):
        return None
    return Fix(f"load `{better}`", tuple(Edit(each.path, each.span, better) for each in places), Safety.UNSAFE)
