"""An undeclared import that stands under a condition is an info, and what rosdep itself needs is there (DEP101)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, manifest, scripts, setup_py
from rospkg_cli.testing import lint_files

HEAD = "import sys\n\n\ndef main(plot=None):\n"


@pytest.mark.parametrize(
    ("body", "level"),
    [
        ("    import seaborn\n", "warning"),
        ("    if plot:\n        import seaborn\n", "info"),
        ("    if plot:\n        pass\n    else:\n        import seaborn\n", "info"),
        ("    for each in sys.argv:\n        import seaborn\n", "warning"),
        ("    if plot:\n        import seaborn\n    import seaborn\n", "warning"),
        ("    pass\n\n\nif __name__ == '__main__':\n    main()\nimport seaborn\n", "warning"),
    ],
)
def test_levels(body: str, level: str) -> None:
    assert levels_of(HEAD + body) == [level]


def test_what_rosdep_needs_is_one_info() -> None:
    assert levels_of(HEAD + "    import rospkg\n    import rosdep2\n") == ["info"]


def levels_of(text: str) -> list[str]:
    package = existing_files(BACKDROPS["ament_python"])
    files = {"setup.py": setup_py(scripts("talker = my_pkg.talker:main")), "my_pkg/talker.py": text}
    found = lint_files({**package, "package.xml": manifest(), **files}, ["DEP101"]).findings
    return [each.severity.value for each in found]
