"""Sentences about names, arguments and lost commas of setup.py that no example shows."""

from __future__ import annotations

from rospkg_cli.example import SETUP_CFG, SETUP_PY, manifest, setup_py

from .setups import python

PATHS = "import os\n" + SETUP_PY.replace("('share/' + package_name, [", "(os.path.join('share', package_name), [")
BOTH_GROUPS = """\
entry_points={
        'console_scripts': ['talker = my_pkg.talker:main'],
        'console-scripts': ['listener = my_pkg.listener:main'],
    },"""
TOOL = "['setuptools']"
NUMPY = manifest("  <depend>python3-numpy</depend>\n")
NAME = "from setuptools import find_packages, setup\n"

CASES = {
    "SET308": (
        python({"setup.py": PATHS.replace("import os\n", "")}),
        python({"setup.py": PATHS.replace("import os\n", "").replace("os.path.join(", "Path(")}),
        python({"setup.py": PATHS.replace("import os\n", "").replace("os.path", "Path.path")}),
        python({"setup.py": SETUP_PY.replace(NAME, "")}),
        python({"setup.py": SETUP_PY.replace(NAME, "from setuptools import find_packages\n")}),
    ),
    "SET309": (
        python({"setup.py": SETUP_PY + "\n\ndef f():\n    return [1] (2)\n"}),
        python({"setup.py": SETUP_PY.replace("['package.xml']),", "['package.xml'] + ['a'] ['b']),")}),
        python(
            {"setup.py": SETUP_PY + "\nx = {1: 2} ['b'], 'a' [0], {1} (2), f'{x}' (3), 1 (2), 'a' ['b'], x ('a')\n"}
        ),
        *(
            python({"setup.py": setup_py(f"{name}=['my_pkg' 'other'],")})
            for name in ("py_modules", "scripts", "tests_require")
        ),
        python({"setup.py": SETUP_PY.replace("find_packages(exclude=['test'])", "['my_pkg' 'my_pkg.inner']")}),
        python({"setup.py": SETUP_PY.replace("license='Apache-2.0'", "licence='Apache-2.0', licens='x'")}),
        python({"setup.py": setup_py("scripts=['my_pkg/' 'talker'],"), "my_pkg/talker": ""}),
        python({"setup.py": setup_py("scripts=['my_pkg/' '+'],")}),
        python(
            {"setup.py": SETUP_PY + "\nnames = [NAME + '.a'.\n         NAME + '.b', 'x'.upper(), ('c')\n         .d]\n"}
        ),
    ),
    "SET311": (
        python(
            {
                "setup.py": SETUP_PY.replace(
                    TOOL, "['setuptools', 'numpy>=1.2', 'opencv-python', 'unknown-of-all', 'pip']"
                )
            }
        ),
        python({"setup.py": SETUP_PY.replace(TOOL, "['numpy; python_version < \"3\"']")}),
        python({"setup.py": SETUP_PY.replace(TOOL, "['numpy']"), "my_pkg/a.py": "import numpy\n"}),
        python({"setup.py": SETUP_PY.replace(TOOL, "['numpy']"), "package.xml": NUMPY}),
    ),
    "SET310": (
        python({"setup.py": setup_py("test_require=['pytest'],")}),
        python({"setup.py": setup_py("use_scm_version=True, summary='x',")}),
        python({"setup.py": setup_py("licence='MIT',")}),
        python({"setup.py": setup_py("console_scripts=['talker = my_pkg.talker:main'],")}),
        python({"setup.py": setup_py("gui_script=['talker = my_pkg.talker:main'],")}),
        python({"setup.py": setup_py("**{'entry_point': {'console_scripts': ['talker = my_pkg.talker:main']}},")}),
        python({"setup.py": setup_py(BOTH_GROUPS)}),
        python({"setup.py": setup_py("entry_points={'Console Scripts': ['talker = my_pkg.talker:main']},")}),
        python({"setup.py": setup_py("entry_points={'my_pkg.plugins': ['talker = my_pkg.talker:main']},")}),
        python(
            {"setup.cfg": SETUP_CFG + "[options.entry_points]\nconsole_script =\n    talker = my_pkg.talker:main\n"}
        ),
    ),
}
