"""Commands after `ament_package`, which should be the last."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.file import ROOT
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake

ENDS = ("ament_package", "ament_auto_package", "autoware_ament_auto_package")

FATAL = frozenset({
    "ament_package", "ament_auto_package", "autoware_ament_auto_package", "rosidl_generate_interfaces",
    "generate_parameter_library", "ament_vendor", "rosidl_export_typesupport_libraries",
    "rosidl_export_typesupport_targets",
})  # fmt: skip
"""Commands that stop the configuration when ament_package() was called before."""

LOST: dict[str, str] = {
    "ament_lint_auto_find_test_dependencies": "the linters never run",
    "rclcpp_components_register_node": "the component is not registered",
    "rclcpp_components_register_nodes": "the components are not registered",
    "pluginlib_export_plugin_description_file": "the plugins are not registered",
    "ament_environment_hooks": "the hook is not in the environment",
}
"""What ament_package() would have finished, and what becomes of it."""

STOPS = "CMake stops"
DESCRIBES = "pluginlib_export_plugin_description_file"
REGISTERS = (DESCRIBES, "rclcpp_components_register_node", "rclcpp_components_register_nodes")
COMPONENTS = "rclcpp_components"
"""As a category of plugins: class_loader's container finds components by what registers nodes, and not by pluginlib."""

AUTOMATIC = ("ament_auto_add_library", "ament_auto_add_executable")

LINTERS = "ament_lint_auto_find_test_dependencies"
OWN_PACKAGES = frozenset({*ENDS, "find_package", "gz_find_package", "ament_python_install_package"})
"""What ends in `_package` and looks for no linters; macros such as `autoware_package` may do so."""


@dataclass(frozen=True)
class MisplacedCommand:
    """A call that comes too late, the call that it should precede, and what follows of that."""

    call: EvaluatedCommand
    end: EvaluatedCommand
    consequence: str
    unmissed: str = ""
    """Why nothing is lost: nothing reads what the call registers, or another call does so in time; "" where it is."""

    @property
    def only_linters(self) -> bool:
        return self.call.name == LINTERS

    @property
    def is_fatal(self) -> bool:
        return self.consequence == STOPS


def commands_after_ament_package(cmake: CMake) -> Iterator[MisplacedCommand]:
    """Yield the calls behind ament_package() that then fail or have no effect; a plain install() does no harm."""
    end = next((call for call in cmake.calls if call.name in ENDS and is_sure(call)), None)
    if end is None:
        return
    at = cmake.calls.index(end)
    linted = any(call.name.endswith("_package") and call.name not in OWN_PACKAGES for call in cmake.calls[:at])
    for call in cmake.calls[at + 1 :]:
        if linted and call.name == LINTERS:
            continue
        if call.path == ROOT and not call.maybe and not call.function and (why := consequence(call, end)):
            yield MisplacedCommand(call, end, why, unmissed(call, cmake.calls[:at]))


def unmissed(call: EvaluatedCommand, before: Sequence[EvaluatedCommand]) -> str:
    """Return why nothing is lost with what a call registers too late; "" where something may be."""
    if call.name == DESCRIBES and call.texts[:1] == (COMPONENTS,):
        return "nothing looks for it, as containers load what `rclcpp_components_register_node` registers"
    said = [each for each in before if each.name == call.name and is_sure(each)]
    is_said = call.name in REGISTERS and any(each.texts == call.texts for each in said)
    return "the same call stands above in time" if is_said else ""


def is_sure(call: EvaluatedCommand) -> bool:
    return call.path == ROOT and not call.maybe and not call.testing and not call.function


def consequence(call: EvaluatedCommand, end: EvaluatedCommand) -> str:
    if call.name in FATAL or call.name.startswith("ament_export_"):
        return STOPS
    if call.name in AUTOMATIC and end.name != "ament_package":
        return "the target is neither installed nor exported"
    return LOST.get(call.name, "")
