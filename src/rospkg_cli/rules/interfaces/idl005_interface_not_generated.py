"""IDL005 interface-not-generated."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.interfaces.unlisted_interfaces import UnlistedInterfaces
from ...edits.cmake_interfaces import add_interface_file
from ...edits.plain_names import only_plain_names
from ...example import INTERFACES_CMAKE, Example
from ...finding import Fix, Hit, Safety, Severity
from ...rule import rule
from ...source import Span

README = "`ros2 topic pub /a my_pkg/msg/Battery`, `ros2 topic pub /b my_pkg/msg/Zone`\n"
SET = INTERFACES_CMAKE.replace('  "msg/Status.msg"\n', "  ${msg_files}\n").replace(
    "rosidl_generate", "set(msg_files\n  msg/Status.msg\n)\nrosidl_generate"
)


@rule(
    "IDL005",
    "interface-not-generated",
    over=UnlistedInterfaces,
    severity=Severity.WARNING,
    levels={
        Severity.ERROR: "the call names no file at all",
        Severity.INFO: "no code, interface or page has the type; a comment in CMakeLists.txt names it, or says that "
        "some are left out, it is a copy, or rosidl would refuse it",
    },
    examples=(
        Example(
            on="interfaces",
            bad={"CMakeLists.txt": INTERFACES_CMAKE, "msg/Battery.msg": "«»float32 voltage\n", "README.md": README},
            good={
                "CMakeLists.txt": INTERFACES_CMAKE.replace(
                    '  "msg/Status.msg"', '  "msg/Battery.msg"\n  "msg/Status.msg"'
                ),
            },
            fix=Safety.SAFE,
        ),
        Example(
            on="interfaces",
            bad={"CMakeLists.txt": SET, "msg/Zone.msg": "«»string name\n", "README.md": README},
            good={"CMakeLists.txt": SET.replace("  msg/Status.msg\n", "  msg/Status.msg\n  msg/Zone.msg\n")},
            fix=Safety.SAFE,
        ),
    ),
)
def interface_not_generated(interfaces: UnlistedInterfaces) -> Iterator[Hit]:
    """
    ## What it does
    Finds interface files that no `rosidl_generate_interfaces` of the package lists.
    It looks in `msg/`, `srv/` and `action/`.

    ## Why is this bad?
    The build succeeds, and the type does not exist: code that includes or imports it gets an error that does not say
    why. A call that lists none at all stops CMake.

    ## When it is quiet
    Where a list can't be evaluated, or a file that can't be read is included. Where git ignores the file. Where the
    branch for ROS 1 lists it (`add_message_files`), or another one that is not taken: it is needed there. Where a
    comment in CMakeLists.txt names it, or says above the call that some are left out (`# only the working ones`), it is
    left out on purpose: an info, without a fix. So is a copy by its name (`Flags_backup.msg`), and a file that is not
    finished: rosidl would stop the build at its name, its text or a message that is not there. So is one, with a fix,
    that no code of the workspace imports or includes, no other interface has, and no page names (`my_pkg/msg/Zone`).
    """
    generated = interfaces.generated
    unlisted = list(interfaces.unlisted())
    if unlisted and generated.empty is not None:
        path, span = generated.empty.path, generated.empty.command.name_span
        names = f"`{unlisted[0].path}`" + (f" and {len(unlisted) - 1} more" if unlisted[1:] else "")
        yield Hit(path, span, f"this call names no interface: CMake stops; list {names}", Severity.ERROR)
        return
    for interface in unlisted:
        aside = interfaces.is_commented_out(interface)
        refusal = interfaces.refusal(interface)
        is_on_purpose = aside or refusal or interfaces.is_left_out(interface)
        edit = None if is_on_purpose else add_interface_file(generated, interface)
        fix = only_plain_names(Fix("list it in CMakeLists.txt", (edit,)), interface.path) if edit else None
        where = "only in a comment, not" if aside else "not"
        message = f"`{interface.path}` is {where} in `rosidl_generate_interfaces`: nothing is generated of it"
        is_idle = not is_on_purpose and not interfaces.asked.has(interface)
        message += ", and nothing here has the type" if is_idle else ""
        level = Severity.INFO if is_on_purpose or is_idle else None
        todo = f"rosidl would refuse it ({refusal}): correct and list it, or delete it" if refusal else ""
        yield Hit(interface.path, Span(0, 0), f"{message}; {todo or 'list it, or delete it'}", level, fix=fix)
