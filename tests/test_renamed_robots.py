"""Robots that name files in a package that is not known, while their own package has them: it was renamed."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

INSTALL = CMAKE.replace(
    "ament_package", "install(DIRECTORY meshes urdf DESTINATION share/${PROJECT_NAME})\nament_package"
)


@pytest.mark.parametrize(
    "named, ends, has_fix",
    [
        ("package://arm_descr/meshes/a.stl", "did you mean `my_pkg`, which has `meshes/a.stl`?", False),
        ("package://arm_descr/meshes/b.stl", "in a .repos file", True),
        ("package://arm_descr/meshes/a.stl package://arm_descr/meshes/b.stl", "in a .repos file", True),
        (
            "package://arm_descr/meshes/a.stl package://arm_descr/$(arg x)",
            "did you mean `my_pkg`, which has `meshes/a.stl`?",
            False,
        ),
        ("package://arm_descr/$(arg x)", "in a .repos file", True),
        ("package://ur_description/meshes/a.stl", "add <exec_depend>ur_description</exec_depend>", True),
    ],
)
def test_the_own_package_is_meant_where_it_has_the_files(named: str, ends: str, has_fix: bool) -> None:
    meshes = "".join(f'<mesh filename="package{each}"/>' for each in named.split("package")[1:])
    files = {
        "package.xml": manifest("", "ament_cmake"),
        "CMakeLists.txt": INSTALL,
        "meshes/a.stl": "solid\n",
        "README.md": "    check_urdf urdf/robot.urdf\n",
        "urdf/robot.urdf": f'<robot name="r">{meshes}</robot>\n',
    }
    (finding,) = lint_files(files, ["DEP106"]).findings
    assert finding.message.endswith(ends)
    assert (finding.fix is not None) is has_fix
