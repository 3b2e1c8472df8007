"""Packages inside of one that pages and scripts bring to colcon: by a link, a copy, a mount or a list (WSP005)."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest

INNER = {
    "drivers/arm/package.xml": manifest("", "cmake", "arm"),
    "drivers/arm/CMakeLists.txt": CMAKE.replace("my_pkg", "arm"),
    "drivers/arm/arm.cpp": "int main() {}\n",
}
TEXTS = {
    "README.md": (
        "ln -s $(pwd)/drivers/arm ~/ws/src/\n",
        "Run `cp -r drivers/arm ~/ws/src`.\n",
        "mv drivers/* \\\n  ~/ws/src/\n",
        "colcon build --base-paths src src/my_pkg/drivers/arm\n",
        "cp arm.yaml drivers/arm\n",
        "cp drivers/arm/arm.yaml ~/ws/src\n",
    ),
    "colcon_defaults.yaml": (
        "build:\n  base-paths:\n    - src\n    - src/my_pkg/drivers/arm\n  symlink-install: true\n",
        "build:\n  base-paths: [src, src/my_pkg/drivers]\n",
        "build:\n  base-paths: [src]\n",
    ),
    "Dockerfile": ("COPY drivers/arm/ /ws/src/arm/\n", 'ADD ["drivers/arm", "/ws/src/arm"]\n'),
    "drivers/arm/README.md": ("ln -s ~/my_pkg/drivers/arm\n",),
    "docker-compose.yml": ("volumes:\n  - ./drivers/arm:/ws/src/arm\n",),
    ".devcontainer/devcontainer.json": ('{"mounts": ["source=${root}/drivers/arm,target=/ws/src/arm"]}\n',),
}
COMPILED = CMAKE.replace("ament_package", "add_executable(arm drivers/arm/arm.cpp)\nament_package")

CASES = {
    "WSP005": (
        *(
            Example(on="", good={}, bad={"package.xml": manifest("", "cmake"), **INNER, path: text})
            for path, texts in TEXTS.items()
            for text in texts
        ),
        Example(on="ament_cmake", good={}, bad={**INNER, "CMakeLists.txt": COMPILED}),
    ),
}
