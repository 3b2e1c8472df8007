"""Ask the real rosdep how it resolves names: `rosdep_verdicts.py DISTRO CODENAME`, a name a line on stdin.

Runs under a Python that has rosdep, in an environment whose ROS_HOME holds what `rosdep update` fetched.  Each name
goes through the function behind `rosdep resolve`; one JSON line for each: installer and packages, or null and error.
"""

from __future__ import annotations

import contextlib
import io
import json
import os
import sys
from types import SimpleNamespace
from typing import Any

import rosdep2.main as rosdep

distro, codename = sys.argv[1:3]
os.environ["ROS_DISTRO"] = distro
rosdep.setup_environment_variables(distro)
OPTIONS = SimpleNamespace(
    sources_cache_dir=rosdep.get_sources_cache_dir(),
    verbose=False,
    os_override=f"ubuntu:{codename}",
    as_root={},
    ros_distro=distro,
    dependency_types=[],
)
LOOKUP = rosdep._get_default_RosdepLookup(OPTIONS)


def verdict(name: str) -> list[Any]:
    said, complained = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(said), contextlib.redirect_stderr(complained):
        try:
            status = rosdep.command_resolve([name], OPTIONS, LOOKUP)
        except Exception as error:
            return [None, f"{type(error).__name__}: {error}".partition("\n")[0]]
    if status:
        return [None, complained.getvalue().strip()]
    installer, packages = said.getvalue().splitlines()
    return [installer.removeprefix("#"), packages.split()]


for line in sys.stdin:
    print(json.dumps(verdict(line.rstrip("\n"))), flush=True)
