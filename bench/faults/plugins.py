"""Faults of components and plug-ins: their registration, macros and descriptions."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bench.faults.aside import used_kind
from bench.faults.fault import PutFault, Spot, typo
from bench.faults.kinds import kind
from bench.faults.source_package import SourcePackage

CMAKE = r"^CMakeLists\.txt$"
NOT_EXPORTED = "nothing tells pluginlib of the description"
KNOWN_PLUGINS = set(
    "joint_trajectory_controller joint_state_broadcaster diff_drive_controller velocity_controllers "
    "position_controllers effort_controllers forward_command_controller imu_sensor_broadcaster "
    "force_torque_sensor_broadcaster ackermann_steering_controller tricycle_controller bicycle_steering_controller "
    "gripper_controllers parallel_gripper_action_controller admittance_controller mecanum_drive_controller "
    "smac_planner teb_local_planner rotation_shim_controller".split()
)
"""Packages outside a repository whose plugins every user knows."""


@kind("components")
def component_registration_lost(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(CMAKE, r"^\s*rclcpp_components_register_nodes?\(\s*([\w$\{\}]+)[^()]*\)[ \t]*\n", 0):
        names = [word.strip('"') for word in spot.word.replace("(", " ").replace(")", " ").split()[1:]]
        yield spot.put("", *(name.rpartition("::")[2] for name in names), *names)


@kind("components")
def component_registered_mistyped(package: SourcePackage) -> Iterator[PutFault]:
    pattern = r"rclcpp_components_register_nodes?\([^()]*?\b\w+::(\w+)\""
    yield from (spot.typo() for spot in package.spots(CMAKE, pattern))


@kind("components")
def component_of_mistyped_target(package: SourcePackage) -> Iterator[PutFault]:
    own = package.words(CMAKE, r"add_library\(\s*(\w+)")
    for spot in package.spots(CMAKE, r"rclcpp_components_register_nodes?\(\s*(\w+)"):
        if spot.word in own:
            yield spot.typo()


@kind("components")
def component_macro_mistyped(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(r"\.cpp$", r"RCLCPP_COMPONENTS_REGISTER_NODE\(\s*(?:\w+::)*(\w+)\s*\)"):
        yield spot.typo()


@kind("components")
def component_macro_lost(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(r"\.cpp$", r"^RCLCPP_COMPONENTS_REGISTER_NODE\(\s*(?:\w+::)*(\w+)\s*\)\n"):
        if package.holds(CMAKE, rf"rclcpp_components_register_node.*|{spot.word}"):
            yield spot.drop()


@used_kind("plugins")
def plugin_class_mistyped(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(r"\.xml$", r"<class\b[^>]*?\btype=\"(?:\w+::)*(\w+)\""):
        if "nodelet::" not in spot.text:  # of ROS 1, which a package for both still brings
            yield spot.typo().known(is_exported(package, spot), NOT_EXPORTED)


@used_kind("plugins")
def plugin_base_mistyped(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(r"\.xml$", r"<class\b[^>]*?\bbase_class_type=\"(?!nodelet)(?:\w+::)*(\w+)\""):
        yield spot.typo().known(is_exported(package, spot), NOT_EXPORTED)


def is_exported(package: SourcePackage, spot: Spot) -> bool:
    """Return whether anything tells pluginlib, or rqt, of a description."""
    name = re.escape(spot.path.rpartition("/")[2])
    told = package.holds(r"(^|/)CMakeLists\.txt$|\.cmake$", rf"plugin\w*\([^()]*(?:{name}|\$\{{)")
    return told or package.holds(r"^package\.xml$", rf"<rqt_\w+\s+plugin=\"[^\"]*{name}") or package.is_python


@used_kind("plugins")
def plugin_library_mistyped(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.typo() for spot in package.spots(r"\.xml$", r"<library path=\"(?:lib)?(\w+)\""))


@used_kind("plugins")
def plugin_description_broken(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(r"\.xml$", r"(</class>)\s*(?:<class|</library>)"):
        yield spot.of_file("")


@used_kind("plugins")
def plugin_description_not_exported(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(
        CMAKE, r"^\s*pluginlib_export_plugin_description_file\(\s*\w+\s+([\w/.]+\.xml)\s*\)[ \t]*\n"
    ):
        yield spot.drop(spot.word.rpartition("/")[2])


@used_kind("plugins")
def plugin_description_mistyped(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(CMAKE, r"pluginlib_export_plugin_description_file\(\s*\w+\s+(?:\w+/)*(\w+)\.xml\s*\)"):
        yield spot.put(typo(spot.word), f"{spot.word}.xml", f"{typo(spot.word)}.xml")


@used_kind("plugins")
def plugin_of_wrong_base_package(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(CMAKE, r"pluginlib_export_plugin_description_file\(\s*(\w+)\s+[\w/.]+"):
        yield spot.put(package.name if spot.word != package.name else "pluginlib")


@used_kind("plugins")
def plugin_macro_mistyped(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(r"\.cpp$", r"PLUGINLIB_EXPORT_CLASS\(\s*(?:\w+::)*(\w+)\s*,"):
        if "nodelet::" not in spot.text:
            yield spot.typo()


@used_kind("plugins")
def plugin_macro_lost(package: SourcePackage) -> Iterator[PutFault]:
    pattern = r"^PLUGINLIB_EXPORT_CLASS\(\s*(?:\w+::)*(\w+)\s*,[^()]*\)[ \t]*\n?"
    for spot in package.spots(r"^(?!test/).*\.cpp$", pattern):
        if "nodelet" not in spot.match[0]:
            yield spot.drop()


@used_kind("plugins")
def plugin_named_mistyped(package: SourcePackage) -> Iterator[PutFault]:
    pattern = r"^\s+(?:plugin|type):\s*['\"]?\w+(?:::|/)(?:\w+(?:::|/))*(\w+)"
    for spot in package.spots(r"\.ya?ml$", pattern):
        home = re.split("::|/", spot.match[0].partition(":")[2].strip(" '\""))[0]
        is_known = home in package.siblings or home in KNOWN_PLUGINS or home.startswith(("nav2_", "dwb_"))
        yield spot.typo().known(is_known, "the plugins of a package that is not here")
