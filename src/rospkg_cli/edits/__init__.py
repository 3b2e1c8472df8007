"""Changes to files as spans and texts, for fixes and for `rospkg new`."""
