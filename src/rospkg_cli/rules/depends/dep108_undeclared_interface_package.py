"""DEP108 undeclared-interface-package."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.depends.interface_types import InterfaceTypeDependencies
from ...edits.manifest import add_dependency
from ...example import CMAKE, Example, manifest
from ...finding import Fix, Hit, Related, Safety, Severity
from ...rule import rule

CMAKE_MSG = CMAKE.replace(
    "ament_package()",
    "find_package(geometry_msgs REQUIRED)\n"
    "find_package(rosidl_default_generators REQUIRED)\n"
    'rosidl_generate_interfaces(${PROJECT_NAME} "msg/Pose.msg" DEPENDENCIES geometry_msgs)\n'
    "ament_export_dependencies(rosidl_default_runtime)\nament_package()",
)
ALWAYS_THERE = frozenset({"builtin_interfaces"})
"""What rosidl_default_generators brings."""

GROUP = "  <member_of_group>rosidl_interface_packages</member_of_group>\n"
TOOLS = "  <buildtool_depend>rosidl_default_generators</buildtool_depend>\n"
RUNTIME = "  <exec_depend>rosidl_default_runtime</exec_depend>\n"


@rule(
    "DEP108",
    "undeclared-interface-package",
    over=InterfaceTypeDependencies,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "where a declared dependency is known to bring it",
        Severity.INFO: "where package.xml has it in a comment",
    },
    examples=(
        Example(
            on="ament_cmake",
            bad={
                "CMakeLists.txt": CMAKE_MSG,
                "msg/Pose.msg": "«geometry_msgs/Pose2D» pose\n",
                "package.xml": manifest(TOOLS + RUNTIME + GROUP, "ament_cmake"),
            },
            good={
                "package.xml": manifest(TOOLS + "  <depend>geometry_msgs</depend>\n" + RUNTIME + GROUP, "ament_cmake"),
            },
            fix=Safety.SAFE,
        ),
    ),
)
def undeclared_interface_package(interfaces: InterfaceTypeDependencies) -> Iterator[Hit]:
    """
    ## What it does
    Finds types of other packages in interface files that package.xml does not declare.
    Such a type is `geometry_msgs/Pose2D` in a message, service or action.

    ## Why is this bad?
    The generated code includes the other package's headers and imports its modules, here and in every package that
    uses the interface. On a clean machine it does not build, and `ros2 interface show` does not find the type.

    ## References
    - REP-149, depend
    """
    for name, uses in interfaces.undeclared().items():
        first, *others = uses
        tag = f"<depend>{name}</depend>"
        transitive = name in interfaces.declared.transitive_names or name in ALWAYS_THERE
        ends = "on a clean machine the generated code does not build"
        if transitive:
            ends = "it is there only as long as another dependency brings it"
        message = f"package.xml does not declare `{name}`, whose `{first.type}` is used here: {ends}; add {tag}"
        fix = Fix(f"add {tag}", (add_dependency(interfaces.declared.manifest, "depend", name),))
        related = tuple(Related(use.path, use.span, "and here") for use in others[:3])
        level = Severity.WARNING if transitive else None
        level = Severity.INFO if name in interfaces.declared.commented_out else level
        yield Hit(first.path, first.span, message, level, related, fix)
