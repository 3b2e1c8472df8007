"""CMK108 unregistered-component."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.cmake.component_registration import ComponentRegistration, misread_keyword
from ...checks.cmake.component_sentences import unknown_class, unknown_target
from ...checks.cmake.unloadable_components import unloadable_components
from ...checks.cpp.components_elsewhere import components_elsewhere
from ...edits.same_infos import same_infos_once
from ...example import CMAKE, Example, manifest
from ...finding import Hit, Related, Severity
from ...package.cmake.components import Component
from ...rule import rule
from ...suggest import nearest

BODY = "  <depend>rclcpp</depend>\n  <depend>rclcpp_components</depend>\n"
SOURCE = """\
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_components/register_node_macro.hpp>

namespace my_pkg
{
class Talker : public rclcpp::Node
{
public:
  explicit Talker(const rclcpp::NodeOptions & options)
  : Node("talker", options) {}
};
}  // namespace my_pkg

RCLCPP_COMPONENTS_REGISTER_NODE(my_pkg::Talker)
"""
LINES = """\
find_package(rclcpp REQUIRED)
find_package(rclcpp_components REQUIRED)
add_library(talker SHARED src/talker.cpp)
target_link_libraries(talker PUBLIC rclcpp::rclcpp rclcpp_components::component)
install(TARGETS talker DESTINATION lib)
rclcpp_components_register_node(talker PLUGIN "my_pkg::Talker" EXECUTABLE talker_node)
"""


def cmake(lines: str) -> str:
    return CMAKE.replace("ament_package", lines + "ament_package")


FILES = {"package.xml": manifest(BODY, "ament_cmake"), "src/talker.cpp": SOURCE}


@rule(
    "CMK108",
    "unregistered-component",
    over=ComponentRegistration,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "a source registers a class, no call of CMake does, and no launch file here loads it; or "
        "the keywords of one node are taken for classes; or it is registered of a program that nothing here loads, or "
        "of a library without it and of another one",
        Severity.INFO: "a source registers a class, and the package links its library itself, or the "
        "keyword of one node stands before its class, which is registered too",
    },
    examples=(
        Example(
            bad={**FILES, "CMakeLists.txt": cmake(LINES.replace('"my_pkg::Talker"', '«"my_package::Talker"»'))},
            good={"CMakeLists.txt": cmake(LINES)},
            on="ament_cmake",
        ),
        Example(
            bad={**FILES, "CMakeLists.txt": cmake(LINES.replace("node(talker", "node(«talkr»"))},
            good={"CMakeLists.txt": cmake(LINES)},
            on="ament_cmake",
        ),
        Example(
            bad={**FILES, "CMakeLists.txt": cmake(LINES.replace("node(talker PLUGIN", "nodes(talker «PLUGIN»"))},
            good={"CMakeLists.txt": cmake(LINES)},
            on="ament_cmake",
        ),
        Example(
            bad={
                **FILES,
                "CMakeLists.txt": cmake(LINES.replace("talker.cpp", "talker.cpp src/listener.cpp")),
                "src/listener.cpp": SOURCE.replace("Talker", "Listener").replace(
                    "NODE(my_pkg::Listener)", "NODE(«my_pkg::Listener»)"
                ),
            },
            good={
                "CMakeLists.txt": cmake(
                    LINES.replace("talker.cpp", "talker.cpp src/listener.cpp")
                    + 'rclcpp_components_register_node(talker PLUGIN "my_pkg::Listener" EXECUTABLE listener_node)\n'
                )
            },
            on="ament_cmake",
        ),
    ),
)
def unregistered_component(components: ComponentRegistration) -> Iterator[Hit]:
    """
    ## What it does
    Finds components that CMake and the C++ sources register differently.
    It compares `rclcpp_components_register_node(s)` with the classes in `RCLCPP_COMPONENTS_REGISTER_NODE`, and with the
    targets that exist: a component has to be in a shared library, and in the one that it is registered of.

    ## Why is this bad?
    Both have to say the same, to the letter. The build is green, and loading the component ends with "Failed to find
    class with the requested plugin name"; its executable ends with "Class … not found in library …" (Humble's says
    nothing, and spins without a node).

    ## When it is quiet
    Where a macro of the package registers classes, where sources are generated, absent or can't be evaluated, where a
    file that can't be read is included, and under a condition that can't be evaluated.
    """
    if not components.package.is_ament:
        return
    for each in components.without_target():
        yield Hit(each.target.path, each.target.span, unknown_target(components, each))
    yield from of_libraries(components)
    for word, asks in components.misread_keywords():
        yield Hit(word.path, word.span, misread_keyword(word, asks), Severity.WARNING if asks else Severity.INFO)
    for each in components.without_source():
        yield Hit(each.plugin.path, each.plugin.span, unknown_class(components, each), related=meant(components, each))
    left = components.without_cmake()
    hits = (Hit(each.path, each.span, each.unregistered, Severity(components.harm(each))) for each in left)
    yield from same_infos_once(hits, "")


def of_libraries(components: ComponentRegistration) -> Iterator[Hit]:
    for found in unloadable_components(components):
        yield Hit(found.word.path, found.word.span, found.sentence, Severity(found.level))
    for other in components_elsewhere(components):
        level = Severity.WARNING if other.is_loaded_by_another else None
        yield Hit(other.component.plugin.path, other.component.plugin.span, other.sentence, level)


def meant(components: ComponentRegistration, component: Component) -> tuple[Related, ...]:
    found = nearest(component.plugin.text, [each.name for each in components.in_sources])
    return tuple(
        Related(each.path, each.span, "this one is registered") for each in components.in_sources if each.name == found
    )
