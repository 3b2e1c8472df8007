"""Interfaces that no call lists: who asks for them (IDL005)."""

from __future__ import annotations

from rospkg_cli.example import INTERFACES_CMAKE, Example

ZONE = {"CMakeLists.txt": INTERFACES_CMAKE, "msg/Zone.msg": "int32 a\n"}
USES = (
    {},
    {"README.md": "The zone has a Zone.\n"},
    {"README.md": "ros2 topic echo /zone my_pkg/msg/Zone\n"},
    {"README.md": "ros2 topic echo /zone my_pkg/msg/Zones\n"},
    {"src/a.cpp": '#include "my_pkg/msg/zone.hpp"\n'},
    {"src/a.cpp": "using Zone = my_pkg::msg::Zone;\n"},
    {"a.py": "from my_pkg.msg import (\n    Status,\n    Zone,\n)\n"},
    {"a.py": "# from my_pkg.msg import Zone\n"},
    {"a.py": "from my_pkg.msg import Status\n"},
    {"config/bridge.yaml": "- ros_type_name: my_pkg/msg/Zone\n"},
)

CASES = {
    "IDL005": (
        *(Example(bad={**ZONE, **use}, good={}, on="interfaces") for use in USES),
        Example(bad={**ZONE, "msg/Status.msg": "Zone zone\n"}, good={}, on="interfaces"),
    ),
}
