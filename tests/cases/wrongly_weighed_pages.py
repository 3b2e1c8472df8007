"""Libraries that a page tells people to install by hand: wheels, a clone, a copied header, conda, from source."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example

from .setups import python

PAGES = (
    "- Jetson: numba / flash-attn wheels from an index\n",
    "Four wheels, and numba on the GPU.\n",
    "    conda install -c conda-forge numba\n",
    "Build numba 2.1 from source.\n",
    "Build this package from source. It needs numba.\n",
    "    git clone https://github.com/ada/numba.git\n",
)
CLONE = "```sh\ngit clone https://github.com/jlblancoc/nanoflann.git\n```\n"
COPY = "sudo cp nanoflann/include/nanoflann.hpp /usr/local/include/\n"
MADE = "cd nanoflann-1.4.0\nmkdir build\ncd build\ncmake ..\nmake\nsudo make install # this installs it\n"
IN_IMAGE = "RUN unzip -q x.zip && cd libs/nanoflann && mkdir build && cd build && cmake .. && make && make install\n"
PLACED = "cd nanoflann\ncmake -B build\nsudo cmake --build build --target install\n"
TAKEN = "Download nanoflann from [its page](https://github.com/jlblancoc/nanoflann/releases) and unzip it.\n"
LEFT = "cd nanoflann\ncolcon build\n"
"""Builds nothing that is installed beside ROS."""
PROGRAM = "{}add_executable(tree src/tree.cpp)\ninstall(TARGETS tree DESTINATION lib/${{PROJECT_NAME}})\n"


def trained(page: str, path: str = "my_pkg/train.py") -> Example:
    return python({path: "import numba\n", "README.md": page})


def tree(page: str, line: str = "", header: str = "nanoflann.hpp") -> Example:
    text = CMAKE.replace("ament_package", f"{PROGRAM.format(line)}ament_package")
    files = {"CMakeLists.txt": text, "README.md": page}
    files["src/tree.cpp"] = f"#include <{header}>\nint main() {{return 0;}}\n"
    return Example(on="ament_cmake", bad=files, good={})


MODBUS = (
    "```sh\ngit clone https://github.com/stephane/libmodbus\ncd libmodbus && ./configure && sudo make install\n```\n"
)
LINKED = "add_library(lib src/tree.cpp)\ntarget_link_libraries(lib modbus)\n"
FOUND = "find_package(yaml-cpp REQUIRED)\n"
CASES = {
    "DEP101": tuple(map(trained, PAGES)),
    "DEP102": tuple(trained(each, "test/test_train.py") for each in PAGES[:2]),
    "DEP104": (
        tree("git clone git@github.com:jbeder/yaml-cpp.git\n", FOUND, "vector"),
        tree("It reads YAML.\n", FOUND, "vector"),
    ),
    "DEP115": (tree(MODBUS, LINKED, "vector"), tree("It reads Modbus.\n", LINKED, "vector")),
    "DEP105": tuple(map(tree, (CLONE, COPY, MADE, IN_IMAGE, PLACED, TAKEN, LEFT, "It uses nanoflann.\n"))),
}
