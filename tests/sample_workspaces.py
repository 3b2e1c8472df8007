"""Workspaces to look at: a beginner's package, and forty packages with the faults of real ones, made from a seed."""

from __future__ import annotations

from random import Random

from rospkg_cli.example import CMAKE, SETUP_CFG, SETUP_PY, manifest

SEED = 18
PARTS = ("arm", "base", "camera", "dock", "gripper", "lidar", "map", "planner", "route", "teleop")
KINDS = ("bringup", "core", "msgs_tools", "utils")
BROKEN = {"dock_core", "map_utils", "route_core"}
"""Each has an entry point to a module that is not there."""
NEEDED = (
    "rviz2",
    "tf2_ros",
    "robot_state_publisher",
    "nav2_map_server",
    "rosbag2_transport",
    "joy",
    "teleop_twist_joy",
)
IMPORTED = ("numpy", "std_msgs.msg", "geometry_msgs.msg", "nav_msgs.msg", "sensor_msgs.msg", "launch_ros.actions")


def beginner() -> dict[str, str]:
    """Return a first package: a misspelt module, a launch file that is not installed, imports that are not declared."""
    setup = with_script("talker = my_pkg.talkr:main")
    node = "import numpy as np\nimport rclpy\nfrom std_msgs.msg import String\n\n\ndef main():\n    rclpy.init()\n"
    launch = (
        "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n\n\n"
        "def generate_launch_description():\n"
        "    return LaunchDescription([Node(package='my_pkg', executable='talkr')])\n"
    )
    return {
        "package.xml": manifest().replace("Drives my robot", "TODO: Package description"),
        "setup.py": setup,
        "setup.cfg": SETUP_CFG,
        "resource/my_pkg": "",
        "my_pkg/__init__.py": "",
        "my_pkg/talker.py": node,
        "launch/talker.launch.py": launch,
        "LICENSE": "Apache License\n",
    }


def with_script(script: str) -> str:
    """Return a setup.py with an entry point."""
    return SETUP_PY.rstrip().removesuffix(")") + f"    entry_points={{'console_scripts': ['{script}']}},\n)\n"


def forty() -> dict[str, str]:
    """Return forty packages by path, in repositories of some; the same ones each time."""
    random = Random(SEED)
    files: dict[str, str] = {}
    for part in PARTS:
        for kind in KINDS:
            name = f"{part}_{kind}"
            files |= {f"src/{part}_stack/{name}/{path}": text for path, text in package(name, random).items()}
    return files


def package(name: str, random: Random) -> dict[str, str]:
    """Return the files of one package: half of them have nothing wrong."""
    python = random.random() < 0.5 or name in BROKEN
    build = "ament_python" if python else "ament_cmake"
    text = manifest(build_type=build, name=name)
    files = {"LICENSE": "Apache License\n"}
    if python:
        files |= {"setup.py": SETUP_PY, "setup.cfg": SETUP_CFG, "resource/my_pkg": "", "my_pkg/__init__.py": ""}
        files["my_pkg/nodes/__init__.py"] = ""
    else:
        files["CMakeLists.txt"] = CMAKE
    if name in BROKEN:
        files["setup.py"] = with_script("start = my_pkg.nodes.start:main")
    if random.random() < 0.4:
        text = faults(text, files, python, random)
    files["package.xml"] = text
    return {path.replace("my_pkg", name): body.replace("my_pkg", name) for path, body in files.items()}


def faults(text: str, files: dict[str, str], python: bool, random: Random) -> str:
    """Add faults to some files; return the manifest with its own."""
    if random.random() < 0.3:
        text = text.replace("Drives my robot", "TODO: Package description")
    if random.random() < 0.3:
        text = text.replace("  <export>", "  <exec_depend>std_msgs</exec_depend>\n" * 2 + "  <export>")
    if python and random.random() < 0.2:
        files["setup.py"] = files["setup.py"].replace("version='1.0.0'", "version='0.9.0'")
    if python:
        for number in range(random.randrange(3)):
            lines = "".join(f"import {each}\n" for each in random.sample(IMPORTED, random.randrange(1, 4)))
            files[f"my_pkg/nodes/part_{number}.py"] = lines
    for number in range(random.randrange(2)):
        nodes = "".join(
            f"  <node pkg='{each}' exec='run'/>\n" for each in random.sample(NEEDED, random.randrange(1, 3))
        )
        files[f"launch/start_{number}.launch.xml"] = f"<launch>\n{nodes}</launch>\n"
        if not python:
            files["CMakeLists.txt"] = CMAKE.replace(
                "ament_package()", "install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})\nament_package()"
            )
    return text
