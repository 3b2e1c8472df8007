"""Faults in files that nothing leads to, as only comments, launch files for ROS 1 or other names name them."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest, scripts, setup_py

BROKEN = "def main():\n    print 'hello'\n"
ROS1 = '<launch>\n  <node pkg="my_pkg" type="talker.py" name="talker"/>\n</launch>\n'
ENTRY = setup_py(scripts("talker = my_pkg.new_talker:main"))
NEW = "def main():\n    pass\n"
HOME = '<mesh filename="/home/ada/ws/src/my_pkg/meshes/arm.stl"/>'
ROBOT = f'<robot name="arm"><link name="base"><visual><geometry>{HOME}</geometry></visual></link></robot>\n'
SHOWN = """\
<launch>
  <let name="model" value="$(find-pkg-share my_pkg)/urdf/arm/arm.urdf"/>
</launch>
"""
INSTALL = "install(DIRECTORY launch meshes urdf DESTINATION share/${PROJECT_NAME})\nament_package"
SEARCH = """\
#include <ament_index_cpp/get_package_share_directory.hpp>
std::string path() {return ament_index_cpp::get_package_share_directory("my_pkg") + "/config/nowhere.yaml";}
"""
PROGRAM = (
    "add_executable(talker src/talker.cpp)\ninstall(TARGETS talker DESTINATION lib/${PROJECT_NAME})\nament_package"
)
PREBUILT = "add_library(device INTERFACE)\ntarget_link_libraries(device INTERFACE {})\nament_package"


def module(**files: str) -> Example:
    found = {path.replace("__", "/").replace("_DOT_", "."): text for path, text in files.items()}
    start = {"setup.py": ENTRY, "my_pkg/new_talker.py": NEW, "my_pkg/talker.py": BROKEN}
    return Example(bad={**start, **found}, good={})


def robots(*folders: str, launch: str = SHOWN) -> Example:
    return Example(
        bad={
            "CMakeLists.txt": CMAKE.replace("ament_package", INSTALL),
            "launch/show.launch.xml": launch,
            "meshes/arm.stl": "solid arm\n",
            **{f"urdf/{each}": ROBOT for each in folders},
        },
        good={},
        on="ament_cmake",
    )


def world(path: str) -> Example:
    text = f'<sdf version="1.9"><world name="w"><include><uri>file://{path}</uri></include></world></sdf>\n'
    launch = SHOWN.replace("urdf/arm/arm.urdf", "worlds/w.sdf")
    installed = INSTALL.replace("urdf", "worlds")
    files = {"CMakeLists.txt": CMAKE.replace("ament_package", installed), "meshes/arm.stl": "solid arm\n"}
    return Example(bad={**files, "launch/w.launch.xml": launch, "worlds/w.sdf": text}, good={}, on="ament_cmake")


def compiled(source: str) -> Example:
    return Example(
        bad={
            "package.xml": manifest("  <depend>ament_index_cpp</depend>\n", "ament_cmake"),
            "CMakeLists.txt": CMAKE.replace("ament_package", PROGRAM),
            "src/talker.cpp": "int main() {}\n",
            source: SEARCH + ("int main() {}\n" if source == "src/talker.cpp" else ""),
        },
        good={},
        on="ament_cmake",
    )


def linked(name: str) -> Example:
    return Example(
        bad={"CMakeLists.txt": CMAKE.replace("ament_package", PREBUILT.format(name))}, good={}, on="ament_cmake"
    )


CASES = {
    "RPK001": (
        module(launch__old_DOT_launch=ROS1),
        module(my_pkg__new_talker_DOT_py="def main():\n    talker = 'talker.py'\n"),
        module(my_pkg__new_talker_DOT_py="def main():\n    '''Was talker.py'''\n    talker = 1\n"),
        module(my_pkg__new_talker_DOT_py="from my_pkg import talker\n\n\ndef main():\n    talker.main()\n"),
    ),
    "URD002": (
        robots("arm/arm.urdf", "old/arm.urdf"),
        robots("old/arm.urdf"),
        robots("arm/arm.urdf", "arm/arm.sdf"),
        world("/home/ada/ws/install/my_pkg/share/my_pkg/models/box/meshes/box.dae"),
        world("/home/ada/box.dae"),
    ),
    "DEP113": (compiled("src/talker.cpp"), compiled("src/listener.cpp")),
    "CMK110": (linked("Device"), linked("device")),
}
