"""The least that a linter of ROS packages does: read and parse each file once. `python -m bench.floor FOLDER`

Python by `ast`, XML by expat, YAML by libyaml's events; of C++ the `#include` lines, of CMake the commands, each by one
regular expression. Nothing is kept. What rospkg takes is given as a multiple of this.
"""

from __future__ import annotations

import ast
import os
import re
import sys
import warnings
from collections import Counter
from contextlib import suppress
from pathlib import Path
from xml.parsers import expat

import yaml

XML = (".xml", ".launch", ".urdf", ".xacro", ".sdf", ".srdf")
CPP = (".c", ".cc", ".cpp", ".cxx", ".h", ".hh", ".hpp", ".hxx", ".ipp", ".tpp")
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*[<"]([^>"\n]+)[>"]', re.MULTILINE)
COMMAND = re.compile(r"^[ \t]*(\w+)[ \t]*\(([^()]*)\)", re.MULTILINE)


def parse(path: str, text: str) -> str:
    """Parse one file; return its kind, "" where it is of no interest."""
    with suppress(SyntaxError, ValueError, RecursionError, expat.ExpatError, yaml.YAMLError):
        if path.endswith(".py"):
            ast.parse(text)
            return "Python"
        if path.endswith(XML):
            expat.ParserCreate().Parse(text.encode(), True)
            return "XML"
        if path.endswith((".yaml", ".yml")):
            for _ in yaml.parse(text, Loader=getattr(yaml, "CSafeLoader", yaml.SafeLoader)):
                pass
            return "YAML"
        if path.endswith(CPP):
            INCLUDE.findall(text)
            return "C++"
        if path.endswith(("CMakeLists.txt", ".cmake")):
            COMMAND.findall(text)
            return "CMake"
        return "interfaces" if path.endswith((".msg", ".srv", ".action")) else ""
    return "broken"


def main(folder: str) -> None:
    warnings.simplefilter("ignore")
    count: Counter[str] = Counter()
    for root, folders, files in os.walk(folder):
        folders[:] = [name for name in folders if name not in (".git", "build", "install", "log")]
        for name in files:
            if name.endswith((".py", *XML, ".yaml", ".yml", *CPP, ".txt", ".cmake", ".msg", ".srv", ".action")):
                count[parse(name, Path(root, name).read_bytes().decode(errors="replace"))] += 1
    print(dict(count))


if __name__ == "__main__":
    main(sys.argv[1])
