"""Files that robots lack, where launch files replace the path, pages fetch the file, or robots are alike."""

from __future__ import annotations

from rospkg_cli.example import Example

from .opened_robots import INCLUDES, LACKS, MESH, REFUSED, XACRO, robot, workspace

OPENS = "TEXT = open('urdf/arm.urdf').read()\n"
HOME = '<robot name="r"><mesh filename="file:///home/ada/a.stl"/></robot>\n'
BARE = '<robot name="r"><mesh filename="b.stl"/></robot>\n'
LOADS = f'<robot {XACRO} name="r"><link name="${{load_yaml(\'$(find my_pkg)/urdf/a.yaml\')}}"/></robot>\n'


def opened(text: str, launch: str, **more: str) -> Example:
    return robot(text, "urdf/arm.urdf", launch__show_DOT_py=OPENS + launch, **more)


def several(text: str, launch: str = "MODEL = f'{x}.urdf'\n", **more: str) -> Example:
    return robot(text, "urdf/arm.urdf", launch__show_DOT_py=launch, urdf__leg_DOT_urdf=text, urdf__b_DOT_stl="", **more)


REPLACED = (
    *(
        opened(LACKS, f"TEXT = {made}\n")
        for made in (
            "TEXT.replace('package://my_pkg', 'file:///opt')",
            "re.sub(r'package://my_pkg/', 'file:///opt/', TEXT)",
            "TEXT.replace('package://other', 'file:///opt')",
            "TEXT.replace('pac', 'b')",
            "run('sed s|package://my_pkg|file:///opt| urdf/arm.urdf')",
        )
    ),
    opened(HOME, "TEXT = TEXT.replace('/home/ada', HOME)\n"),
    opened(INCLUDES, "TEXT = TEXT.replace('$(find my_pkg)', '/opt')\n"),
    opened(LACKS, "TEXT = TEXT.replace('package://my_pkg', 'x')\n", launch__other_DOT_py=OPENS),
    *(
        workspace(LACKS, "", path="urdf/arm.urdf", bringup__launch__a_DOT_launch_DOT_py=f"A = 'my_pkg'\n{OPENS}{text}")
        for text in ("", "A = A.replace('package://my_pkg', 'file:///opt')\n")
    ),
)
FETCHED = tuple(
    opened(text, "", **files)
    for text, files in (
        (LACKS, {"README_DOT_md": "unzip meshes/a.zip -d meshes\n"}),
        (LACKS, {"README_DOT_md": "The meshes are large.\n"}),
        (LACKS, {"get_DOT_sh": "wget https://arm.org/a.stl\n"}),
        (LACKS, {"get_DOT_sh": "wget https://arm.org/b.stl\n"}),
        (LACKS, {"get_DOT_sh": "tar xf meshes.tar.gz\n"}),
        (LACKS, {"meshes__a_DOT_zip": ""}),
        (INCLUDES, {"get_DOT_sh": "wget https://arm.org/none.xacro\n"}),
    )
)
ALIKE = (
    *(several(text) for text in (LACKS, HOME, BARE, INCLUDES)),
    several(LACKS, "MODEL = 'arm.urdf'\n"),
    several(LACKS, urdf__toe_DOT_urdf=LACKS.replace(MESH, f"<gazebo>{MESH}</gazebo>")),
    several(LACKS, parts__toe_DOT_urdf=LACKS),
)
MADE = tuple(
    robot(text, launch__show_DOT_launch_DOT_py=f"MODEL = f'{{x}}{end}'\n", urdf__leg_DOT_urdf="<robot name='l'/>\n")
    for text in (REFUSED, INCLUDES)
    for end in (".urdf.xacro", ".xacro", ".srdf.xacro", ".urdf")
)
LOADED = tuple(
    robot(LOADS, launch__show_DOT_launch_DOT_py="MODEL = 'arm.urdf.xacro'\n", **files)
    for files in ({}, {"urdf__a_DOT_yaml": "a: 1\n"})
)
BESIDE = tuple(
    robot(
        REFUSED, "urdf/arm.urdf", launch__show_DOT_launch_DOT_py=f"MODEL = '{name}'\n", urdf__leg_DOT_xacro="<robot/>\n"
    )
    for name in ("arm.urdf", "arm.urdf.xacro")
)

CASES = {
    "URD001": (*MADE[:4], *BESIDE),
    "URD002": (*REPLACED, *FETCHED, *ALIKE, *MADE[4:], *LOADED),
}
