"""Dollar signs that a shell, an environment or the loader reads (CMK126)."""

from __future__ import annotations

from .idioms_of_cmake import package

CASES = {
    "CMK126": (
        package('set(PLACE a)\nadd_test(NAME a COMMAND sh -c "echo $PLACE")\n', {}),
        package('set(PLACE a)\nset_tests_properties(a PROPERTIES ENVIRONMENT "A=$PLACE")\n', {}),
        package('set(LIB a)\nset(CMAKE_INSTALL_RPATH "$ORIGIN/../$LIB")\n', {}),
        package('set(PLACE a)\nset(CMAKE_INSTALL_RPATH "$ORIGIN/../$PLACE")\n', {}),
    ),
}
