"""Levels of faults in robots, by who opens them: a launch file, another robot, another package, or nothing."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest

XACRO = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
INSTALL = CMAKE.replace("ament_package", "install(DIRECTORY urdf DESTINATION share/${PROJECT_NAME})\nament_package")
MESH = '<mesh filename="package://my_pkg/meshes/a.stl"/>'
LACKS = f'<robot {XACRO} name="r">{MESH}</robot>\n'
OPEN = f'<robot {XACRO} name="r">\n  <link name="a">\n</robot>\n'
INCLUDES = f'<robot {XACRO} name="r"><xacro:include filename="$(find my_pkg)/urdf/none.xacro"/></robot>\n'
NEEDED = "  <exec_depend>my_pkg</exec_depend>\n"
LAUNCH = "MODEL = 'arm' + '.urdf'\n"


def robot(text: str, path: str = "urdf/arm.urdf.xacro", **more: str) -> Example:
    named = {name.replace("__", "/").replace("_DOT_", "."): content for name, content in more.items()}
    return Example(bad={"CMakeLists.txt": INSTALL, path: text, **named}, good={}, on="ament_cmake")


OTHERS = ("bringup/", "other/")
"""Folders of other packages than the one with the robots."""


def workspace(text: str, depends: str, path: str = "urdf/arm.urdf.xacro", **more: str) -> Example:
    """A description package beside a package that starts robots."""
    files = {
        "my_pkg/package.xml": manifest(build_type="ament_cmake"),
        "my_pkg/CMakeLists.txt": INSTALL,
        f"my_pkg/{path}": text,
        "bringup/package.xml": manifest("", "cmake", "bringup").replace("  <export>", f"{depends}  <export>"),
    }
    named = {name.replace("__", "/").replace("_DOT_", "."): content for name, content in more.items()}
    below = {name if name.startswith(OTHERS) else f"my_pkg/{name}": content for name, content in named.items()}
    return Example(bad={**files, **below}, good={}, on="")


USES = (
    robot(LACKS),
    robot(LACKS, tests__test_arm_DOT_py="NAME = 'arm.urdf.xacro'\n"),
    robot(LACKS, urdf__whole_DOT_xacro=f"<robot {XACRO}>an arm</robot>\n"),
    robot(LACKS, launch__show_DOT_py="ARMS = 'arms'\n"),
    robot(LACKS, launch__show_DOT_py=LAUNCH),
    robot(LACKS, urdf__whole_DOT_xacro=f'<robot {XACRO}><xacro:include filename="arm.urdf.xacro"/></robot>\n'),
    robot(LACKS, "urdf/my_pkg.urdf.xacro"),
    workspace(LACKS, ""),
    workspace(LACKS, NEEDED),
    *(workspace(each, NEEDED, path="urdf/arm.urdf") for each in (LACKS, INCLUDES)),
    workspace(INCLUDES, NEEDED),
    workspace(INCLUDES, NEEDED, path="urdf/arm.urdf", launch__show_DOT_py=LAUNCH),
    *(
        workspace(LACKS, "", bringup__launch__show_DOT_launch_DOT_py=text)
        for text in (
            "OPENED = share('my_pkg') + '/urdf/arm.urdf.xacro'\n",
            "OPENED = share('my_pkg') + f'/urdf/{name}.urdf.xacro'\n",
            "OPENED = share('my_pkg') + f'/urdf/{name}.rviz', 'urdf'\n",
            "OPENED = share(package) + '/urdf/arm.urdf.xacro'\n",
            "OPENED = share(package) + f'/urdf/{name}.urdf.xacro'\n",
            "OPENED = share('my_pkg') + '/urdf/leg.urdf.xacro'  # not 'arm'\n",
            "OPENED = share('my_pkg') + '/urdf/arm.urdf'\n",
        )
    ),
    workspace(LACKS, "", bringup__tests__show_DOT_py="OPENED = share('my_pkg') + '/urdf/arm.urdf.xacro'\n"),
    workspace(
        LACKS,
        "",
        bringup__launch__show_DOT_launch_DOT_py="OPENED = share('other') + '/urdf/arm.urdf.xacro'\n",
        other__package_DOT_xml=manifest(build_type="ament_cmake", name="other"),
        other__CMakeLists_DOT_txt=INSTALL.replace("my_pkg", "other"),
        other__urdf__arm_DOT_urdf_DOT_xacro=f"<robot {XACRO} name='r'/>\n",
    ),
    robot(LACKS, launch__show_DOT_py="MODEL = 'arm.urdf'\n"),
    robot(LACKS, urdf__whole_DOT_xacro=f"<robot {XACRO}><!-- arm.urdf.xacro --></robot>\n"),
    robot(LACKS, launch__show_DOT_py='"""Once it showed urdf/arm.urdf.xacro."""\n'),
    robot(LACKS, README_DOT_md="| `arm.urdf.xacro` | the arm |\n"),
    robot(LACKS, README_DOT_md="ros2 launch urdf_launch display.launch.py path:=urdf/arm.urdf.xacro\n"),
)
ROSLAUNCH = tuple(
    Example(bad={"launch/a.launch": f"<launch>\n  {line}\n</lunch>\n"}, good={}, on="ament_cmake")
    for line in ('<node pkg="a" type="b"/>', '<include file="$(find a)/b.launch"/>', '<node pkg="a" exec="b"/>')
)
COPY = {"urdf__arm_DOT_urdf": "<robot name='r'/>\n"}
COPIES = (
    robot(OPEN, "arm.urdf", launch__show_DOT_py="MODEL = 'urdf/arm.urdf'\n", **COPY),
    robot(OPEN, "arm.urdf", launch__show_DOT_py="MODEL = 'arm.urdf'\n", **COPY),
    robot(OPEN, "arm.urdf", urdf__README_DOT_md="xacro arm.xacro -o arm.urdf\n", **COPY),
    robot(OPEN, "arm.urdf", README_DOT_md="xacro arm.xacro -o arm.urdf\n", **COPY),
)
PART = f"""\
<robot {XACRO} name="arm">
  <link name="a"/>
  <joint name="j" type="fixed"><parent link="base"/><child link="a"/></joint>
</robot>
"""
WHOLE = f"""\
<robot {XACRO} name="r">
  <xacro:include filename="$(find {{}})/urdf/arm.urdf.xacro"/>
  <link name="base"/>
</robot>
"""
PARTS = (
    *(
        robot(PART, "urdf/arm.urdf", urdf__r_DOT_xacro=WHOLE.format("my_pkg").replace("arm.urdf.xacro", name), **more)
        for name, more in (
            ("arm.urdf", {}),
            ("$(arg part).urdf", {}),
            ("leg.urdf", {}),
            ("arm.urdf", {"launch__show_DOT_py": "MODEL = 'urdf/arm.urdf'\n"}),
        )
    ),
    workspace(PART, "", bringup__urdf__r_DOT_urdf_DOT_xacro=WHOLE.format("my_pkg")),
    workspace(PART, "", bringup__urdf__r_DOT_urdf_DOT_xacro=WHOLE.format("other")),
    workspace(
        PART,
        "",
        bringup__urdf__r_DOT_urdf_DOT_xacro=WHOLE.format("my_pkg"),
        my_pkg__launch__show_DOT_py="MODEL = 'urdf/arm.urdf.xacro'\n",
    ),
)
JOINED = "MODEL = f'urdf/{name}.urdf.xacro'\n"
BROKEN = (
    robot("", launch__show_DOT_py=LAUNCH),
    robot("", launch__show_DOT_py=JOINED),
    robot("", launch__show_DOT_py="MODEL = 'urdf/arm.urdf.xacro.in'\n"),
    robot("", "arm.urdf", launch__show_DOT_py="MODEL = 'urdf/arm.urdf'\n", urdf__arm_DOT_urdf="<robot name='r'/>\n"),
    robot(OPEN, launch__show_DOT_py=JOINED),
    robot(OPEN),
    robot(OPEN, launch__show_DOT_py=LAUNCH),
    robot(OPEN, "urdf/arm.urdf"),
    robot("<robot><xacro:a/></robot>\n", "urdf/arm.urdf", launch__show_DOT_py=LAUNCH),
    robot("<robot/>\n<robot/>\n", "urdf/arm.urdf", launch__show_DOT_py=LAUNCH),
    robot("<robot/>\n<robot/>\n", launch__show_DOT_py=LAUNCH),
    robot("<robot>\n</robot>\n\n</robot>\n", "urdf/arm.urdf", launch__show_DOT_py=LAUNCH),
    robot("</robot>\n", "urdf/arm.urdf", launch__show_DOT_py=LAUNCH),
)
TAB = Example(bad={"config/robot.yaml": "/**:\n  ros__parameters:\n\trate: 2.0\n"}, good={}, on="config")
DESCRIBED = """\
<library path="l">
  <class name="a" type="my_pkg::A{}" base_class_type="b::B"><description>{}</description></class>
</library>
"""
EXPORTED = CMAKE.replace("ament_package", "pluginlib_export_plugin_description_file(b p.xml)\nament_package")
DESCRIPTIONS = tuple(
    Example(bad={"CMakeLists.txt": EXPORTED, "p.xml": DESCRIBED.format(*each)}, good={}, on="ament_cmake")
    for each in (("<int>", "one"), ("", "a < b"))
)
REFUSED = f'<robot {XACRO} name="r">\n  <link name="a"/>\n  <link name="a"/>\n</robot>\n'
JUDGED = (
    robot(REFUSED),
    robot(REFUSED, launch__show_DOT_py=LAUNCH),
    robot(REFUSED, launch__show_DOT_py="MODEL = 'leg.urdf'\n"),
    robot(REFUSED, launch__show_DOT_py="MODEL = 'leg.urdf'  # no longer 'arm'\n"),
    robot(REFUSED, launch__show_DOT_py="print('an arm')\n"),
    robot(REFUSED, launch__show_DOT_py="MODEL = 'leg.urdf'\n", README_DOT_md="See `arm`, an arm.\n"),
    robot(REFUSED, launch__show_DOT_py="MODEL = 'leg.urdf'\n", README_DOT_md="xacro urdf/arm.urdf.xacro\n"),
    robot(REFUSED, launch__show_DOT_launch_DOT_yaml="launch:\n- arg: {name: model, default: arm}\n"),
    robot(REFUSED, launch__show_DOT_launch_DOT_yaml="launch:\n- arg: {name: model, default: arm-1}\n"),
    robot(REFUSED, "resource/arm.urdf"),
    robot(REFUSED, "resource/arm.urdf", launch__show_DOT_py=LAUNCH),
    workspace(REFUSED, "  <exec_depend>my_pkg</exec_depend>\n"),
    workspace(REFUSED, ""),
)

SECOND = f'<robot {XACRO} name="r"><xacro:include filename="$(find my_pkg)/urdf/{{}}"/></robot>\n'
NAMES = "MODEL = {}\n"
OTHER = {
    "other__package_DOT_xml": manifest(build_type="ament_cmake", name="other"),
    "other__CMakeLists_DOT_txt": INSTALL.replace("my_pkg", "other"),
}
LAUNCHED = (
    *(
        robot(INCLUDES, launch__show_DOT_launch_DOT_py=NAMES.format(text), **more)
        for text, more in (
            ("'urdf/arm.urdf.xacro'", {}),
            ("'urdf/arm.urdf'", {}),
            ("'forearm.urdf.xacro'", {}),
            ("'arm', '.rviz'", {}),
            ("'arm' + '.urdf.xacro'", {}),
            ("'charm' + '.urdf.xacro'", {}),
            ("MoveItConfigsBuilder('arm')", {}),
            ("'leg.urdf.xacro'", {"urdf__leg_DOT_urdf_DOT_xacro": SECOND.format("arm.urdf.xacro")}),
            (
                "'leg.urdf.xacro'",
                {
                    "urdf__leg_DOT_urdf_DOT_xacro": SECOND.format("foot.xacro"),
                    "urdf__foot_DOT_xacro": SECOND.format("arm.urdf.xacro"),
                },
            ),
            ("'urdf', 'arm.urdf.xacro'", {"urdf__small__arm_DOT_urdf_DOT_xacro": "<robot name='r'/>\n"}),
        )
    ),
    robot(INCLUDES, show_DOT_py=NAMES.format("'urdf/arm.urdf.xacro'")),
    robot(INCLUDES, launch__old__show_DOT_py=NAMES.format("'urdf/arm.urdf.xacro'")),
    robot(INCLUDES, "urdf/old/arm.urdf.xacro", show_DOT_py=NAMES.format("'urdf/old/arm.urdf.xacro'")),
    robot(INCLUDES, "urdf/old/arm.urdf.xacro", launch__show_DOT_py=NAMES.format("'urdf/old/arm.urdf.xacro'")),
    robot(
        INCLUDES,
        "urdf/small/arm.urdf.xacro",
        launch__show_DOT_py=NAMES.format("'urdf', 'arm.urdf.xacro'"),
        urdf__arm_DOT_urdf_DOT_xacro="<robot name='r'/>\n",
    ),
    *(
        workspace(INCLUDES, "", bringup__launch__show_DOT_launch_DOT_py=NAMES.format(text))
        for text in ("'my_pkg', 'urdf/arm.urdf.xacro'", "'urdf/arm.urdf.xacro'", "'my_pkg', 'arm', f'{a}.urdf.xacro'")
    ),
    workspace(INCLUDES, "", bringup__show_DOT_py=NAMES.format("'my_pkg', 'urdf/arm.urdf.xacro'")),
    *(
        workspace(
            INCLUDES,
            "",
            launch__show_DOT_py=NAMES.format(text),
            **OTHER,
            other__urdf__arm_DOT_urdf_DOT_xacro="<robot name='r'/>\n",
        )
        for text in ("'other', 'urdf/arm.urdf.xacro'", "'other', 'my_pkg', 'urdf/arm.urdf.xacro'")
    ),
    *(
        workspace(
            INCLUDES,
            "",
            **OTHER,
            other__urdf__leg_DOT_urdf_DOT_xacro=SECOND.format("arm.urdf.xacro"),
            **{name: NAMES.format(text)},
        )
        for name, text in (
            ("other__launch__show_DOT_py", "'urdf/leg.urdf.xacro'"),
            ("bringup__launch__show_DOT_py", "'other', 'leg.urdf.xacro'"),
            ("bringup__launch__show_DOT_py", "'leg.urdf.xacro'"),
            ("other__show_DOT_py", "'urdf/leg.urdf.xacro'"),
        )
    ),
    workspace(
        INCLUDES,
        "",
        **OTHER,
        other__urdf__foot_DOT_xacro=SECOND.format("arm.urdf.xacro"),
        other__urdf__leg_DOT_urdf_DOT_xacro=SECOND.replace("my_pkg", "other").format("foot.xacro"),
        bringup__launch__show_DOT_py=NAMES.format("'other', 'leg.urdf.xacro'"),
    ),
)
ORIGIN = '<link name="a"><visual><origins {}/><geometry><sphere radius="1"/></geometry></visual></link>'
ORIGINS = tuple(
    robot(f"<robot name='r'>{ORIGIN.format(each)}</robot>\n", "urdf/arm.urdf", launch__show_DOT_py=LAUNCH)
    for each in ("", 'xyz="0 0 0" rpy="0 0.0 -0"', 'xyz="0 0 0" rpy="0 0 1"', 'xyz="1 0 0"', 'xyz="a 0 0"')
)
GAZEBO = tuple(
    robot(
        f'<robot {XACRO} name="r"><link name="base_link"/><gazebo reference="{each}"/></robot>\n',
        launch__show_DOT_py=LAUNCH,
    )
    for each in ("ee_link", "base_lnk", "base_link", "elsewhere")
)
DEFAULT = f'<robot {XACRO} name="r"><xacro:arg name="roll" default="${{PI}}"/><link name="a"/></robot>\n'
DEFAULTS = tuple(
    robot(DEFAULT, launch__show_DOT_py=f"RUN = ['xacro ', 'arm.urdf.xacro', {each}]\n") for each in ("", "' roll:=', x")
)


CASES = {
    "URD001": (*JUDGED, *PARTS, *ORIGINS, *DEFAULTS, *GAZEBO),
    "URD002": (*USES, *LAUNCHED),
    "RPK001": (*BROKEN, *COPIES, TAB, *DESCRIPTIONS, *ROSLAUNCH),
}
