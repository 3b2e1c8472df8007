"""What stands before an import and decides who misses the module: pip, or a module of ROS 1 (DEP101)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest, scripts, setup_py
from rospkg_cli.testing import lint_files

FILES = {
    "package.xml": manifest(),
    "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
    "resource/my_pkg": "",
    "my_pkg/__init__.py": "",
}
MAIN = "\n\ndef main():\n    print({}.__name__)\n"


def told(text: str, **more: str) -> list[tuple[str, str]]:
    found = lint_files({**FILES, "my_pkg/talker.py": text, **more}, ["DEP101"]).findings
    return [(each.severity.value, each.message.rpartition("; ")[2]) for each in found]


PIP = ("info", "this file has pip install it before")
JOBLIB, CV2 = "import joblib\n" + MAIN.format("joblib"), "import cv2\n" + MAIN.format("cv2")
TOLD = "this file says to install it by pip"
STAND_IN = "this file puts something in its place before"
ADD = ("warning", "add <exec_depend>python3-joblib</exec_depend>")


@pytest.mark.parametrize(
    "before",
    [
        "check_requirements(('optuna', 'joblib>=1.0'))\n",
        "check_requirements('joblib')\n",
        "subprocess.check_call([sys.executable, '-m', 'pip', 'install', 'joblib'])\n",
        "os.system('pip install joblib')\n",
        "pip.main(['install', 'joblib'])\n",
        "install('joblib')\n",
        "ensure_package('joblib')\n",
    ],
)
def test_a_module_that_the_file_has_pip_install_is_an_info(before: str) -> None:
    assert told(before + JOBLIB) == [PIP]


def test_the_name_of_the_distribution_counts() -> None:
    assert told("os.system('pip3 install opencv-python')\n" + CV2) == [PIP]


@pytest.mark.parametrize(
    ("before", "behind"),
    [
        ("", "check_requirements(('joblib',))\n"),
        ("check_requirements(('optuna',))\n", ""),
        ("print('joblib')\n", ""),
        ("os.system('apt install joblib')\n", ""),
        ("log('pip install joblib')\n", ""),
    ],
)
def test_other_calls_install_nothing_before(before: str, behind: str) -> None:
    assert told(before + JOBLIB + behind) == [ADD]


@pytest.mark.parametrize(
    "module", ["import tf", "from tf.transformations import euler_from_quaternion", "import rosbag"]
)
def test_what_stands_behind_a_module_of_ros_1_is_an_info_and_that_is_told(module: str) -> None:
    top = module.split()[1].partition(".")[0]
    assert sorted(told(f"{module}\n{JOBLIB}")) == [
        ("info", f"it stands behind `import {top}`, which ROS 1 alone has"),
        ("warning", "port it to rclpy, or do not install it"),
    ]


@pytest.mark.parametrize(
    "text",
    [
        f"{JOBLIB}\nimport tf\n",
        f"try:\n    import tf\nexcept ImportError:\n    tf = None\n{JOBLIB}",
        f"import tf2_ros as tf\n{JOBLIB}",
        f"def later():\n    import tf\n\n\n{JOBLIB}",
    ],
)
def test_a_module_of_ros_1_that_comes_later_or_may_fail_changes_nothing(text: str) -> None:
    assert ADD in told(text)


def test_a_module_of_ones_own_is_none_of_ros_1() -> None:
    assert told(f"import tf\n{JOBLIB}", **{"my_pkg/tf.py": ""}) == [ADD]


@pytest.mark.parametrize(
    ("text", "level", "why"),
    [
        ("import joblib  # pip install joblib\n", "info", "this file says to install it by pip"),
        (
            '"""Needs joblib.\n\npip3 install joblib==1.0\n"""\nimport joblib\n',
            "info",
            "this file says to install it by pip",
        ),
        ("import joblib  # do not pip install joblib\n", *ADD),
        ("import joblib  # pip install scipy\n", *ADD),
        ("import sys\nsys.modules['joblib'] = object()\nimport joblib\n", "info", STAND_IN),
        ("import sys\nsys.modules.setdefault('joblib', object())\nimport joblib\n", "info", STAND_IN),
        ("import sys\nsys.modules['other'] = object()\nimport joblib\n", *ADD),
        ("import sys\nprint(sys.modules['joblib'])\nimport joblib\n", *ADD),
        ("import joblib\nimport sys\nsys.modules['joblib'] = object()\n", *ADD),
    ],
)
def test_what_the_file_says_and_puts_there(text: str, level: str, why: str) -> None:
    assert told(text + MAIN.format("joblib")) == [(level, why)]
