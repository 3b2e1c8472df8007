"""IDL001 invalid-interface."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.interfaces.grammar import grammar_faults
from ...checks.interfaces.type_resolution import InterfaceInWorkspace
from ...edits.fault_hits import hits
from ...example import Example
from ...finding import Edit, Fix, Hit, Safety, Severity
from ...light_dataclasses import replace
from ...rule import rule


@rule(
    "IDL001",
    "invalid-interface",
    over=InterfaceInWorkspace,
    severity=Severity.ERROR,
    levels={Severity.WARNING: "rosidl may read the file, under a condition or from a list that is not known"},
    examples=(
        Example(
            on="interfaces",
            bad={"msg/Status.msg": "«int» count\n"},
            good={"msg/Status.msg": "int32 count\n"},
            fix=Safety.UNSAFE,
        ),
        Example(
            on="interfaces",
            bad={"srv/SetMode.srv": "string mode\n«----»\nbool success\n"},
            good={"srv/SetMode.srv": "string mode\n---\nbool success\n"},
            fix=Safety.SAFE,
        ),
        Example(
            on="interfaces",
            bad={"msg/Status.msg": "«builtin_interfaces/msg/Time» stamp\n"},
            good={"msg/Status.msg": "builtin_interfaces/Time stamp\n"},
            fix=Safety.SAFE,
        ),
        Example(
            on="interfaces",
            bad={"msg/Status.msg": "«Header» header\n"},
            good={"msg/Status.msg": "std_msgs/Header header\n"},
            fix=Safety.SAFE,
        ),
        Example(
            on="interfaces",
            bad={"msg/Status.msg": 'string label «"room #3"»\n'},
            good={"msg/Status.msg": 'string label "room 3"\n'},
        ),
        Example(
            on="interfaces",
            bad={"msg/Status.msg": "uint8 percent «300»\n"},
            good={"msg/Status.msg": "uint8 percent 100\n"},
        ),
        Example(
            on="interfaces",
            bad={"msg/Status.msg": "string path # such as C:«\\U»sers\n"},
            good={"msg/Status.msg": "string path # such as C:\\\\Users\n"},
            fix=Safety.SAFE,
        ),
    ),
)
def invalid_interface(scope: InterfaceInWorkspace) -> Iterator[Hit]:
    """
    ## What it does
    Finds .msg, .srv and .action files that rosidl's grammar refuses.
    It reads types and their bounds, arrays, default values, constants, the separator lines `---` (one in a .srv, two in
    an .action), `package/Name` without `msg` in between. It also finds what rosidl accepts and reads otherwise than it
    is written: a `#` inside quotes cuts the value.

    ## Why is this bad?
    rosidl stops the build at the first of them, often with no more than a Python traceback of its own.

    ## When it is quiet
    Where nothing reads the file: it is not in `rosidl_generate_interfaces`, or commented out of it (IDL005), or
    setup.py builds the package (IDL008). Where it is listed only under a condition, or may be, it is a warning.

    ## Fix safety
    The fix is safe where there is only one way to read the line. A type of C or Python is replaced under
    `--unsafe-fixes`, because its width is not known.

    ## References
    rosidl_adapter/parser.py; https://docs.ros.org/en/rolling/Concepts/Basic/About-Interfaces.html
    """
    path = scope.interface.path
    level = None if scope.is_surely_read else Severity.WARNING
    for hit in hits(path, grammar_faults(scope.interface)) if scope.is_read else ():
        yield replace(hit, level=level)
    for kind in scope.bare_headers() if scope.is_read else ():
        message = "a bare `Header` was ROS 1; here it means one of this package, which has none"
        fix = Fix("write `std_msgs/Header`", (Edit(path, kind.base_span, "std_msgs/Header"),))
        yield Hit(path, kind.base_span, f"{message}: write `std_msgs/Header`", level, fix=fix)
