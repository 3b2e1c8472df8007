"""What packages keep in their share directory: usual folders, and which of their files are for run time."""

from __future__ import annotations

import re

from ..lazy_regex import regex

# All of these have to fit the whole name of a file, which no file system lets be longer than 255 bytes.
LAUNCH = regex(r"(?:.*[._-])?launch\.(?:py|xml|ya?ml)")

"""Files that `ros2 launch` takes; a bare `.launch` is left out, it is ROS 1's more often than not."""

MODELS = regex(r".*\.(?:stl|dae|obj|glb|gltf|ply|mtl|sdf|urdf|xacro|config|png|jpe?g|tga|material)", re.IGNORECASE)
ROBOTS, WORLDS = regex(r".*\.(?:urdf|xacro|srdf|xml)"), regex(r".*\.(?:world|sdf|wbt|xacro|usda?|proto)")

CONFIGS = regex(
    r"(?!CMakeLists|requirements|readme|license)(?:.*\.(?:ya?ml|rviz|lua|json5?|toml|ini|cfg|conf|xml|txt))",
    re.IGNORECASE,
)
SCENES = regex(r".*\.(?:urdf|xacro|srdf|sdf|world|stl|dae|glb)", re.IGNORECASE)
"""Robots, worlds and meshes, in folders of many names."""

FOLDERS: dict[str, re.Pattern[str]] = {
    "launch": LAUNCH,
    **dict.fromkeys(("config", "configs", "params", "param", "parameters"), CONFIGS),
    "rviz": regex(r".*\.rviz"),
    **dict.fromkeys(("urdf", "xacro", "robots", "srdf"), ROBOTS),
    **dict.fromkeys(("meshes", "mesh", "models"), MODELS),
    **dict.fromkeys(("worlds", "world"), WORLDS),
    **dict.fromkeys(("description", "robot_description", "robot", "gazebo", "sdf", "simulation", "scenes"), SCENES),
    **dict.fromkeys(("maps", "map"), regex(r".*\.(?:ya?ml|pgm|png|pbstream)")),
    **dict.fromkeys(("behavior_trees", "behavior_tree", "bt_xml"), regex(r".*\.xml")),
}
"""The usual folders for run time, and which of their files are for it."""


SHARED = frozenset(
    "ament_index applications bash-completion colcon-core dbus-1 doc fish gazebo icons ignition info licenses locale"
    " man metainfo mime pkgconfig polkit-1 sounds systemd thumbnailers zsh".split()
)
"""Folders of share/ that belong to no package."""
