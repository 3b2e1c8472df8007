"""URD002: a path that the containers of a repository have is on no one machine."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

MESH = (
    '<robot name="r"><link name="l"><visual><geometry><mesh filename="file://{}"/></geometry></visual></link></robot>\n'
)
INSTALLS = "install(DIRECTORY launch urdf DESTINATION share/${PROJECT_NAME})\nament_package"
FILES = {
    "package.xml": manifest("", "ament_cmake"),
    "CMakeLists.txt": CMAKE.replace("ament_package", INSTALLS),
    "launch/a.launch.xml": '<launch><let name="a" value="$(find-pkg-share my_pkg)/urdf/robot.urdf"/></launch>\n',
}
SHARED, ROOT, ADA = "/root/shared/meshes/a.dae", "/root/.gz/a.dae", "/home/ada/ws/a.dae"


def levels(place: str, files: dict[str, str]) -> list[str]:
    found = lint_files({**FILES, "urdf/robot.urdf": MESH.format(place), **files}, ["URD002"]).findings
    return [each.severity.value for each in found]


@pytest.mark.parametrize(
    ("place", "path", "text", "expected"),
    [
        (SHARED, "start.sh", 'docker run --volume="/home/$user/shared:/root/shared:rw" img\n', "info"),
        (SHARED, "README.md", "    docker run -v $(pwd)/meshes:/root/shared/ img\n", "info"),
        (SHARED, "compose.yaml", "services:\n  a:\n    volumes:\n      - ./:/root/shared\n", "info"),
        (SHARED, "Makefile", "run:\n\tdocker run --mount type=bind,source=.,target=/root/shared img\n", "info"),
        (ADA, "start.sh", "docker run -v .:/home/ada/ws img\n", "info"),
        (ROOT, "Dockerfile", "FROM ros:jazzy\nCOPY models.txt /root/\n", "info"),
        (ADA, "docker/Dockerfile", "FROM ros:jazzy\nRUN useradd -m ada\n", "info"),
        ("/home/ubuntu/ws/a.dae", "README.md", "", "info"),
        (SHARED, "start.sh", "# docker run -v .:/root/shared img\n", "warning"),
        (SHARED, "start.sh", "docker run -v .:/root/other img\n", "warning"),
        (SHARED, "start.sh", "docker run -v /root/shared:/data img\n", "warning"),
        (ADA, "start.sh", "docker run -v /home/ada/ws:/ws img\n", "warning"),
        (ROOT, "Dockerfile", "FROM ros:jazzy\nRUN useradd -m eve\nCOPY a /root/\nUSER eve\n", "warning"),
        (ROOT, "Dockerfile", "FROM ros:jazzy\n", "warning"),
        (ADA, "Dockerfile", "FROM ros:jazzy\nCOPY models.txt /root/\n", "warning"),
    ],
)
def test_whose_path_it_is(place: str, path: str, text: str, expected: str) -> None:
    assert levels(place, {path: text}) == [expected]


def test_paths_of_one_machine_beside_those_of_containers_stay_loud() -> None:
    robot = MESH.format(SHARED).replace("</robot>", "").replace("</link>", "</link>\n") + MESH.format(ADA)[16:].replace(
        'name="l"', 'name="m"'
    )
    files = {"urdf/robot.urdf": robot, "start.sh": "docker run -v .:/root/shared img\n"}
    assert sorted(levels(SHARED, files)) == ["info", "warning"]
