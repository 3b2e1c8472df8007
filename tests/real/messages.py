"""Packages of messages that generated nodes use, made by rosidl from what `new` writes.

Neither Debian nor a package index has them. Their fields are those of the real ones as far as nodes touch them. They
are built once, and kept in the cache beside the tools.
"""

from __future__ import annotations

import hashlib
import shutil
from pathlib import Path
from unittest.mock import patch

from shell import Shell
from testing_new import PREFIX, plan, write
from venvs import cache_folder, locked

from rospkg_cli.scaffold import names

MESSAGES: dict[str, dict[str, tuple[str, ...]]] = {
    "builtin_interfaces": {"msgs": ("Time:int32 sec, uint32 nanosec", "Duration:int32 sec, uint32 nanosec")},
    "unique_identifier_msgs": {"msgs": ("UUID:uint8[16] uuid",)},
    "action_msgs": {
        "msgs": (
            "GoalInfo:unique_identifier_msgs/UUID goal_id, builtin_interfaces/Time stamp",
            "GoalStatus:GoalInfo goal_info, int8 status",
            "GoalStatusArray:GoalStatus[] status_list",
        ),
        "srvs": ("CancelGoal:GoalInfo goal_info --- int8 return_code, GoalInfo[] goals_canceling",),
    },
    "std_msgs": {"msgs": ("String:string data", "Header:builtin_interfaces/Time stamp, string frame_id")},
    "rcl_interfaces": {
        "msgs": (
            "FloatingPointRange:float64 from_value, float64 to_value, float64 step",
            "IntegerRange:int64 from_value, int64 to_value, uint64 step",
            "ParameterDescriptor:string name, uint8 type, string description, bool read_only, "
            "FloatingPointRange[<=1] floating_point_range, IntegerRange[<=1] integer_range",
        )
    },
    "example_interfaces": {
        "srvs": ("AddTwoInts:int64 a, int64 b --- int64 sum",),
        "actions": ("Fibonacci:int32 order --- int32[] sequence --- int32[] sequence",),
    },
}


def message_prefix(colcon: Shell) -> Path:
    """Return the prefix that all of them are installed in; a shell is needed in which colcon finds ament and rosidl."""
    with patch.object(names, "TAKEN", frozenset()):
        plans = [plan(name, template="interfaces", distro="humble", **asked) for name, asked in MESSAGES.items()]
    content = repr([(each.answers.name, each.files) for each in plans]) + colcon.variables["PATH"]
    folder = cache_folder() / f"messages-{hashlib.sha256(content.encode()).hexdigest()[:16]}"
    with locked(folder.with_suffix(".lock")):
        if not (folder / "finished").exists():
            shutil.rmtree(folder, ignore_errors=True)
            for each in plans:
                write(each, folder)
            built = colcon.run("colcon", "build", "--merge-install", cwd=folder, CMAKE_PREFIX_PATH=str(PREFIX))
            assert (built.returncode, built.stderr) == (0, "")
            shutil.rmtree(folder / "build")
            (folder / "finished").touch()
    return folder / "install"
