"""What colcon does with a package of CMake that names no build type: green, and not put on AMENT_PREFIX_PATH."""

from __future__ import annotations

from pathlib import Path

import pytest
from shell import Shell

from rospkg_cli.example import manifest

CMAKE = "cmake_minimum_required(VERSION 3.20)\nproject(NAME NONE)\ninstall(FILES package.xml DESTINATION share/NAME)\n"


@pytest.mark.network
def test_without_a_build_type_nothing_sources_what_ament_sets(one_colcon: Shell, tmp_path: Path) -> None:
    for name, build_type in (("with_type", "<build_type>ament_cmake</build_type>"), ("without_type", "")):
        text = manifest(build_type="ament_cmake").replace("<build_type>ament_cmake</build_type>", build_type)
        place = tmp_path / "src" / name
        place.mkdir(parents=True)
        (place / "package.xml").write_text(
            text.replace("my_pkg", name).replace("<buildtool_depend>ament_cmake</buildtool_depend>", "")
        )
        (place / "CMakeLists.txt").write_text(CMAKE.replace("NAME", name))
    built = one_colcon.run("colcon", "build", cwd=tmp_path)
    assert built.returncode == 0, built.stderr
    sourced = {
        name: (tmp_path / "install" / name / "share" / name / "package.sh").read_text()
        for name in ("with_type", "without_type")
    }
    assert "/local_setup.sh" in sourced["with_type"]
    assert "/local_setup.sh" not in sourced["without_type"]
    assert "ros_package_path" in sourced["without_type"]
