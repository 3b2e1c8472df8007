"""Which robots and parameter files need an undeclared package (DEP106): those that something opens."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, existing_files, manifest
from rospkg_cli.testing import lint_files

NATIVE = existing_files(BACKDROPS["ament_cmake"])
INSTALLED = CMAKE.replace(
    "ament_package", "install(DIRECTORY launch urdf config DESTINATION share/${PROJECT_NAME})\nament_package"
)
XACRO = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="r">{}</robot>\n'
FOREIGN = XACRO.format('<xacro:include filename="$(find ur_description)/urdf/ur.xacro"/>')
LAUNCH = """\
def generate_launch_description():
    return [Node(package='controller_manager', executable='ros2_control_node')]
"""
PLUGIN = "a:\n  ros__parameters:\n    one:\n      type: {}\n"
OPENED = "load(share + '/urdf/r.xacro')\n"
GAZEBO = "<gazebo><plugin><parameters>$(find my_pkg)/config/{}</parameters></plugin></gazebo>"


def levels(files: dict[str, str], *others: str, body: str = "") -> list[str]:
    """Return the levels of a package's DEP106, beside packages with a launch file or a robot each."""
    tree = {f"my_pkg/{path}": text for path, text in {**NATIVE, "CMakeLists.txt": INSTALLED, **files}.items()}
    for name, other in zip("xyz", others, strict=False):
        path = "urdf/r.xacro" if other.startswith("<") else "launch/a.launch.py"
        tree[f"{name}/package.xml"] = manifest("%", "ament_cmake", name).replace("%", body)
        tree[f"{name}/CMakeLists.txt"] = CMAKE.replace("my_pkg", name)
        tree[f"{name}/{path}"] = other
    return [each.severity.value for each in lint_files(tree, ["DEP106"]).findings if each.package == "my_pkg"]


@pytest.mark.parametrize(
    ("launch", "others", "level"),
    [
        ("", (), "info"),
        ("PATH = share + '/urdf/spare.xacro'\n", (), "warning"),
        ("PATH = share + '/urdf/robot.xacro'\n", (), "info"),
        ("PATH = share + '/urdf/robot.xacro'\n", ("PATH = get('my_pkg') + '/urdf/spare.xacro'\n",), "warning"),
    ],
)
def test_a_robot_that_is_passed_over(launch: str, others: tuple[str, ...], level: str) -> None:
    files = {"urdf/spare.xacro": FOREIGN, "urdf/robot.xacro": XACRO.format("")}
    assert levels({**files, "launch/a.launch.py": launch}, *others) == [level]


@pytest.mark.parametrize(
    ("launch", "robot", "others", "level"),
    [
        ("load('walk.yaml')\n", "", (), "warning"),
        ("load('walking.yaml')\n", "", (), "info"),
        ("load(MoveItConfigsBuilder('a'))\n", "", (), "info"),
        ("load(f'{NAME}.yaml')\n", "", (), "warning"),
        (OPENED, GAZEBO.format("walk.yaml"), (), "warning"),
        (OPENED, GAZEBO.format("run.yaml"), (), "info"),
        (OPENED, GAZEBO.format("walk.yaml").replace("$(find my_pkg)", "/home/me/my_pkg"), (), "info"),
        (OPENED, GAZEBO.format("walk.yaml").replace("$(find my_pkg)", "package://my_pkg"), (), "warning"),
        (OPENED, GAZEBO.format("walk.yaml").replace("$(find my_pkg)", "${HERE}"), (), "warning"),
        ("", GAZEBO.format("walk.yaml"), (), "info"),
        ("", "", ("PATH = get('my_pkg') + '/walk.yaml'\n",), "warning"),
        ("", "", ("PATH = get('my_pkg') + '/run.yaml'\n",), "info"),
        ("", "", (XACRO.format(GAZEBO.format("walk.yaml")),), "warning"),
        ("", "", (XACRO.format(GAZEBO.format("walk.yaml").replace("my_pkg", "other")),), "info"),
        ("", "", (XACRO.format(GAZEBO.format("run.yaml")),), "info"),
    ],
)
def test_parameters_that_something_opens(launch: str, robot: str, others: tuple[str, ...], level: str) -> None:
    files = {
        "config/walk.yaml": PLUGIN.format("joint_state_broadcaster/JointStateBroadcaster"),
        "urdf/r.xacro": XACRO.format(robot),
    }
    files["package.xml"] = manifest("  <exec_depend>controller_manager</exec_depend>\n", "ament_cmake")
    files["launch/a.launch.py"] = launch + LAUNCH
    assert levels(files, *others, body="  <depend>my_pkg</depend>\n") == [level]


@pytest.mark.parametrize(
    ("owner", "found"),
    [("$(find ur_description)", ["warning", "info"]), ("$(find former_pkg)", ["warning", "warning"])],
)
def test_parameters_of_another_package_that_are_called_like_own(owner: str, found: list[str]) -> None:
    """A package that is known has its own file; one that is known nowhere may be a former name of this one."""
    files = {
        "config/walk.yaml": PLUGIN.format("joint_state_broadcaster/JointStateBroadcaster"),
        "urdf/r.xacro": XACRO.format(GAZEBO.format("walk.yaml").replace("$(find my_pkg)", owner)),
        "package.xml": manifest("  <exec_depend>controller_manager</exec_depend>\n", "ament_cmake"),
        "launch/a.launch.py": OPENED + LAUNCH,
    }
    assert sorted(levels(files), reverse=True) == found


def test_an_example_is_there_to_be_copied() -> None:
    files = {"config/walk_example.yaml": PLUGIN.format("joint_state_broadcaster/JointStateBroadcaster")}
    files["package.xml"] = manifest("  <exec_depend>controller_manager</exec_depend>\n", "ament_cmake")
    files["launch/a.launch.py"] = LAUNCH
    assert levels(files, "PATH = get('my_pkg') + '/walk_example.yaml'\n", body="  <depend>my_pkg</depend>\n") == [
        "info"
    ]


@pytest.mark.parametrize(
    ("plugin", "level"),
    [("solver_plugins::CeresSolver", "info"), ("joint_state_broadcaster/JointStateBroadcaster", "warning")],
)
def test_a_plugin_that_the_node_of_its_own_package_alone_loads(plugin: str, level: str) -> None:
    files = {"config/walk.yaml": PLUGIN.format(plugin), "launch/a.launch.py": "load('walk.yaml')\n" + LAUNCH}
    files["package.xml"] = manifest("  <exec_depend>controller_manager</exec_depend>\n", "ament_cmake")
    assert levels(files) == [level]


MANAGED = """\
/**:
  controller_manager:
    ros__parameters:
      wheels:
        type: diff_drive_controller/DiffDriveController
      claw:
        type: joint_state_broadcaster/JointStateBroadcaster
"""


@pytest.mark.parametrize(
    ("launch", "found"),
    [
        ("spawn(['wheels', 'claw'])\n", ["warning", "warning"]),
        ("spawn(['wheels'])\n", ["warning", "info"]),
        ("spawn(spawners())\n", ["warning", "warning"]),
        ("moveit['claw']['default'] = False\nspawn(['wheels'])\n", ["warning", "info"]),
        ("print(known()[\"claw\"], all[0]['claw'])\nspawn(['wheels'])\n", ["warning", "info"]),
        ("if used['claw'] == 1:\n    pass\nspawn(['wheels'])\n", ["warning", "info"]),
        ("used['claw'] = 1\nspawn(['wheels', *used])\n", ["warning", "warning"]),
        ("spawn(['wheels'] + ['claw'])\n", ["warning", "warning"]),
        ("moveit['claw']['default'] = False\nspawn(['claw', 'wheels'])\n", ["warning", "warning"]),
        ("get('a', default='claw')\nspawn(['wheels'])\n", ["warning", "warning"]),
    ],
)
def test_a_controller_that_is_not_spawned_beside_others_that_are(launch: str, found: list[str]) -> None:
    files = {"config/walk.yaml": MANAGED, "launch/a.launch.py": f"load('walk.yaml')\n{launch}{LAUNCH}"}
    files["package.xml"] = manifest("  <exec_depend>controller_manager</exec_depend>\n", "ament_cmake")
    assert levels(files) == found
    assert levels(files, "A = 'claw'\n", body="  <depend>my_pkg</depend>\n") == ["warning", "warning"]


@pytest.mark.parametrize(
    ("name", "start", "level"),
    [
        ("ros2_controllers", "load(MoveItConfigsBuilder('a'))\n", "warning"),
        ("sensors_kinect", "load(MoveItConfigsBuilder('a'))\n", "info"),
        ("sensors_kinect", "load('sensors_kinect.yaml')\n", "warning"),
    ],
)
@pytest.mark.parametrize("is_loaded", [False, True])
def test_what_only_launch_files_for_ros1_name(name: str, start: str, level: str, *, is_loaded: bool) -> None:
    old = f'<launch>\n  <node pkg="a" type="b" name="c"/>\n  <arg name="d" value="{name}.yaml"/>\n</launch>\n'
    files = {
        f"config/{name}.yaml": PLUGIN.format("joint_state_broadcaster/JointStateBroadcaster"),
        "package.xml": manifest("  <exec_depend>controller_manager</exec_depend>\n", "ament_cmake"),
        "launch/a.launch.py": (start if is_loaded else "") + LAUNCH,
        "launch/old.launch.xml": old,
    }
    assert levels(files) == [level if is_loaded else "info"]


@pytest.mark.parametrize(
    ("code", "level"),
    [
        ("NAME = place.replace('.png', '.yaml')\n", "info"),
        ("START = ['ros2', 'run', 'a', 'b', '--params-file', name + '.yaml']\n", "warning"),
    ],
)
def test_names_that_code_puts_together_for_itself(code: str, level: str) -> None:
    files = {"launch/a.launch.py": LAUNCH, "config/walk.yaml": PLUGIN.format("ur_controllers/SpeedController")}
    assert levels({**files, "scripts/maps.py": code}) == [level]
    shown = {"launch/b.launch.py": f"{LAUNCH}print(f'{{NAME}}.yaml')\n"}
    assert levels({**files, "scripts/maps.py": code, **shown}) == ["warning"]
