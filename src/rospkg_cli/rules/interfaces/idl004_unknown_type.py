"""IDL004 unknown-type."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.interfaces.type_resolution import InterfaceInWorkspace
from ...edits.plain_names import only_plain_names
from ...example import INTERFACES_BODY, INTERFACES_CMAKE, Example, manifest
from ...finding import Edit, Fix, Hit, Safety, Severity
from ...package.interfaces.interface_file import FieldType
from ...rule import rule

WITH_SENSORS = {
    "package.xml": manifest("  <depend>sensor_msgs</depend>\n" + INTERFACES_BODY, "ament_cmake"),
    "CMakeLists.txt": INTERFACES_CMAKE.replace(
        "rosidl_generate", "find_package(sensor_msgs REQUIRED)\nrosidl_generate"
    ).replace("\n)\nament_export", "\n  DEPENDENCIES sensor_msgs\n)\nament_export"),
}

STOPS = "rosidl stops the build with FileNotFoundError"


@rule(
    "IDL004",
    "unknown-type",
    over=InterfaceInWorkspace,
    severity=Severity.ERROR,
    levels={Severity.WARNING: "rosidl may read the file, under a condition or from a list that is not known"},
    examples=(
        Example(
            on="interfaces",
            bad={"srv/SetMode.srv": "«Statsu» mode\n---\nbool success\n"},
            good={"srv/SetMode.srv": "Status mode\n---\nbool success\n"},
            fix=Safety.UNSAFE,
        ),
        Example(
            on="interfaces",
            bad={"msg/Status.msg": "«Point» place\n"},
            good={"msg/Status.msg": "geometry_msgs/Point place\n"},
            fix=Safety.UNSAFE,
        ),
        Example(
            on="interfaces",
            bad={**WITH_SENSORS, "msg/Status.msg": "«sensor_msgs/IMU» imu\n"},
            good={"msg/Status.msg": "sensor_msgs/Imu imu\n"},
            fix=Safety.UNSAFE,
        ),
    ),
)
def unknown_type(scope: InterfaceInWorkspace) -> Iterator[Hit]:
    """
    ## What it does
    Finds types in interface files that no .msg file defines.
    Neither this package nor the named package of the workspace has the file, or the name of a core package is misspelt
    or that of a message of another package here. A package that is not available is believed.

    ## Why is this bad?
    The build stops before anything is compiled: a generator of rosidl ends with "FileNotFoundError: …/Battery.json"
    (Humble has no such generator, and stops at an `#include` of a header that does not exist).

    ## When it is quiet
    Where nothing reads the file: it is not in `rosidl_generate_interfaces`. Where the package of the type is not in the
    workspace, or makes its messages while it is built, and where the type has a `_` in it, as parts of services do.
    """
    path = scope.interface.path
    level = None if scope.is_surely_read else Severity.WARNING
    for kind in scope.unknown_types() if scope.is_read else ():
        better = scope.suggestion(kind)
        fix = None
        if better:
            fix = Fix(f"write `{better}`", (Edit(path, kind.base_span, better),), Safety.UNSAFE)
        message = f"{absence(scope, kind)}; write `{better}`" if better else absence(scope, kind)
        yield Hit(path, kind.base_span, message, level, fix=only_plain_names(fix, better or ""))


def absence(scope: InterfaceInWorkspace, kind: FieldType) -> str:
    other = scope.service_or_action(kind)
    if other:
        return f"`{kind.base}` is `{other}`: only a message can be the type of a field, and the build stops"
    if scope.is_own(kind):
        return f"this package has no `msg/{kind.base}.msg`: {STOPS}"
    return f"`{kind.package}` has no message `{kind.base}`: {STOPS}"
