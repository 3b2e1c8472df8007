"""Slips of a sign or a name in launch files and robots, told in small: a comma, a name for two, a former name."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest

from .shown_launch_calls import HEAD, NEEDED, node, python

JOINS = """\
from launch.substitutions import PathJoinSubstitution
from launch_ros.parameter_descriptions import ParameterValue
"""
BUILDS = "from moveit_configs_utils import MoveItConfigsBuilder\n"


def body(*lines: str) -> Example:
    """A launch file whose function has some statements."""
    text = "".join(f"    {each}\n" for each in lines)
    text = f"{HEAD}\n\ndef generate_launch_description():\n{text}"
    return Example(bad={"package.xml": NEEDED, "launch/a.launch.py": text}, good={})


COMMAS = (
    body("x = LogInfo(msg='a'),", "return LaunchDescription([x])"),
    body("x = LogInfo(msg='a'),", "return LaunchDescription([*x])"),
    body("x = (LogInfo(msg='a'),)", "return LaunchDescription([x])"),
    body("x = LogInfo(msg='a'),", "y = LaunchDescription()", "y.add_action(x)", "return y"),
    body("x = IfCondition(a),", "return LaunchDescription([LogInfo(msg='a', condition=x)])"),
)
ADDED = body(
    "found = LaunchDescription([DeclareLaunchArgument('a'), DeclareLaunchArgument('b')])",
    "found.add_action(LogInfo(msg='x'))",
    "found.add_action([LogInfo(msg='x')])",
    "found.add_action(a)",
    "found.add_action(None)",
    "found.add_entity('x')",
    "found.add_action(unknown)",
    "found.add_action(ComposableNode(package='p', plugin='p::P', name='n'))",
    "return found",
)
JOINED = python(
    *(
        f"LogInfo(msg=PathJoinSubstitution({each}))"
        for each in ("'maps'", "'m'", "f'maps/{unknown}'", "['maps', a]", "('maps',)", "a", "5", "[5]", "unknown")
    ),
    before=JOINS,
)
OBJECTS = python(
    *node(
        "parameters=[moveit]",
        "parameters=[moveit.to_dict(), moveit.robot_description]",
        "parameters=[{'arm': moveit, 'level': {'arm': moveit}}]",
        "parameters=[{'arm': takes, 'leg': takes()}]",
        "parameters=[takes]",
        "parameters=[ParameterValue('a')]",
        "parameters=[{'a': ParameterValue('a')}]",
        "parameters=[{'a': LogInfo(msg='x')}, LogInfo(msg='x')]",
    ),
    before=f"{JOINS}{BUILDS}moveit = MoveItConfigsBuilder('arm').to_moveit_configs()\n\n\ndef takes():\n    return 5\n",
)
TWICE = (
    body("x = LogInfo(msg='a')", "x = LogInfo(msg='b')", "return LaunchDescription([x])"),
    body("x = LogInfo(msg='a')", "x = LogInfo(msg='a')", "return LaunchDescription([x])"),
    body("x = LogInfo(msg='a')", "x = GroupAction([x])", "return LaunchDescription([x])"),
    body("x = LogInfo(msg='a')", "if unknown:", "    x = LogInfo(msg='b')", "return LaunchDescription([x])"),
    body("x = LogInfo(msg=5)", "x = LogInfo(msg='b')", "return LaunchDescription([x])"),
    body("x = Node(package='p', executable='e')", "x, y = unknown", "return LaunchDescription([x])"),
)
MODEL = '<sdf version="1.6"><model name="m"><link name="l"><visual name="v"><geometry><mesh><uri>{}</uri></mesh>'
MODEL += "</geometry></visual></link></model></sdf>\n"
MODELS = {"models/path/model.config": "<model/>\n", "models/path/meshes/path.dae": "d\n"}


def model(uri: str, **files: str) -> Example:
    """The model of a module that names a file, beside that of a path; `__` in the name of a file is `/`."""
    named = {f"{name.replace('__', '/')}.dae": text for name, text in files.items()}
    text = MODEL.format(uri)
    return Example(bad={**MODELS, "models/module/model.sdf": text, **named}, good={}, on="ament_cmake")


MODELLED = (
    *(
        model(f"model://{each}", models__module__meshes__module="d\n")
        for each in (
            "path/meshes/module.dae",
            "path/meshes/pathh.dae",
            "path/meshes/path.dae",
            "sun/meshes/sun.dae",
            "path/$(arg x).dae",
            "path",
        )
    ),
    model("model://path/materials/other.png"),
)
OLD = '<robot name="a"><link name="b"><visual><geometry><mesh filename="package://{}"/></geometry></visual></link>'
OLD += "</robot>\n"
INSTALLED = CMAKE.replace(
    "ament_package", "install(DIRECTORY meshes urdf DESTINATION share/${PROJECT_NAME})\nament_package"
)
RENAMED = tuple(
    Example(
        bad={
            "CMakeLists.txt": INSTALLED,
            "package.xml": manifest(f"  <exec_depend>{need}</exec_depend>\n", "ament_cmake"),
            **{f"urdf/{name}.urdf": OLD.format(f"arm_old/meshes/{name}.stl") for name in names},
            **{f"meshes/{name}.stl": "solid\n" for name in ("a", "b", "c", "d")},
        },
        good={},
        on="ament_cmake",
    )
    for need, names in (
        ("rviz2", "ab"),
        ("arm_bringup", "abcd"),
        ("arm_bringup", "ae"),
        ("arm_old", "ab"),
        ("arm_bringup", "a"),
    )
)
CONTROLLERS = """\
controller_manager:
  ros__parameters:
    a:
      type: parallel_gripper_controller/GripperActionController
    b:
      type: parallel_gripper_action_controller/GripperActionController
    c:
      type: joint_trajectory_controllers/JointTrajectoryController
    d:
      type: my_diff_drive_controller/DiffDriveController
    e:
      type: diff_drive/DiffDriveController
    f:
      type: gripper_controllers/GripperActionController
planner_server:
  ros__parameters:
    planner_plugins: [a, b]
    a:
      plugin: nav2_smac/SmacPlannerHybrid
    b:
      plugin: nav2_regulated_pure_pursuit::RegulatedPurePursuitController
"""
PLUGINS = Example(on="config", bad={"config/robot.yaml": CONTROLLERS}, good={})
STARTED = python(
    *(
        f"ExecuteProcess(cmd={each})"
        for each in (
            "[ExecutableInPackage(executable='taker', package='my_pkg'), '-v']",
            "[ExecutableInPackage('talker', 'my_pkg')]",
            "[ExecutableInPackage('talker', unknown)]",
            "[ExecutableInPackage('rvi2', 'rviz2')]",
            "['ros2', 'run', 'my_pkg', 'taker']",
            "['ros2', 'run', 'my_pkg', 'talker', '-v']",
            "['ros2', 'run', '--debug', 'my_pkg', 'taker']",
            "['ros2', 'run', 'rviz2', 'rvi2']",
            "['ros2 run my_pkg taker'], shell=True",
            "['ros2 run my_pkg tal', a], shell=True",
            "['ros2', 'run', 'my_pkg', 'deep']",
            "['ros2', 'launch', 'my_pkg', 'taker']",
        )
    )
)
PROGRAMS = Example(
    bad={
        **STARTED.bad,
        "start.sh": "ros2 launch launch/a.launch.py\n",
        "CMakeLists.txt": CMAKE.replace(
            "ament_package",
            "install(PROGRAMS scripts/talker DESTINATION lib/${PROJECT_NAME})\n"
            "install(PROGRAMS scripts/deep DESTINATION lib/${PROJECT_NAME}/more)\nament_package",
        ),
        "package.xml": manifest("", "ament_cmake"),
        "scripts/talker": "#!/bin/sh\n",
        "scripts/deep": "#!/bin/sh\n",
    },
    good={},
)
OF_MOVEIT = manifest("  <exec_depend>moveit_configs_utils</exec_depend>\n", "ament_cmake")
LIMITS = """\
default_velocity_scaling_factor: 0.1
joint_limits:
  base:
    mix_position: -0.1
    has_velocity_limit: true
    max_velocity: 1.0
  arm:
    mix_position: -0.1
    min_velocity: 0.1
    own_limit: 1.0
  leg:
    max_positions: 1.0
    max_position: 1.0
"""
JOINTS = tuple(
    Example(on="config", bad={f"config/{name}.yaml": text, **more}, good={})
    for name, text, more in (
        ("my_joint_limits", LIMITS, {}),
        ("my_limits", LIMITS, {}),
        ("my_joint_limits", LIMITS, {"launch/a.launch.py": "FILE = 'config/my_joint_limits.yaml'\n"}),
        *(("joint_limits", each, {"package.xml": OF_MOVEIT}) for each in (LIMITS, LIMITS.replace(": true", ": false"))),
    )
)
ENTRY = "- ros_topic_name: /a\n  gz_topic_name: /b\n  ros_type_name: {}\n  gz_type_name: gz.msgs.Twist\n  {}\n"
TYPES = (
    ("geometry_msgs::msg::Twist", ""),
    ("geometry_msgs/Twist", "direction: ROS_TO_GZ"),
    ("geometry_msgs.msg.Twist", "direction: ROS_TO_IGNITION"),
    ("geometry_msgs/msg/Twist", "direction: gz_to_ros"),
    ("geometry_msg/msg/Twist", "lazy: true"),
    ("geometry_msgs/msg/Twst", "topic_name: /c"),
    ("own_msgs/msg/Twist", "direction: $(var direction)"),
)
BRIDGE = Example(
    on="config",
    bad={
        "config/bridge.yaml": "".join(ENTRY.format(*each) for each in TYPES),
        "config/other.yaml": "ros_type_name: a::B\n",
        "config/more.yaml": "- ros_type_name: std_msgs::msg::Bool\n- 5\n",
    },
    good={},
)
SOURCES = """\
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.conditions import IfCondition
from launch.launch_description_sources import {sources}PythonLaunchDescriptionSource
from launch_xml.launch_description_sources import XMLLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution


def generate_launch_description():
    folder, name = LaunchConfiguration('folder'), LaunchConfiguration('name')
    return LaunchDescription([
        IncludeLaunchDescription(XMLLaunchDescriptionSource(PathJoinSubstitution([folder, 'a.launch.py']))),
        IncludeLaunchDescription(PythonLaunchDescriptionSource([folder, '/a.xml']), condition=IfCondition(name)),
        IncludeLaunchDescription(FrontendLaunchDescriptionSource([folder, '/a.launch.py'])),
        IncludeLaunchDescription(FrontendLaunchDescriptionSource([folder, '/a.yaml'])),
        IncludeLaunchDescription(PythonLaunchDescriptionSource([folder, '/a.launch'])),
        IncludeLaunchDescription(PythonLaunchDescriptionSource([folder, '/a.py'])),
        IncludeLaunchDescription(XMLLaunchDescriptionSource([folder, name])),
    ])
""".format(sources="FrontendLaunchDescriptionSource, ")
READ = Example(
    bad={"package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n"), "launch/a.launch.py": SOURCES}, good={}
)
CASES = {
    "LCH014": (READ, *COMMAS, ADDED, JOINED, OBJECTS),
    "LCH018": TWICE,
    "URD002": MODELLED,
    "DEP106": RENAMED,
    "PLG003": (PLUGINS,),
    "LCH002": (PROGRAMS,),
    "PRM007": JOINTS,
    "LCH019": (BRIDGE,),
}
