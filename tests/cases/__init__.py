"""Cases of rules beside their examples: sentences, levels and fixes that users need not read about."""

from __future__ import annotations

import importlib
from pathlib import Path

from rospkg_cli.example import Example

CASES: dict[str, tuple[Example, ...]] = {}
for path in sorted(Path(__file__).parent.glob("[a-z]*.py")):
    for code, cases in importlib.import_module(f"{__name__}.{path.stem}").CASES.items():
        CASES[code] = CASES.get(code, ()) + cases
