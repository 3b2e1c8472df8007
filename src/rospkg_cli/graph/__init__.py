"""The packages of a workspace as a graph: what depends on what, and what launch files start."""
