"""IDL002 invalid-interface-name."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.interfaces.package_interfaces import PackageInterfaces
from ...example import INTERFACES_CMAKE, Example
from ...finding import Hit, Related, Severity
from ...package.interfaces.interface_file import InterfaceFile
from ...ros.interfaces import KINDS, valid_interface_name
from ...rule import rule
from ...source import Span

TOP = Span(0, 0)


@rule(
    "IDL002",
    "invalid-interface-name",
    over=PackageInterfaces,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "rosidl may read the file, under a condition or from a list that is not known",
        Severity.INFO: "the folder is none of `msg`, `srv`, `action`, so that the build takes it; or several folders "
        "hold a file of that name, of which CMake chooses one",
    },
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
def invalid_interface_name(package: PackageInterfaces) -> Iterator[Hit]:
    """
    ## What it does
    Finds interface files whose name is not CamelCase, or that are in the wrong folder.
    CamelCase is an uppercase letter, then letters and digits; the folder is `msg/`, `srv/` or `action/`. A wrong folder
    is one finding, with all its files.

    ## Why is this bad?
    rosidl makes the name of a type from the file's name and refuses any other form: the build stops. The folder decides
    as what a file is installed: of `srvs/Pause.srv`, `ros2 interface list` shows two types, and `ros2 interface show`
    ends with a traceback.

    ## When it is quiet
    Where nothing reads the file: it is not in `rosidl_generate_interfaces`, or setup.py builds the package. Files of
    one name in several folders, of which CMake chooses one, can't lie in `msg/` together: that is an info. So is a
    folder such as `srvs/` or `msg/detection/`: the types are built as ever, and only the command misses the file.
    """
    folders: dict[str, list[InterfaceFile]] = {}
    for interface in package.read():
        name, kind = interface.name, interface.kind
        if not valid_interface_name(name):
            better = "".join(word[:1].upper() + word[1:] for word in name.replace("-", "_").split("_"))
            hint = (
                f"to `{better}.{kind}`"
                if valid_interface_name(better)
                else "with a letter first, then letters and digits"
            )
            message = f"`{name}` is no CamelCase name: rosidl stops the build; rename the file {hint}"
            level = None if package.generation.surely_reads(interface.path) else Severity.WARNING
            yield Hit(interface.path, TOP, message, level)
        if interface.folder.rpartition("/")[2] != kind:
            folders.setdefault("*" if package.is_variant(interface) else interface.folder, []).append(interface)
    for first, *others in folders.values():
        folder = first.folder
        level = None if package.generation.surely_reads(first.path) else Severity.WARNING
        is_built = folder.rpartition("/")[2] not in KINDS
        level = Severity.INFO if is_built or package.is_variant(first) else level
        related = tuple(Related(each.path, TOP, "and this file") for each in others)
        yield Hit(first.path, TOP, misplaced(folder, first), level, related=related)


def misplaced(folder: str, first: InterfaceFile) -> str:
    shown, last, kind = f"`{folder}/`" if folder else "the package's own folder", folder.rpartition("/")[2], first.kind
    start = f"a .{kind} file belongs into `{kind}/`, not into {shown}"
    if last in KINDS:
        return f"{start}: it is installed as a {last}, and tools don't find `{first.name}`; move it"
    return f"{start}: `ros2 interface show` ends with a traceback for `{first.name}`; move it"
