"""Interfaces of other versions and with other members than their files say: patched, hand-written, taken by others."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, INTERFACES_CMAKE, Example, manifest
from rospkg_cli.rules.interfaces import idl010_unknown_field as idl010

PATCHES = (
    "from std_msgs.msg import String\n\nString.datta = property(len)\n",
    "import std_msgs.msg\n\nsetattr(std_msgs.msg.String, 'datta', 1)\n",
    "from std_msgs.msg import Header\n\nHeader.datta = 1\n",
)
OURS = {
    "ours/package.xml": manifest("", "ament_cmake", "ours"),
    "ours/CMakeLists.txt": INTERFACES_CMAKE.replace("my_pkg", "ours").replace('  "srv/SetMode.srv"\n', ""),
    "ours/msg/Status.msg": "int32 a\n",
    "my_pkg/package.xml": manifest("  <depend>ours</depend>\n", "ament_cmake"),
    "my_pkg/CMakeLists.txt": CMAKE.replace(
        "ament_package", "find_package(ours REQUIRED)\nadd_library(a src/a.cpp)\nament_package"
    ),
}
USES = (
    "#include <ours/msg/rosidl_generator_cpp__visibility_control.hpp>\n",
    "#include <ours/msg/helper.hpp>\nours::msg::Helper a;\n",
)
BATTERY = {
    "my_pkg/package.xml": manifest(),
    "my_pkg/setup.py": "",
    "my_pkg/srv/Charge.srv": "---\n",
    "their/package.xml": manifest("  <depend>my_pkg</depend>\n", name="their"),
    "their/setup.py": "",
    "their/their/__init__.py": "",
}
TAKES = ("from my_pkg.srv import Charge\n", "from my_pkg.charge import charge\n")


def in_cpp(text: str, *headers: str) -> Example:
    files = {f"ours/include/ours/{each}/helper.hpp": "namespace ours::msg {class Helper {};}\n" for each in headers}
    return Example(bad={**OURS, **files, "my_pkg/src/a.cpp": text}, good={}, on="")


def of_distribution(page: str, line: str) -> Example:
    files = {"package.xml": manifest("  <exec_depend>nav2_msgs</exec_depend>\n"), "my_pkg/talker.py": line}
    return Example(bad={**files, "README.md": f"For ROS 2 {page}.\n"}, good={})


KINDS = ("from nav2_msgs.msg import NavigateToPose\n", "from nav2_msgs.action import NavigateToPos\n")
CASES = {
    "IDL011": tuple(of_distribution(page, line) for page in ("Galactic", "Humble") for line in KINDS),
    "IDL010": tuple(
        Example(
            bad={
                "setup.py": idl010.TALKS,
                "package.xml": manifest(idl010.DEPENDS),
                "my_pkg/talker.py": "import my_pkg.patches\n" + idl010.TALKER.format("datta"),
                "my_pkg/patches.py": text,
            },
            good={},
        )
        for text in PATCHES
    ),
    "IDL012": (*(in_cpp(text) for text in USES), in_cpp(USES[1], "msg"), in_cpp(USES[1], "srv")),
    "IDL008": tuple(Example(bad={**BATTERY, "their/their/a.py": text}, good={}, on="") for text in TAKES),
}
