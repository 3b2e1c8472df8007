"""IDL014 recursive-message."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.interfaces.message_circles import MessageCircles
from ...checks.interfaces.package_interfaces import PackageInterfaces
from ...example import INTERFACES_CMAKE, Example
from ...finding import Hit, Related, Severity
from ...rule import rule

BOTH = INTERFACES_CMAKE.replace('  "msg/Status.msg"', '  "msg/Part.msg"\n  "msg/Status.msg"')


@rule(
    "IDL014",
    "recursive-message",
    over=PackageInterfaces,
    severity=Severity.ERROR,
    levels={Severity.WARNING: "rosidl may read one of the files, under a condition or from a list that is not known"},
    examples=(
        Example(
            on="interfaces",
            bad={"msg/Status.msg": "string name\n«Status»[] parts\n"},
            good={"msg/Status.msg": "string name\nstring[] parts\n"},
        ),
        Example(
            on="interfaces",
            bad={
                "CMakeLists.txt": BOTH,
                "msg/Part.msg": "string name\n«Status» whole\n",
                "msg/Status.msg": "Part[] parts\n",
            },
            good={"msg/Part.msg": "string name\n"},
        ),
    ),
)
def recursive_message(package: PackageInterfaces) -> Iterator[Hit]:
    """
    ## What it does
    Finds messages that contain themselves, directly or by way of others of the package.
    An array of them counts as well.

    ## Why is this bad?
    The generated code of each message needs that of its parts before it. In a circle there is no first: the build stops
    with "unknown type name".

    ## When it is quiet
    Where nothing reads the file: it is not in `rosidl_generate_interfaces`, or setup.py builds the package.

    ## References
    - https://design.ros2.org/articles/legacy_interface_definition.html
    """
    for circle in MessageCircles(package).all():
        (first, kind), *others = circle
        way = " by way of " + " and ".join(f"`{message.path}`" for message, _ in others) if others else ""
        text = (
            f"`{first.path}` contains itself{way}: the generated code does not compile; use an id or an index instead"
        )
        sure = all(package.generation.surely_reads(message.path) for message, _ in circle)
        related = tuple(Related(message.path, each.base_span, "and on from here") for message, each in others)
        yield Hit(first.path, kind.base_span, text, None if sure else Severity.WARNING, related)
