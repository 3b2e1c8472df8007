"""What a repository has pip install is there without package.xml: an info (DEP101)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, SETUP_PY, existing_files, manifest
from rospkg_cli.finding import Safety
from rospkg_cli.testing import lint_files

NODE = "import serial\nimport cv2\nimport rclpy\n"
DOCKERFILE = "FROM ros:jazzy\nRUN apt install x && pip3 install --no-cache-dir 'pyserial>=3' \\\n    opencv-python\n"


@pytest.mark.parametrize(
    ("files", "levels"),
    [
        ({}, {"serial": "warning", "opencv": "warning", "rclpy": "warning"}),
        (
            {"src/my_pkg/requirements.txt": "# pyserial\nopencv-python==4.9\nrclpy\n"},
            {"serial": "warning", "opencv": "info", "rclpy": "warning"},
        ),
        ({"requirements.txt": "PySerial >= 3.5\n"}, {"serial": "info", "opencv": "warning", "rclpy": "warning"}),
        ({"docker/Dockerfile": DOCKERFILE}, {"serial": "info", "opencv": "info", "rclpy": "warning"}),
        ({"Dockerfile": "RUN apt install pyserial\n"}, {"serial": "warning", "opencv": "warning", "rclpy": "warning"}),
    ],
)
def test_what_pip_installs(files: dict[str, str], levels: dict[str, str]) -> None:
    package = {f"src/my_pkg/{path}": text for path, text in existing_files(BACKDROPS["ament_python"]).items()}
    tree = {**package, "src/my_pkg/package.xml": manifest(), "src/my_pkg/my_pkg/node.py": NODE, **files}
    found = lint_files(tree, ["DEP101"]).findings
    assert {each.message.split("`")[1].removeprefix("python3-"): each.severity.value for each in found} == levels


@pytest.mark.parametrize(
    ("path", "text", "level"),
    [
        ("environment.yml", "name: arm\ndependencies:\n  - python=3.10\n  - pip:\n      - pyserial==3.5\n", "info"),
        ("Pipfile", "[packages]\npyserial = '*'\n", "info"),
        ("pyproject.toml", "[project]\ndependencies = ['numpy', 'pyserial>=3']\n", "info"),
        ("requirements/base.txt", "pyserial\n", "info"),
        ("pip-requirements.txt", "pyserial\n", "info"),
        ("install_dependencies.sh", "pip3 install pyserial\n", "info"),
        ("scripts/deps.sh", "python3 -m pip install pyserial\n", "info"),
        ("docs/setup.md", "Type `pip install pyserial`.\n", "info"),
        ("docker/jazzy/Containerfile", "FROM ros:jazzy\nRUN pip install pyserial\n", "info"),
        ("Makefile", "deps:\n\tpip install pyserial\n", "info"),
        ("uv.lock", '[[package]]\nname = "pyserial"\nversion = "3.5"\n', "info"),
        ("poetry.lock", '[[package]]\nname = "pyserial"\nversion = "3.5"\n', "info"),
        ("pylock.toml", "[[packages]]\nname = 'pyserial'\n", "info"),
        ("Pipfile.lock", '{\n    "default": {\n        "pyserial": {\n', "info"),
        ("conda-lock.yml", "package:\n- name: pyserial\n  version: '3.5'\n", "info"),
        ("pixi.lock", "packages:\n- conda: https://a.org/noarch/pyserial-3.5-pyhd8ed1ab_1.conda\n", "info"),
        ("pixi.lock", "packages:\n- pypi: https://a.org/x.whl\n  name: pyserial\n", "info"),
        ("pixi.toml", "[dependencies]\npyserial = '*'\n", "info"),
        ("conda/ros.yaml", "channels: [conda-forge]\ndependencies: [python=3.11, pyserial]\n", "info"),
        ("ws.yml", "channels:\n- c\ndependencies:\n- python\n- pip: [numpy, pyserial]\n", "info"),
        ("ws.yml", "channels:\n- c\ndependencies:\n- conda-forge::pyserial>=3\nname: a\n", "info"),
        ("ws.yml", "channels:\n- pyserial\ndependencies:\n- numpy # not pyserial, yet\n", "warning"),
        ("ws.yml", "dependencies: [pyserial]\n", "warning"),
        ("uv.lock", '[[package]]\nname = "numpy"\nsource = "pyserial"\n', "warning"),
        ("reqs.txt", "pyserial\n", "info"),
        ("requirement.txt", "pyserial\n", "info"),
        ("frequencies.txt", "pyserial\n", "warning"),
        ("README.md", "Type `uv add pyserial`.\n", "info"),
        ("install.sh", 'PKGS="numpy pyserial"\npip install $PKGS\n', "info"),
        ("install.sh", 'PKGS=(\n  numpy\n  pyserial\n)\npip3 install --user "${PKGS[@]}"\n', "info"),
        ("install.sh", "for each in numpy pyserial; do\n  pip install $each\ndone\n", "info"),
        ("install.sh", "ALL='pyserial'\nfor each in $ALL; do pip install $each; done\n", "info"),
        ("install.sh", "PKGS='pyserial'\nALL='$ALL'\npip install $ALL\n", "warning"),
        (".github/workflows/ci.yml", "jobs:\n  test:\n    steps:\n    - run: pip3 install pyserial\n", "info"),
        (".circleci/config.yml", "jobs:\n  test:\n    steps:\n    - run: pip3 install pyserial\n", "info"),
        ("Taskfile.yml", "tasks:\n  deps:\n    cmds:\n    - pip3 install pyserial\n", "info"),
        ("Earthfile", "build:\n  RUN pip3 install pyserial\n", "info"),
        (".gitlab-ci.yml", "test:\n  script:\n  - pip install -U pyserial\n", "info"),
        (".github/workflows/ci.yml", "jobs:\n  pyserial:\n    steps:\n    - run: pip3 install ruff\n", "warning"),
        ("environment.yml", "name: arm\ndependencies:\n  - numpy\n", "warning"),
        ("docs/setup.md", "It works with pyserial.\n", "warning"),
        ("other/pip.sh", "pip install pyserial\n", "warning"),
    ],
)
def test_where_pip_is_told(path: str, text: str, level: str) -> None:
    package = {f"src/my_pkg/{path}": text for path, text in existing_files(BACKDROPS["ament_python"]).items()}
    tree = {**package, "src/my_pkg/package.xml": manifest(), "src/my_pkg/my_pkg/node.py": "import serial\n", path: text}
    (only,) = lint_files(tree, ["DEP101"]).findings
    assert only.severity.value == level


@pytest.mark.parametrize(
    ("listed", "module", "level", "said"),
    [
        ("ultralytics==8.2", "torch", "info", "has pip install `ultralytics`, which requires it in most versions"),
        ("Sb3_Contrib", "pandas", "info", "has pip install `sb3-contrib`, which requires"),
        ("mediapipe", "cv2", "info", "has pip install `mediapipe`, which requires"),
        ("librosa", "sklearn.cluster", "info", "has pip install `librosa`, which requires"),
        ("torch\nultralytics", "torch", "info", "this repository has pip install it"),
        ("ultralytics", "serial", "warning", "raises ModuleNotFoundError"),
        ("torch", "PIL", "warning", "raises ModuleNotFoundError"),
        ("# ultralytics", "pandas", "warning", "raises ModuleNotFoundError"),
    ],
)
def test_what_comes_with_what_pip_installs(listed: str, module: str, level: str, said: str) -> None:
    package = existing_files(BACKDROPS["ament_python"])
    tree = {**package, "package.xml": manifest(), "my_pkg/node.py": f"import {module}\n", "requirements.txt": listed}
    (only,) = lint_files(tree, ["DEP101"]).findings
    assert only.severity.value == level
    assert said in only.message


@pytest.mark.parametrize(
    ("module", "path", "text", "level"),
    [
        ("pinocchio", "install.sh", "pip3 install pin\n", "info"),
        ("pinocchio.utils", "requirements.txt", "pin\n", "info"),
        ("pinocchio", "install.sh", "conda install -y -c conda-forge pinocchio casadi\n", "info"),
        ("pinocchio", "README.md", "sudo apt install robotpkg-py310-pinocchio\n", "info"),
        ("py_trees", "install.sh", "pip3 install py-trees\n", "info"),
        ("pinocchio", "requirements.txt", "pinned\n", "warning"),
        ("std_msgs.msg", "requirements.txt", "std_msgs\n", "warning"),
        ("rclpy", "install.sh", "conda install rclpy\n", "warning"),
    ],
)
def test_ros_packages_that_pip_has_too(module: str, path: str, text: str, level: str) -> None:
    package = existing_files(BACKDROPS["ament_python"])
    tree = {**package, "package.xml": manifest(), "my_pkg/node.py": f"import {module}\n", path: text}
    (only,) = lint_files(tree, ["DEP101"]).findings
    assert only.severity.value == level


SETUP = SETUP_PY.replace("['setuptools']", "['setuptools', \"pyserial>=3\", 'httpx']")
CFG = "[options]\ninstall_requires =\n    setuptools\n    pyserial>=3\nzip_safe = true\n"


@pytest.mark.parametrize(
    ("path", "text", "level"),
    [
        ("README.md", "Enter a virtual environment, go to `my_pkg`, then\n```\npip install .\n```\n", "info"),
        ("src/my_pkg/README.md", "pip3 install -e .\n", "info"),
        ("README.md", "pip install -e src/my_pkg[dev]\n", "info"),
        ("docker/Dockerfile", "RUN pip install --no-cache-dir /ws/src/my_pkg/\n", "info"),
        ("README.md", "cd other && pip install .\n", "warning"),
        ("README.md", "pip install src/my_pkg_msgs\n", "warning"),
        ("README.md", "my_pkg is built by colcon.\n", "warning"),
    ],
)
@pytest.mark.parametrize("setup", [{"setup.py": SETUP}, {"setup.cfg": CFG}])
def test_what_setup_requires_where_pip_installs_the_package(
    path: str, text: str, level: str, setup: dict[str, str]
) -> None:
    own = {**existing_files(BACKDROPS["ament_python"]), **setup, "my_pkg/node.py": "import serial\n"}
    package = {f"src/my_pkg/{path}": each for path, each in own.items()}
    found = lint_files({**package, "src/my_pkg/package.xml": manifest(), path: text}, ["DEP101"]).findings
    assert [each.severity.value for each in found] == [level]


@pytest.mark.parametrize(
    ("imported", "module", "level"),
    [
        ("import rclpy", "torch", "info"),
        ("import rclpy", "torchvision.transforms", "info"),
        ("from ultralytics import YOLO", "cv2", "info"),
        ("from ultralytics import YOLO", "serial", "warning"),
        ("import whisper", "numpy", "info"),
        ("try:\n    from ultralytics import YOLO\nexcept ImportError:\n    YOLO = None", "cv2", "warning"),
        ("def load():\n    from ultralytics import YOLO", "cv2", "warning"),
    ],
)
def test_what_people_have_who_run_it(imported: str, module: str, level: str) -> None:
    package = existing_files(BACKDROPS["ament_python"])
    code = {"my_pkg/node.py": f"import {module}\n", "my_pkg/other.py": f"{imported}\n"}
    found = lint_files({**package, "package.xml": manifest(), **code}, ["DEP101"]).findings
    top = module.partition(".")[0]
    (only,) = [f for f in found if f"`{module}`" in f.message or f"`{top}`" in f.message.partition(" and not")[0]]
    assert only.severity.value == level


def test_a_framework_is_declared_on_request_alone() -> None:
    files = {**existing_files(BACKDROPS["ament_python"]), "package.xml": manifest(), "my_pkg/a.py": "import torch\n"}
    (only,) = lint_files(files, ["DEP101"]).findings
    assert only.fix is not None
    assert only.fix.safety is Safety.UNSAFE


def test_what_tests_import_by_pip() -> None:
    package = existing_files(BACKDROPS["ament_python"])
    tree = {**package, "package.xml": manifest(), "test/test_a.py": "import serial\n\n\ndef test_a(): serial.x\n"}
    levels = [
        lint_files({**tree, "requirements.txt": each}, ["DEP102"]).findings[0].severity.value for each in REQUIRED
    ]
    assert levels == ["info", "warning"]


REQUIRED = ("pyserial\n", "numpy\n")


@pytest.mark.parametrize(
    ("page", "level"),
    [
        ("git clone https://github.com/acme/acme_msgs.git -b humble\n", "info"),
        ("It needs [messages](https://github.com/acme/acme_msgs).\n", "info"),
        ("git clone https://github.com/other/other_msgs.git\n", "warning"),
        ("It needs acme_msgs.\n", "warning"),
    ],
)
def test_an_unknown_package_whose_repository_is_cloned(page: str, level: str) -> None:
    package = {**existing_files(BACKDROPS["ament_python"]), "package.xml": manifest(), "README.md": page}
    found = lint_files({**package, "my_pkg/a.py": "from acme_msgs.msg import Joint\n"}, ["DEP101"]).findings
    assert [each.severity.value for each in found] == [level]


@pytest.mark.parametrize("module", ["cyclonedds", "gtsam", "ruckig"])
def test_packages_of_ros_without_python(module: str) -> None:
    package = {**existing_files(BACKDROPS["ament_python"]), "package.xml": manifest()}
    assert lint_files({**package, "my_pkg/a.py": f"import {module}\n"}, ["DEP101"]).findings == ()


def test_a_key_without_a_rule_for_some_distributions_is_declared_on_request_alone() -> None:
    files = {**existing_files(BACKDROPS["ament_python"]), "package.xml": manifest(), "my_pkg/a.py": "import utm\n"}
    (only,) = lint_files(files, ["DEP101"]).findings
    assert "<exec_depend>python3-utm</exec_depend>, which only jazzy, " in only.message
    assert only.fix is not None
    assert only.fix.safety is Safety.UNSAFE
