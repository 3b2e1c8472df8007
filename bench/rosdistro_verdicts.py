"""Ask the real rosdistro which packages the distributions of an index release: `rosdistro_verdicts.py URL DISTRO…`.

Runs under a Python that has rosdistro; prints one JSON object, distribution to names.
"""

from __future__ import annotations

import json
import sys

import rosdistro

index = rosdistro.get_index(sys.argv[1])
print(
    json.dumps({name: sorted(rosdistro.get_distribution_file(index, name).release_packages) for name in sys.argv[2:]})
)
