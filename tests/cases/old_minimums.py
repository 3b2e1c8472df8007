"""Versions of CMake below 3.5, in repositories that name their distributions or do not (CMK002)."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example

OLD = {"CMakeLists.txt": CMAKE.replace("3.20", "3.3")}

CASES = {
    "CMK002": (
        *(
            Example(bad={**OLD, "README.md": f"For {names}.\n"}, good={}, on="ament_cmake")
            for names in ("all", "Humble", "Humble and Jazzy", "Jazzy and Lyrical")
        ),
        Example(bad={**OLD, "README.md": "For Humble.\n"}, good={}, on="ament_cmake", targets=("lyrical",)),
    ),
}
