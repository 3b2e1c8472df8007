"""An index of names for a bench, made of a copy of rosdistro."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path


def fetch_index(rosdistro: Path) -> None:
    """Write the index into the cache folder that the environment names; raises CalledProcessError."""
    command = [sys.executable, "-m", "rospkg_cli", "index", "update", "--source", str(rosdistro), "--quiet"]
    subprocess.run(command, check=True)
