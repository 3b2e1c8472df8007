"""CMK108 unregistered-component."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.cmake.component_sentences import unknown_target
from ...checks.cpp.loaded_by_name import LoadedByName
from ...edits.component_hits import of_keywords, of_libraries, of_names, of_sources
from ...example import CMAKE, Example, manifest
from ...finding import Hit, Severity
from ...rule import rule

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
    over=LoadedByName,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "a source registers a class, no call of CMake does, and no launch file here loads it; or "
        "the keywords of one node are taken for classes, so that a program is missing which a launch file or a page "
        "starts; or it is registered of a program that nothing here loads, or "
        "of a library without it and of another one, or code makes the class itself and nothing starts the program "
        "that would load it",
        Severity.INFO: "a source registers a class, and the package links its library itself, or "
        "keywords of one node stand among the classes, and nothing starts the program that they ask for, or "
        "something else makes it, or code makes the class itself, and "
        "nothing here loads it by its name",
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
            bad={
                **FILES,
                "CMakeLists.txt": cmake(LINES.replace("node(talker PLUGIN", "nodes(talker «PLUGIN»")),
                "README.md": "    ros2 run my_pkg talker_node\n",
            },
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
def unregistered_component(loaded: LoadedByName) -> Iterator[Hit]:
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
    Where a macro of the package registers classes, where a macro of another package is given the class by its name,
    where sources are generated, absent or can't be evaluated, where a file that can't be read is included, under a
    condition that can't be evaluated, and where CMake fills the resource index of components itself. Where code of the
    package makes objects of the class itself (`std::make_shared<…>()`, `new`, a member), or derives from it, and no
    launch file, parameter, code or command of a page has its name, nothing loads it: an info, and a warning where CMake
    makes a program for it that nothing here starts.
    """
    components = loaded.registration
    if not components.package.is_ament:
        return
    for each in components.without_target():
        yield Hit(each.target.path, each.target.span, unknown_target(components, each))
    yield from of_libraries(loaded)
    yield from of_keywords(loaded)
    yield from of_names(loaded)
    yield from of_sources(loaded)
