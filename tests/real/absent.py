"""What happens where a real tool can't be had."""

from __future__ import annotations

import os
from typing import NoReturn

import pytest


def absent(reason: str) -> NoReturn:
    """Skip, where that is allowed."""
    if os.environ.get("CI") == "true" or os.environ.get("ROSPKG_REAL") == "1":
        pytest.fail(reason, pytrace=False)
    pytest.skip(reason)
