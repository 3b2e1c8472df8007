"""`rospkg server`: findings, fixes and lookups in editors, by the Language Server Protocol."""
