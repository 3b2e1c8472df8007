"""Whether a file of the XML frontend is a launch file for ROS 1."""

from __future__ import annotations

from .entity import Entity

ROS2_ENTITIES = frozenset({
    "let", "executable", "lifecycle_node", "node_container", "composable_node", "load_composable_node", "set_env",
    "push_ros_namespace", "push-ros-namespace", "set_parameter", "set_remap", "timer",
})  # fmt: skip
ROS2_SUBSTITUTIONS = ("$(var ", "$(find-pkg-share ", "$(find-pkg-prefix ", "$(exec-in-pkg ")


def is_ros1(root: Entity) -> bool:
    """Return whether a file has nodes by `type=`, `$(find x)` or `$(arg x)`, and nothing that came with ROS 2."""
    every = list(root.walk())
    values = " ".join(written.text for entity in every for written in entity.attributes.values())
    new = any(entity.name in ROS2_ENTITIES for entity in every) or any(each in values for each in ROS2_SUBSTITUTIONS)
    if new or any(entity.name == "node" and "exec" in entity.attributes for entity in every):
        return False
    old = any(entity.name == "node" and "type" in entity.attributes for entity in every)
    return old or "$(find " in values or "$(arg " in values


def is_named_ros1(path: str) -> bool:
    """Return whether a file lies in a folder that is called `ros1`, next to files for ROS 2."""
    return "ros1" in path.split("/")[:-1]
