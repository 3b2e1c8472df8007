"""DEP108 undeclared-interface-package."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...checks.depends.interface_types import InterfaceTypeDependencies, InterfaceTypeUse
from ...checks.depends.name_source import is_unmet
from ...edits.brought_hits import BroughtUse, left_to_others, related
from ...edits.undeclared_dependency import advice, declaration, where_absent
from ...example import CMAKE, Example, manifest
from ...finding import Edit, Fix, Hit, Safety, Severity
from ...rule import rule

CMAKE_MSG = CMAKE.replace(
    "ament_package()",
    "find_package(geometry_msgs REQUIRED)\n"
    "find_package(rosidl_default_generators REQUIRED)\n"
    'rosidl_generate_interfaces(${PROJECT_NAME} "msg/Pose.msg" DEPENDENCIES geometry_msgs)\n'
    "ament_export_dependencies(rosidl_default_runtime)\nament_package()",
)
GROUP = "  <member_of_group>rosidl_interface_packages</member_of_group>\n"
TOOLS = "  <buildtool_depend>rosidl_default_generators</buildtool_depend>\n"
RUNTIME = "  <exec_depend>rosidl_default_runtime</exec_depend>\n"


@rule(
    "DEP108",
    "undeclared-interface-package",
    over=InterfaceTypeDependencies,
    severity=Severity.WARNING,
    levels={
        Severity.ERROR: "no package has that name, and one has nearly it",
        Severity.INFO: "where a declared dependency brings or may bring it, an unreleased repository declares it in "
        "another package or installs it by apt, package.xml has it in a comment or for older distributions alone, or "
        "it needs this package itself",
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
    Such a type is `geometry_msgs/Pose2D` in a message, service or action. Every action uses `action_msgs`.

    ## Why is this bad?
    The generated code includes the other package's headers and imports its modules, here and in every package that
    uses the interface. On a clean machine it does not build, and `ros2 interface show` does not find the type.

    ## When it is quiet
    Interface files that CMakeLists.txt does not generate are left alone (see IDL005). What a declared dependency
    certainly installs is one info, which names who brings it. What may come with a declared one is another: with a
    package that is neither here nor in the table of what is installed with what, anything may come. What another
    package of the repository declares, or a list or a script of it installs (apt alone), is an info where nothing shows
    a release. A package here that needs this one itself is an info, for to declare it would make a circle; where it
    declares this one, nothing is said.

    ## Fix safety
    The fix is unsafe where no released package has the name, or a comment of package.xml leaves it out.

    ## References
    - REP-149, depend
    """
    declared = interfaces.declared
    brought: list[BroughtUse] = []
    for name, uses in interfaces.undeclared().items():
        first = uses[0]
        if near := interfaces.intended(name):
            yield misspelt(name, near, uses)
            continue
        if bringer := declared.bringer([name], runs=False):
            brought.append(BroughtUse(name, bringer, "depend", first.path, first.span))
            continue
        where = where_absent(declared, name, built=True)
        message = (
            f"`{name}` is not declared, and its `{first.type}` is used here: {where} the generated code does "
            f"not build; {advice(declared, 'depend', name)}"
        )
        places = related((use.path, use.span) for use in uses)
        level = Severity.INFO if is_unmet(declared, name) else None
        yield Hit(first.path, first.span, message, level, places, declaration(declared, "depend", name))
    yield from left_to_others(declared, brought, "used in interfaces")


def misspelt(name: str, near: str, uses: Sequence[InterfaceTypeUse]) -> Hit:
    first = uses[0]
    start = f"no package is called `{name}` (did you mean `{near}`?), and its `{first.type}` is used here"
    message = f"{start}: the generated code does not build; correct it"
    edits = tuple(Edit(use.path, use.span, use.type.replace(name, near, 1)) for use in uses)
    fix = Fix(f"write `{near}`", edits, Safety.UNSAFE)
    places = related((use.path, use.span) for use in uses)
    return Hit(first.path, first.span, message, Severity.ERROR, places, fix)
