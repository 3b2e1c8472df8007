"""Files and folders that scripts of the repository write before a build, also by variables and in loops."""

from __future__ import annotations

import pytest

from rospkg_cli.checks.repository.script_outputs import outputs
from rospkg_cli.example import BACKDROPS, CMAKE, existing_files, manifest, setup_py
from rospkg_cli.testing import lint_files

INSTALL = "install(DIRECTORY {} DESTINATION share/${{PROJECT_NAME}})\nament_package"
LOOP = 'for robot in left right; do\n  xacro tools/$robot.xacro -o "src/my_pkg/robot/$robot.urdf"\ndone\n'


@pytest.mark.parametrize(
    ("script", "paths"),
    [
        ("mkdir -p a/b c\n", {"a/b", "c"}),
        ("# mkdir a\necho hi > b.txt 2>&1\n", {"b.txt"}),
        ('D=src/p\nmkdir -p ${D}/maps "$D"/bags\n', {"src/p/maps", "src/p/bags"}),
        ("mkdir -p $1/maps ${OUT:-data}/x\n", {"…/maps", "data/x"}),
        ("N=(a b)\nfor n in ${N[@]}; do touch c/$n.yaml; done\n", {"c/a.yaml", "c/b.yaml"}),
        ("mkdir -p src/{a,b}/maps\n", {"src/a/maps", "src/b/maps"}),
        ("wget -q https://x.org/net.pt -P weights\n", {"weights/net.pt"}),
        (
            "wget https://x.org/net.pt -O w/n.pt\ncurl -L https://x.org/y -o w/y.pt\n",
            {"net.pt", "w/n.pt", "y", "w/y.pt"},
        ),
        ("git clone -b main https://a.org/b/sdk.git third_party/sdk\n", {"third_party/sdk"}),
        ("git clone https://a.org/b/sdk.git && cd sdk && mkdir build\n", {"sdk", "build", "sdk/build"}),
        ("sudo cp -r /a/net.yaml config/\n", {"config/", "config//net.yaml"}),
        ("ln -s ../meshes src/p/meshes\n", {"src/p/meshes", "src/p/meshes/meshes"}),
        ("protoc --python_out=src/p a.proto\n", {"src/p"}),
        ("DIR = src/p\nall:\n\t@mkdir -p $(DIR)/maps\n", {"src/p/maps"}),
        ("RUN mkdir -p /ws && touch /ws/a\n", {"/ws", "/ws/a"}),
        ("tar xf a.tgz -C src/p\nunzip b.zip -d c\n", {"src/p", "c"}),
        ("git commit -o a\ngit pull https://a.org/b\n", {"a"}),
        ("ros2 pkg create p && mkdir p/maps\n", set()),
        ("cat a.txt\nls -l b\n", set()),
    ],
)
def test_what_a_script_writes(script: str, paths: set[str]) -> None:
    assert set(outputs(script)) == paths


def told(script: str, path: str = "setup.bash", folder: str = "robot") -> str:
    files = {
        "src/my_pkg/CMakeLists.txt": CMAKE.replace("ament_package", INSTALL.format(folder)),
        "src/my_pkg/package.xml": manifest("", "ament_cmake"),
        path: script,
    }
    (found,) = lint_files(files, ["CMK102"]).findings
    assert ("until it is fetched or made" in found.message) is (found.severity.value == "info")
    return found.severity.value


@pytest.mark.parametrize(
    ("script", "path"),
    [
        ("xacro tools/a.xacro -o src/my_pkg/robot/a.urdf\n", "setup.bash"),
        ("xacro tools/a.xacro > src/my_pkg/robot/a.urdf\n", "generate_robots.sh"),
        (LOOP, "generate_robots.sh"),
        (f"#!/bin/bash\n{LOOP}", "tools/generate"),
        ("HERE=$(cd $(dirname $0) && pwd)\nmkdir -p $HERE/src/my_pkg/robot\n", "build.sh"),
        ("cd src/my_pkg\nmkdir robot\n", "build.sh"),
        ("mkdir robot\n", "src/my_pkg/scripts/prepare.sh"),
        ("WORKDIR /ws/src/my_pkg\nRUN git clone https://a.org/robot robot\n", "docker/Dockerfile.jazzy"),
        ("all:\n\tmkdir -p src/my_pkg/robot\n", "Makefile"),
    ],
)
def test_a_folder_that_a_script_writes_is_an_info(script: str, path: str) -> None:
    assert told(script, path) == "info"


@pytest.mark.parametrize(
    ("script", "path"),
    [
        ("xacro src/my_pkg/robot/a.xacro -o a.urdf\n", "setup.bash"),
        ("xacro tools/a.xacro -o src/my_pkg/robots/a.urdf\n", "setup.bash"),
        ("xacro tools/a.xacro -o src/other/robot/a.urdf\n", "setup.bash"),
        ("mkdir robot\n", "build.sh"),
        ("mkdir -p /robot ~/robot/x/robot\n", "src/my_pkg/build.sh"),
        ("cp src/my_pkg/robot/a.urdf /tmp/a.urdf\n", "build.sh"),
        ("mkdir -p $DIR\n", "src/my_pkg/build.sh"),
        (LOOP, "tools/notes"),
    ],
)
def test_a_folder_that_nothing_writes_stops_the_build(script: str, path: str) -> None:
    assert told(script, path) == "error"


ENTRY = "        ('share/' + package_name, ['package.xml']),\n"
NAV = "        ('share/' + package_name + '/config', ['config/left_nav.yaml']),\n"


@pytest.mark.parametrize(
    ("script", "level"),
    [
        ("for side in left right; do\n  ./gen.py > my_pkg/config/${side}_nav.yaml\ndone\n", "info"),
        ("for side in left right; do\n  ./gen.py > my_pkg/config/${side}_nva.yaml\ndone\n", "error"),
        ("./gen.py > my_pkg/config/$NAME.yaml\n", "error"),
    ],
)
def test_a_file_of_setup_py_that_a_script_writes_is_an_info(script: str, level: str) -> None:
    files = {**existing_files(BACKDROPS["ament_python"]), "setup.py": setup_py().replace(ENTRY, ENTRY + NAV)}
    written = {f"my_pkg/{path}": text for path, text in files.items()}
    (found,) = lint_files({**written, "generate.sh": script}, ["SET205"]).findings
    assert found.severity.value == level
