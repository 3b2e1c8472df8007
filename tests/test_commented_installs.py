"""What a comment of package.xml has people install by pip, by a script or by hand is left to them: an info."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, manifest
from rospkg_cli.testing import lint_files

PYTHON = existing_files(BACKDROPS["ament_python"])
NODE = {"my_pkg/my_node.py": "import joblib\n\n\ndef main() -> None:\n    print(joblib)\n"}
LEAST = ("joblib is installed by pip", "Install joblib manually", "joblib: install_deps.sh")


def level(comment: str, files: dict[str, str], code: str = "DEP101") -> str:
    """Return the level of the one finding, and hold that it says why it is mild."""
    tree = {**PYTHON, **files, "package.xml": manifest(f"  <exec_depend>ros2launch</exec_depend>\n  {comment}\n")}
    (found,) = (each for each in lint_files(tree, [code]).findings)
    assert ("a comment of package.xml" in found.message) is (found.severity.value == "info")
    return found.severity.value


@pytest.mark.parametrize(
    ("comment", "wanted"),
    [
        *((f"<!-- {each} -->", "info") for each in LEAST),
        ("<!-- scikit-learn and joblib are installed by pip / scripts/install_deps.sh -->", "info"),
        ("<!-- scikit-learn dan joblib di-install lewat pip -->", "info"),
        ("<!-- scikit-learn: pip3 install, no key has the version -->", "info"),
        ("<!-- Not in rosdep, install by hand:\n    - numba\n    - joblib\n  -->", "info"),
        ("<!-- The rest is installed via pip: -->\n  <!-- joblib -->\n  <!-- numba -->", "info"),
        ("<!-- joblib, numba (conda environment) -->", "info"),
        ("<!-- python3-joblib wird manuell installiert -->", "info"),
        ("<!-- joblib 需要手动安装 -->", "info"),
        ("<!-- joblib loads the model -->", "warning"),
        ("<!-- numba is installed by pip -->", "warning"),
        ("<!-- joblib loads the model. Numba is installed by pip. -->", "warning"),
        ("<!-- joblib loads the model -->\n  <!-- Numba is installed by pip. -->", "warning"),
        ("<!-- NO numba! joblib is called manually -->", "warning"),
        ("<!-- the installed scripts need joblib -->", "warning"),
        ("<!-- build scripts: joblib -->", "warning"),
        ("<!-- rosdep installs joblib by pip -->", "warning"),
        ("<!-- joblib before python3-pip -->", "warning"),
        ("<!-- pip -->\n  <exec_depend>rclpy</exec_depend>\n  <!-- joblib -->", "warning"),
    ],
)
def test_an_import(comment: str, wanted: str) -> None:
    assert level(comment, NODE) == wanted


def test_an_import_of_tests_and_a_node_that_a_launch_file_starts() -> None:
    test = {"test/test_a.py": "import joblib\n\n\ndef test_a() -> None:\n    assert joblib\n"}
    assert level(f"<!-- {LEAST[0]} -->", test, "DEP102") == "info"
    launch = {"launch/a.launch.xml": '<launch><node pkg="joy" exec="joy_node"/></launch>\n'}
    assert level("<!-- joy is installed from source by scripts/setup.sh -->", launch, "DEP103") == "info"
    assert level("<!-- joy reads the gamepad -->", launch, "DEP103") == "warning"


@pytest.mark.parametrize(("end", "wanted"), [("is built from source by hand", "info"), ("finds neighbours", "warning")])
def test_a_header(end: str, wanted: str) -> None:
    tree = existing_files(BACKDROPS["ament_cmake"])
    target = "add_executable(tree src/tree.cpp)\ninstall(TARGETS tree DESTINATION lib/${PROJECT_NAME})\n"
    tree["CMakeLists.txt"] = tree["CMakeLists.txt"].replace("ament_package", f"{target}ament_package")
    tree["src/tree.cpp"] = "#include <nanoflann.hpp>\nint main() {return 0;}\n"
    tree["package.xml"] = tree["package.xml"].replace("<license", f"<!-- nanoflann {end} -->\n  <license", 1)
    assert [each.severity.value for each in lint_files(tree, ["DEP105"]).findings] == [wanted]


def test_the_fix_is_left_to_people() -> None:
    tree = {**PYTHON, **NODE, "package.xml": manifest(f"  <!-- {LEAST[0]} -->\n")}
    (found,) = lint_files(tree, ["DEP101"]).findings
    assert found.fix is not None
    assert found.fix.safety.value == "unsafe"
