"""Paths that CMake installs or compiles, and that somebody brings before the build (CMK102)."""

from __future__ import annotations

from rospkg_cli.example import Example

from .idioms_of_cmake import package

INSTALLED = "install({} DESTINATION share/${{PROJECT_NAME}})\n"
COMPILED = "add_executable(talker third_party/sdk/talker.cpp)\ninstall(TARGETS talker DESTINATION lib/my_pkg)\n"
LISTED = {"deps.repos": "repositories:\n  third_party/sdk:\n    type: git\n    url: https://example.org/x.git\n"}
BROUGHT = (
    ("DIRECTORY models", {"scripts/get.sh": "mkdir -p ../models\n"}),
    ("DIRECTORY generated", {"Makefile": "gen:\n\tmkdir -p generated\n"}),
    ("DIRECTORY launch", {"README.md": "mkdir launch\n"}),
    ("DIRECTORY maps", {".github/workflows/ci.yml": "      - run: mkdir -p maps\n"}),
    ("DIRECTORY maps", {"Dockerfile": "RUN mkdir -p /ws/src/my_pkg/maps\n"}),
    ("DIRECTORY models", {"README.md": "Create a folder `models` here, and put the network in it.\n"}),
    ("DIRECTORY models", {"README.md": "The models are good.\n"}),
    ("FILES lib/libsdk.so", {"README.md": "Copy `libsdk.so` of the vendor into `lib/`.\n"}),
    ("FILES lib/libsdk.so", {"README.md": "It needs the SDK.\n"}),
    ("FILES third_party/sdk/a.txt", {"README.md": "git clone https://example.org/sdk.git third_party/sdk\n"}),
)
"""What is missing, and who brings it."""

CASES: dict[str, tuple[Example, ...]] = {
    "CMK102": (
        *(package(INSTALLED.format(what), files) for what, files in BROUGHT),
        package(COMPILED, LISTED),
        package(COMPILED, {"README.md": "cd third_party && git clone https://example.org/sdk\n"}),
        package(
            COMPILED, {"README.md": "cd third_party && git clone https://example.org/sdk\n", "third_party/sdk/a": ""}
        ),
        package(
            COMPILED.replace("third_party/sdk", "src"), {"README.md": "git clone https://example.org/my_pkg src\n"}
        ),
    ),
}
