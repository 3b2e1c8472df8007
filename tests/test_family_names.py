"""An unknown package that begins like the one that needs it lies in another repository of its makers: an info."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest
from rospkg_cli.testing import lint_files

LAUNCH = '<launch><node pkg="{}" exec="a"/></launch>\n'


@pytest.mark.parametrize(
    ("own", "wanted", "others", "level"),
    [
        ("acme_bringup", "acme_driver", (), "info"),
        ("acme_bringup", "acme_driver", ("other_msgs",), "info"),
        ("acme_bringup", "acme_driver", ("acme_msgs",), "warning"),
        ("acme_bringup", "bolt_driver", (), "warning"),
        ("acme_bringup", "acme_bringups", (), "warning"),
        ("robot_bringup", "robot_driver", (), "warning"),
        ("acme", "acme_driver", (), "warning"),
    ],
)
def test_levels(own: str, wanted: str, others: tuple[str, ...], level: str) -> None:
    named = {f"src/{each}/package.xml": manifest().replace("my_pkg", each) for each in (own, *others)}
    found = lint_files({**named, f"src/{own}/launch/a.launch.xml": LAUNCH.format(wanted)}, ["DEP103"]).findings
    (only,) = (each for each in found if f"`{wanted}`" in each.message)
    assert (only.severity.value, "of its family" in only.message) == (level, level == "info")
