"""IDL007 missing-interface-dependency."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.interfaces.rosidl_dependencies import RosidlDependencies
from ...edits.cmake_find import add_find_package
from ...edits.cmake_interfaces import add_interface_dependency
from ...edits.plain_names import only_plain_names
from ...example import INTERFACES_BODY, INTERFACES_CMAKE, Example, manifest
from ...finding import Fix, Hit, Related, Safety, Severity
from ...rule import rule

FIND = INTERFACES_CMAKE.replace("rosidl_generate", "find_package(std_msgs REQUIRED)\nrosidl_generate").replace(
    "ament_export_dependencies(", "ament_export_dependencies(std_msgs "
)
GOOD = FIND.replace('  "srv/SetMode.srv"\n', '  "srv/SetMode.srv"\n  DEPENDENCIES std_msgs\n')
FILES = {
    "package.xml": manifest("  <depend>std_msgs</depend>\n" + INTERFACES_BODY, "ament_cmake"),
    "msg/Status.msg": "std_msgs/Header header\n",
}


@rule(
    "IDL007",
    "missing-interface-dependency",
    over=RosidlDependencies,
    severity=Severity.ERROR,
    levels={Severity.WARNING: "the file is listed under a condition"},
    examples=(
        Example(
            on="interfaces",
            bad={**FILES, "CMakeLists.txt": FIND, "msg/Status.msg": "«std_msgs/Header» header\n"},
            good={"CMakeLists.txt": GOOD},
            fix=Safety.SAFE,
        ),
        Example(
            on="interfaces",
            bad={**FILES, "msg/Status.msg": "«std_msgs/Header» header\n"},
            good={"CMakeLists.txt": GOOD.replace("dependencies(std_msgs ", "dependencies(")},
            fix=Safety.SAFE,
        ),
    ),
)
def missing_interface_dependency(dependencies: RosidlDependencies) -> Iterator[Hit]:
    """
    ## What it does
    Finds packages whose types are used and that are missing in `DEPENDENCIES` of the interfaces.
    The `DEPENDENCIES` of `rosidl_generate_interfaces` neither list them nor pass them on.

    ## Why is this bad?
    A generator of rosidl stops the build with "KeyError: 'std_msgs'"; on Humble, which lacks it, the generated code
    does not compile. A listed package must be found first: the fix adds `find_package()` where it is missing.

    ## When it is quiet
    rosidl collects what the listed packages depend on too, and so on. Where one of them passes the interfaces on, as
    actions do with `action_msgs`, and `vision_msgs` with `std_msgs`, or may do so, since nothing is known of it. Where
    the DEPENDENCIES can't be evaluated.
    """
    generated = dependencies.generated
    offered: set[int] = set()
    for need in dependencies.unlisted():
        start = need.target.call.command.span.start
        edit = None if start in offered and not need.target.dependencies else add_interface_dependency(generated, need)
        offered.add(start)
        looked_for = add_find_package(generated.cmake, need.package, need.target.call)
        fix = Fix(f"add `{need.package}` to DEPENDENCIES", (edit, *looked_for)) if edit else None
        message = f"`{need.package}` is not among the DEPENDENCIES of `rosidl_generate_interfaces`"
        call = Related(need.target.call.path, need.target.call.command.name_span, "this call")
        level = None if need.is_certain else Severity.WARNING
        harm = f"rosidl stops the build (KeyError: '{need.package}'); add it"
        yield Hit(
            need.interface.path,
            need.kind.base_span,
            f"{message}: {harm}",
            level,
            related=(call,),
            fix=only_plain_names(fix, need.package),
        )
