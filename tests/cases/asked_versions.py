"""Versions in setup.py that are not those of package.xml, and who asks for them (SET402)."""

from __future__ import annotations

from rospkg_cli.example import SETUP_PY

from .setups import python

OTHER = SETUP_PY.replace("'1.0.0'", "'0.0.1'")

CASES = {
    "SET402": tuple(
        python({**files, "setup.py": OTHER})
        for files in (
            {"CHANGELOG.rst": ""},
            {"my_pkg/a.py": "from importlib.metadata import version\n"},
            {"my_pkg/a.py": "from importlib import resources\n"},
        )
    )
}
