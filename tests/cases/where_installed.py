"""Files that are installed, but not where a robot or rqt looks for them."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example
from rospkg_cli.rules.manifest import xml306_missing_exported_file as xml306

XACRO = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
INSTALLS = (
    "install(DIRECTORY launch urdf bringup/config DESTINATION share/${PROJECT_NAME})",
    "install(DIRECTORY launch urdf DESTINATION share/${PROJECT_NAME})\n"
    "install(DIRECTORY bringup/config DESTINATION etc/${PROJECT_NAME})",
    "install(DIRECTORY launch urdf bringup DESTINATION share/${PROJECT_NAME})",
    "install(DIRECTORY launch urdf DESTINATION share/${PROJECT_NAME})",
)
PARAMETERS = "<gazebo><plugin><parameters>$(find my_pkg)/bringup/config/{}</parameters></plugin></gazebo>"


def controlled(install: str, *inside: str) -> Example:
    text = "".join(f"  {each}\n" for each in inside)
    return Example(
        bad={
            "CMakeLists.txt": CMAKE.replace("ament_package", f"{install}\nament_package"),
            "launch/show.launch.xml": "<launch><let name='model' value='urdf/arm.urdf.xacro'/></launch>\n",
            "urdf/arm.urdf.xacro": f'<robot {XACRO} name="arm">\n{text}</robot>\n',
            "bringup/config/a.yaml": "a: 1\n",
            "bringup/config/b.yaml": "b: 1\n",
        },
        good={},
        on="ament_cmake",
    )


CASES = {
    "URD002": (
        *(controlled(each, PARAMETERS.format("a.yaml")) for each in INSTALLS),
        controlled(INSTALLS[0], PARAMETERS.format("a.yaml"), PARAMETERS.format("b.yaml")),
        controlled(INSTALLS[0], "<gazebo><plugin><folder>$(find my_pkg)/bringup/config</folder></plugin></gazebo>"),
    ),
    "XML306": (
        Example(
            bad={
                "package.xml": xml306.GOOD,
                "plugin.xml": "<library path='x'/>\n",
                "CMakeLists.txt": xml306.INSTALLED.replace("DESTINATION share/${PROJECT_NAME}",
                                                           "DESTINATION share/${PROJECT_NAME}/plugins"),
            },
            good={},
            on="ament_cmake",
        ),
    ),
}  # fmt: skip
