"""DEP001, DEP203: names that pages, scripts and jobs have rosdep skip stop nobody who follows these."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest
from rospkg_cli.testing import lint_files

NEEDS = "  <exec_depend>opencv-python</exec_depend>\n  <exec_depend>rospy</exec_depend>\n"


@pytest.mark.parametrize(
    "page, skipped",
    [
        ({}, ""),
        (
            {"README.md": 'rosdep install -i --from-paths src --skip-keys "opencv-python rospy"\n'},
            "opencv-python rospy",
        ),
        ({"README.md": "`rosdep install -i --from-paths src --skip-keys=rospy`\n"}, "rospy"),
        ({"docker/Dockerfile": "RUN rosdep install -y --skip-keys opencv-python --skip-keys other\n"}, "opencv-python"),
        ({".github/workflows/ci.yml": "env:\n  ROSDEP_SKIP_KEYS: 'opencv-python'\n"}, "opencv-python"),
        ({".github/workflows/ci.yml": "with:\n  rosdep-skip-keys: rospy\n"}, "rospy"),
        ({"README.md": "rosdep install -i --from-paths src --skip-keys $KEYS\n"}, ""),
        ({"setup.sh": 'KEYS="rospy foo"\nrosdep install --from-paths src --skip-keys "$KEYS"\n'}, "rospy"),
        ({"setup.sh": 'KEYS=(\n  rospy\n)\nrosdep install --skip-keys "${KEYS[*]}"\n'}, "rospy"),
        ({"setup.sh": 'OTHERS="rospy"\nrosdep install --skip-keys "$KEYS"\n'}, ""),
        ({"docker/Dockerfile": "RUN python3 -c \"run(['rosdep', 'install', '--skip-keys', 'rospy'])\"\n"}, "rospy"),
    ],
)
def test_what_rosdep_is_told_to_skip_is_an_info(page: dict[str, str], skipped: str) -> None:
    found = lint_files({"my_pkg/package.xml": manifest(NEEDS), **page}, ["DEP001", "DEP203"]).findings
    assert {each.message.split("`")[1] for each in found if each.severity.value == "info"} == set(skipped.split())
    assert len(found) == 2
    assert all(("has rosdep skip it" in each.message) is (each.severity.value == "info") for each in found)
