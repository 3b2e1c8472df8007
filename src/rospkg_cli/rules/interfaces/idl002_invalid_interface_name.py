"""IDL002 invalid-interface-name."""

from __future__ import annotations

from collections.abc import Iterator

from ...example import INTERFACES_CMAKE, Example
from ...finding import Hit, Severity
from ...package.interfaces.interface_file import InterfaceFile
from ...ros.interfaces import KINDS, valid_interface_name
from ...rule import rule
from ...source import Span


@rule(
    "IDL002",
    "invalid-interface-name",
    over=InterfaceFile,
    severity=Severity.ERROR,
    levels={Severity.WARNING: "the file is in a folder that is none of `msg`, `srv`, `action`"},
    examples=(
        Example(
            on="interfaces",
            bad={
                "CMakeLists.txt": INTERFACES_CMAKE.replace("Status", "robot_status"),
                "msg/Status.msg": None,
                "msg/robot_status.msg": "«»float32 battery_level\n",
            },
            good={
                "CMakeLists.txt": INTERFACES_CMAKE.replace("Status", "RobotStatus"),
                "msg/robot_status.msg": None,
                "msg/RobotStatus.msg": "float32 battery_level\n",
            },
        ),
        Example(
            on="interfaces",
            bad={
                "CMakeLists.txt": INTERFACES_CMAKE.replace("srv/", "msg/"),
                "srv/SetMode.srv": None,
                "msg/SetMode.srv": "«»string mode\n---\nbool success\n",
            },
            good={
                "CMakeLists.txt": INTERFACES_CMAKE,
                "msg/SetMode.srv": None,
                "srv/SetMode.srv": "string mode\n---\nbool success\n",
            },
        ),
    ),
)
def invalid_interface_name(interface: InterfaceFile) -> Iterator[Hit]:
    """
    ## What it does
    Finds interface files whose name is not CamelCase, or that are in the wrong folder.
    CamelCase is an uppercase letter, then letters and digits; the folder is `msg/`, `srv/` or `action/`.

    ## Why is this bad?
    rosidl makes the name of a type from the file's name and refuses any other form: the build stops. It decides by the
    folder, not by the suffix, what a file is installed and indexed as, and whether it needs `action_msgs`.
    """
    name, kind, top = interface.name, interface.kind, Span(0, 0)
    if not valid_interface_name(name):
        better = "".join(word[:1].upper() + word[1:] for word in name.replace("-", "_").split("_"))
        hint = f": rename the file to `{better}.{kind}`" if valid_interface_name(better) else ""
        yield Hit(interface.path, top, f"rosidl refuses `{name}` as the name of an interface; CamelCase is it{hint}")
    folder = interface.folder.rpartition("/")[2]
    if folder != kind:
        level = None if folder in KINDS else Severity.WARNING
        shown = f"`{folder}/`" if folder else "the package's own folder"
        message = f"a .{kind} file belongs into `{kind}/`, not into {shown}: it is installed and indexed by its folder"
        yield Hit(interface.path, top, f"{message}, and tools won't find `{name}`", level)
