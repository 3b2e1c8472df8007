"""Calls in setup.py that may write files which it then installs."""

from __future__ import annotations

from ...languages.python.evaluate.values import Call, Text

HARMLESS = frozenset(
    "setuptools distutils os sys pathlib glob io codecs re platform warnings xml json yaml datetime time collections "
    "itertools functools importlib fnmatch string textwrap catkin_pkg ast math logging typing packaging "
    "ament_index_python".split()
)
"""Modules whose functions make no file that would be installed, but for what WRITES names."""

GENERATORS = frozenset({"generate_parameter_library_py.setup_helper.generate_parameter_module"})
"""Functions that write a module of the name they are given into the installed Python package, and nothing else."""

WRITES = frozenset({"os.system", "os.makedirs", "os.mkdir", "os.symlink", "os.rename", "os.popen"})


def may_write(call: Call) -> bool:
    if call.callee in GENERATORS:
        return not isinstance(call.get("module_name", 0), Text)
    root = call.callee.partition(".")[0]
    if call.receiver is not None:
        return False
    return call.callee in WRITES or call.callee in ("open", "exec") or ("." in call.callee and root not in HARMLESS)
