"""PLG007 unexported-tree-nodes."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.plugins.tree_nodes import TreeNodeLibraries
from ...example import CMAKE, Example, manifest
from ...finding import Hit, Severity
from ...rule import rule

NEEDS = manifest("  <depend>behaviortree_cpp</depend>\n", "ament_cmake")
SOURCE = """\
#include <behaviortree_cpp/bt_factory.h>

class Wait : public BT::SyncActionNode
{
public:
  using BT::SyncActionNode::SyncActionNode;
  static BT::PortsList providedPorts() {return {};}
  BT::NodeStatus tick() override {return BT::NodeStatus::SUCCESS;}
};

«BT_REGISTER_NODES(factory)» {factory.registerNodeType<Wait>("Wait");}
"""
LOADS = "bt_navigator:\n  ros__parameters:\n    plugin_lib_names: [wait_node]\n"
LINES = """\
find_package(behaviortree_cpp REQUIRED)
add_library(wait_node SHARED src/wait.cpp)
{}target_link_libraries(wait_node behaviortree_cpp::behaviortree_cpp)
install(TARGETS wait_node DESTINATION lib)
install(DIRECTORY config DESTINATION share/${{PROJECT_NAME}})
"""


def cmake(more: str) -> str:
    return CMAKE.replace("ament_package", LINES.format(more) + "ament_package")


@rule(
    "PLG007",
    "unexported-tree-nodes",
    over=TreeNodeLibraries,
    severity=Severity.WARNING,
    levels={Severity.INFO: "nothing here names the library, and no package needs this one"},
    examples=(
        Example(
            bad={"CMakeLists.txt": cmake(""), "package.xml": NEEDS, "src/wait.cpp": SOURCE, "config/nav2.yaml": LOADS},
            good={"CMakeLists.txt": cmake("target_compile_definitions(wait_node PRIVATE BT_PLUGIN_EXPORT)\n")},
            on="ament_cmake",
        ),
    ),
)
def unexported_tree_nodes(libraries: TreeNodeLibraries) -> Iterator[Hit]:
    """
    ## What it does
    Finds libraries of behavior-tree nodes that are compiled without `BT_PLUGIN_EXPORT`.
    Their sources call `BT_REGISTER_NODES`.

    ## Why is this bad?
    BehaviorTree.CPP makes a static function of the macro then, which is in no library's table: the build is green, and
    whoever loads the plugin, such as navigation2, prints "can't find symbol [BT_RegisterNodesFromPlugin]" and does not
    know its nodes.

    ## When it is quiet
    Where any CMake file or source of the package names `BT_PLUGIN_EXPORT`, where the file itself calls the function,
    where another source of the package registers nodes itself, and for programs and static libraries, which may do so.
    Where no parameter file, code, launch file or page of the package names the library, and no package of the workspace
    needs this one, nothing is known to load it: an info.
    """
    for each in libraries.unexported():
        add = f"target_compile_definitions({each.target} PRIVATE BT_PLUGIN_EXPORT)"
        lost = f"`{each.target}` exports no nodes, as `BT_PLUGIN_EXPORT` is not defined: whoever loads it finds none"
        is_loaded = libraries.is_loaded(each.target)
        why, level = ("", None) if is_loaded else (", and nothing here is shown to load it", Severity.INFO)
        yield Hit(each.file.path, each.call.span, f"{lost}{why}; add `{add}`", level)
