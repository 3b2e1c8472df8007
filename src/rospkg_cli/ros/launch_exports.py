"""What launch and launch_ros export where.

Source: the `__init__` of each module in ros2/launch and ros2/launch_ros, Foxy to Rolling.
"""

from __future__ import annotations

from collections.abc import Mapping

EXPORTS: Mapping[str, frozenset[str]] = {
    module: frozenset(names.split())
    for module, names in {
        "launch": "Action Condition Event EventHandler LaunchContext LaunchDescription LaunchDescriptionEntity "
        "LaunchDescriptionSource LaunchIntrospector LaunchService SomeActionsType SomeEntitiesType "
        "SomeSubstitutionsType Substitution",
        "launch.actions": "AppendEnvironmentVariable DeclareLaunchArgument EmitEvent ExecuteLocal ExecuteProcess "
        "GroupAction IncludeLaunchDescription LogInfo OpaqueCoroutine OpaqueFunction PopEnvironment "
        "PopLaunchConfigurations PushEnvironment PushLaunchConfigurations RegisterEventHandler ResetEnvironment "
        "ResetLaunchConfigurations SetEnvironmentVariable SetLaunchConfiguration Shutdown TimerAction "
        "UnregisterEventHandler UnsetEnvironmentVariable UnsetLaunchConfiguration",
        "launch.substitutions": "AllSubstitution AndSubstitution AnonName AnySubstitution Command EnvironmentVariable "
        "EqualsSubstitution FileContent FindExecutable IfElseSubstitution LaunchConfiguration LaunchLogDir "
        "LocalSubstitution NotEqualsSubstitution NotSubstitution OrSubstitution PathJoinSubstitution "
        "PythonExpression SubstitutionFailure TextSubstitution ThisLaunchFile ThisLaunchFileDir",
        "launch.conditions": "IfCondition LaunchConfigurationEquals LaunchConfigurationNotEquals UnlessCondition",
        "launch.event_handlers": "OnExecutionComplete OnIncludeLaunchDescription OnProcessExit OnProcessIO "
        "OnProcessStart OnShutdown",
        "launch.launch_description_sources": "AnyLaunchDescriptionSource FrontendLaunchDescriptionSource "
        "PythonLaunchDescriptionSource",
        "launch_xml.launch_description_sources": "XMLLaunchDescriptionSource",
        "launch_yaml.launch_description_sources": "YAMLLaunchDescriptionSource",
        "launch_ros.actions": "ComposableNodeContainer LifecycleNode LifecycleTransition LoadComposableNodes Node "
        "PushROSNamespace PushRosNamespace ROSTimer RosTimer SetParameter SetParametersFromFile SetROSLogDir "
        "SetRemap SetUseSimTime",
        "launch_ros.substitutions": "ExecutableInPackage FindPackage FindPackagePrefix FindPackageShare Parameter",
        "launch_ros.descriptions": "ComposableNode Parameter ParameterFile ParameterValue",
        "launch_ros.parameter_descriptions": "Parameter ParameterFile ParameterValue",
        "launch_ros.event_handlers": "OnStateTransition",
        "ament_index_python.packages": "get_package_prefix get_package_share_directory get_package_share_path",
    }.items()
}


def home_of(name: str) -> str:
    """Return the one module that a name of launch is imported from; "" for others, and for names with several."""
    homes = [module for module, names in EXPORTS.items() if name in names and "parameter_descriptions" not in module]
    return homes[0] if len(homes) == 1 else ""
