"""Packages inside of one: who misses what colcon never builds (WSP005)."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest

INNER = {"arm/package.xml": manifest("", "ament_cmake", "arm"), "arm/CMakeLists.txt": CMAKE.replace("my_pkg", "arm")}
CATKIN = {"arm/package.xml": manifest("", "catkin", "arm")}
OUTER = {"package.xml": manifest("", "ament_cmake")}
NEEDING = manifest("  <depend>arm</depend>\n", "ament_cmake")
LAUNCHED = "from launch_ros.actions import Node\nNODE = Node(package='arm', executable='a')\n"

USES = (
    {},
    {"package.xml": NEEDING},
    {"../user/package.xml": NEEDING.replace("my_pkg", "user")},
    {"README.md": "ros2 run arm talker\n"},
    {"README.md": "ros2 run army talker\n"},
    {"README.md": "colcon build --packages-select leg arm\n"},
    {"README.md": "colcon build \\\n  --packages-up-to arm\n"},
    {"README.md": "colcon build --packages-skip arm\n"},
    {"README.md": "The `arm` is described in arm/package.xml.\n"},
    {"build.sh": "ros2 launch arm a.launch.py\n"},
    {"launch/a.launch.py": LAUNCHED},
    {"launch/a.launch.py": "# Node(package='arm')\n"},
    {"launch/a.launch.xml": '<launch><include file="$(find-pkg-share arm)/a.launch.xml"/></launch>\n'},
    {"scripts/a.py": "import arm\n"},
    {"scripts/a.py": "import arm_of_robot\nPATH = get_package_share_directory('arm')\n"},
    {"scripts/a.py": "import arm_of_robot\n"},
    {"src/a.cpp": '#include "arm/arm.hpp"\n'},
    {"CMakeLists.txt": CMAKE.replace("ament_package", "find_package(arm REQUIRED)\nament_package")},
    {"urdf/a.urdf": '<robot name="a"><mesh filename="package://arm/a.stl"/></robot>\n'},
)

OF_THE_INNER = (
    {"arm/README.md": "ros2 run arm talker\n"},
    {"copy/arm/package.xml": INNER["arm/package.xml"], "arm/package.xml": "", "copy/README.md": "ros2 run arm a\n"},
    {"arm/a.py": "import arm\n"},
)
RELEASED = {"slam/package.xml": manifest("", "ament_cmake", "slam_toolbox")}
ON_RELEASED = (
    {"package.xml": NEEDING.replace("arm", "slam_toolbox")},
    {"README.md": "ros2 run slam_toolbox a\n"},
    {"README.md": "colcon build --packages-select slam_toolbox\n"},
)
"""A package of a distribution is installed where it is named; only a build of the copy misses the copy."""

RUN = "ros2 run arm talker\n"
OWN_COMMAND = "function(add_interfaces where)\n  execute_process(COMMAND ${CMAKE_COMMAND} -S ${where})\nendfunction()\n"
NAMED = (
    "include(AddInterfaces OPTIONAL)\nadd_interfaces(arm)",
    f"{OWN_COMMAND}add_interfaces(arm)",
    f"{OWN_COMMAND}foreach(each leg arm)\n  add_interfaces(${{each}})\nendforeach()",
    "execute_process(COMMAND ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_SOURCE_DIR}/arm -B build)",
    "add_custom_target(arms COMMAND make -C ${PROJECT_SOURCE_DIR}/arm)",
    "include_directories(arm/include)",
    "find_package(arm REQUIRED)",
    "set(DEPENDENCIES arm)",
    "install(DIRECTORY arm/launch DESTINATION share/${PROJECT_NAME})",
    "message(STATUS arm/package.xml)",
)
"""What CMake says of the folder of an inner package: a folder of its own is meant, or a name alone."""
BUILT = (
    "WORKDIR /ws/src/my_pkg/arm\nRUN colcon build\n",
    "working-directory: arm\nrun: colcon build\n",
    "working-directory: my_pkg/arm\nrun: cmake -B build\n",
    "cd arm && mkdir build && cd build\ncmake .. && sudo make install\n",
    "cmake -S arm -B build/arm\n",
    "make -C ./arm\n",
    "pip3 install -e ./arm\n",
    "cd ~/ws/src/my_pkg/arm\npython3 setup.py install\n",
    "cd arm\npip install -r requirements.txt\n",
    "cd arm\ncd ..\nmake\n",
    "cd army && make\n",
)
"""How pages build it without colcon, or something else."""


def beside(files: dict[str, str]) -> dict[str, str]:
    """Return files with the outer package in a folder, as one may lie beside it."""
    return {path.removeprefix("../") if path.startswith("../") else f"outer/{path}": text
            for path, text in files.items()}  # fmt: skip


CASES = {
    "WSP005": (
        *(Example(bad=beside({**OUTER, **INNER, **use}), good={}, on="") for use in USES),
        *(Example(bad=beside({**OUTER, **INNER, **use}), good={}, on="") for use in OF_THE_INNER),
        *(Example(bad=beside({**OUTER, **RELEASED, **use}), good={}, on="") for use in ON_RELEASED),
        *(
            Example(bad=beside({**OUTER, **INNER, "README.md": RUN,
                                "CMakeLists.txt": CMAKE.replace("ament_package", f"{line}\nament_package")}),
                    good={}, on="")
            for line in NAMED
        ),
        *(Example(bad=beside({**OUTER, **INNER, "README.md": RUN + text}), good={}, on="") for text in BUILT),
        Example(bad={**OUTER, **CATKIN, "README.md": "ros2 run arm talker\n"}, good={}, on=""),
        Example(bad={**OUTER, **INNER, "b/package.xml": manifest("", "cmake", "b"),
                     "README.md": "ros2 run b b\n"}, good={}, on=""),
    ),
}  # fmt: skip
