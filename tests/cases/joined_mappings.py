"""Words of `Command` that xacro gets as one (LCH014)."""

from __future__ import annotations

from .shown_launch_calls import python

MAPPINGS = (
    "Command(['xacro ', source, ' name:=a', 'mode:=b'])",
    "Command([FindExecutable(name='xacro'), ' ', source, 'name:=a'])",
    "Command(['xacro ', source, ' name:=', a, 'mode:=', b])",
    "Command(['xacro ', source, ' name:=', a, ' mode:=', b])",
    "Command(['xacro ', source, ' ', 'name:=', a, ' ', 'mode:=', b])",
    "Command(['xacro ', source, ' ', a, 'mode:=b'])",
    "Command(['xacro ', source, unknown, 'mode:=b', *a])",
    "Command(['other ', source, 'mode:=b'])",
    "Command(['xacro ', source, ' name:=', 'a:=b'])",
)
CASES = {
    "LCH014": tuple(python(f"Node(package='p', executable='e', parameters=[{{'a': {each}}}])") for each in MAPPINGS)
}
