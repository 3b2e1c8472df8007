"""What the classes of launch and launch_ros take, for Python launch files.

Source: `__init__` of each class in ros2/launch and ros2/launch_ros, Humble to Rolling; what only some distributions
take is taken here.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

Kind = Literal["any", "text", "words", "condition", "actions", "parameters", "remappings", "pairs", "output", "period"]
"""What an argument takes; "text" is a str, a substitution or a list of these, "words" a list of such."""


@dataclass(frozen=True)
class Signature:
    positional: tuple[str, ...]
    """Arguments that may be passed by place; None may follow for any number."""
    kinds: Mapping[str, Kind]
    required: frozenset[str]
    optional: frozenset[str]
    """Arguments that may be None."""


KINDS: Mapping[str, Kind] = {
    "t": "text",
    "w": "words",
    "c": "condition",
    "a": "actions",
    "p": "parameters",
    "r": "remappings",
    "i": "pairs",
    "o": "output",
    "s": "period",
}


def signature(text: str) -> Signature:
    """Read `name:kind! name …`: `!` is required, `?` may be None; behind a lone `*`, names are keywords."""
    before, _, after = f" {text} ".partition(" * ")
    kinds: dict[str, Kind] = {}
    required, optional, positional = set(), set(), []
    for part, by_place in [(before, True), (after, False)]:
        for word in part.split():
            name, _, letter = word.rstrip("!?").partition(":")
            kinds[name] = KINDS.get(letter, "any")
            required |= {name} if word.endswith("!") else set()
            optional |= {name} if word.endswith("?") else set()
            positional += [name] if by_place else []
    return Signature(tuple(positional), kinds, frozenset(required), frozenset(optional))


ACTION = "condition:c?"
PROCESS = (
    f"prefix:t? cwd:t? env? additional_env? shell sigterm_timeout sigkill_timeout emulate_tty output:o output_format "
    f"cached_output log_cmd on_exit respawn respawn_delay respawn_max_retries {ACTION}"
)
NODE = f"package:t? exec_name:t? parameters:p? remappings:r? ros_arguments:w? arguments:w? {PROCESS}"
EVENT = "handle_once"

SIGNATURES: Mapping[str, Signature] = {
    name: signature(text)
    for name, text in {
        "LaunchDescription": "initial_entities:a? * deprecated_reason",
        "DeclareLaunchArgument": f"name:t! * default_value:t? description choices? {ACTION}",
        "SetLaunchConfiguration": f"name:t! value:t! * {ACTION}",
        "UnsetLaunchConfiguration": f"name:t! * {ACTION}",
        "SetEnvironmentVariable": f"name:t! value:t! * {ACTION}",
        "UnsetEnvironmentVariable": f"name:t! * {ACTION}",
        "AppendEnvironmentVariable": f"name:t! value:t! prepend separator * {ACTION}",
        "IncludeLaunchDescription": f"launch_description_source! * launch_arguments:i? {ACTION}",
        "GroupAction": f"actions:a! * scoped forwarding launch_configurations? {ACTION}",
        "TimerAction": f"* period:s! actions:a! cancel_on_shutdown {ACTION}",
        "RosTimer": f"* period:s! actions:a! cancel_on_shutdown {ACTION}",
        "ROSTimer": f"* period:s! actions:a! cancel_on_shutdown {ACTION}",
        "LogInfo": f"* msg:t! {ACTION}",
        "OpaqueFunction": f"* function! args? kwargs? {ACTION}",
        "Shutdown": f"* reason {ACTION}",
        "EmitEvent": f"* event! {ACTION}",
        "RegisterEventHandler": f"event_handler! * {ACTION}",
        "ExecuteProcess": f"* cmd:w! name:t? {PROCESS}",
        "Node": f"* executable:t! name:t? namespace:t? {NODE}",
        "LifecycleNode": f"* executable:t! name:t! namespace:t! autostart {NODE}",
        "ComposableNodeContainer": f"* executable:t! name:t! namespace:t! composable_node_descriptions? {NODE}",
        "LoadComposableNodes": f"* composable_node_descriptions! target_container! {ACTION}",
        "ComposableNode": (
            "* package:t! plugin:t! name:t? namespace:t? parameters:p? remappings:r? extra_arguments:p? condition:c?"
        ),
        "PushRosNamespace": f"namespace:t! * {ACTION}",
        "PushROSNamespace": f"namespace:t! * {ACTION}",
        "SetRemap": f"src:t! dst:t! * {ACTION}",
        "SetParameter": f"name:t! value! * {ACTION}",
        "SetParametersFromFile": f"filename! node_filter * {ACTION}",
        "SetUseSimTime": f"value! * {ACTION}",
        "IfCondition": "predicate_expression:t!",
        "UnlessCondition": "predicate_expression:t!",
        "LaunchConfigurationEquals": "launch_configuration_name:t! expected_value:t?",
        "LaunchConfigurationNotEquals": "launch_configuration_name:t! expected_value:t?",
        "LaunchConfiguration": "variable_name:t! * default?",
        "PathJoinSubstitution": "substitutions:t!",
        "PythonExpression": "expression:t! python_modules:t",
        "Command": "command:t! * on_stderr:t",
        "FindExecutable": "* name:t!",
        "TextSubstitution": "* text:t!",
        "EnvironmentVariable": "name:t! * default_value:t?",
        "ThisLaunchFileDir": "",
        "FindPackageShare": "package:t!",
        "FindPackagePrefix": "package:t!",
        "ExecutableInPackage": "executable:t! package:t!",
        "EqualsSubstitution": "left! right!",
        "NotEqualsSubstitution": "left! right!",
        "NotSubstitution": "value:t!",
        "AndSubstitution": "left:t! right:t!",
        "OrSubstitution": "left:t! right:t!",
        "ParameterValue": "value! * value_type",
        "ParameterFile": "param_file! * allow_substs",
        "PythonLaunchDescriptionSource": "launch_file_path!",
        "OnProcessExit": f"* target_action? on_exit! {EVENT}",
        "OnProcessStart": f"* target_action? on_start! {EVENT}",
        "OnExecutionComplete": f"* target_action? on_completion! {EVENT}",
        "OnShutdown": f"* on_shutdown! {EVENT}",
    }.items()
}

ACTIONS = frozenset(
    """
    DeclareLaunchArgument SetLaunchConfiguration UnsetLaunchConfiguration SetEnvironmentVariable
    UnsetEnvironmentVariable AppendEnvironmentVariable IncludeLaunchDescription GroupAction TimerAction RosTimer
    ROSTimer LogInfo OpaqueFunction Shutdown EmitEvent RegisterEventHandler ExecuteProcess ExecuteLocal Node
    LifecycleNode ComposableNodeContainer LoadComposableNodes PushRosNamespace PushROSNamespace SetRemap
    SetParameter SetParametersFromFile SetUseSimTime
    """.split()
)
CONDITIONS = frozenset({"IfCondition", "UnlessCondition", "LaunchConfigurationEquals", "LaunchConfigurationNotEquals"})
SUBSTITUTIONS = frozenset(
    """
    AllSubstitution AndSubstitution AnonName AnySubstitution Command EnvironmentVariable EqualsSubstitution FileContent
    FindExecutable IfElseSubstitution LaunchConfiguration LaunchLogDir LocalSubstitution NotEqualsSubstitution
    NotSubstitution OrSubstitution PathJoinSubstitution PythonExpression TextSubstitution ThisLaunchFile
    ThisLaunchFileDir ExecutableInPackage FindPackage FindPackagePrefix FindPackageShare
    """.split()
)
OUTPUTS = frozenset({"screen", "log", "both", "own_log", "full"})
