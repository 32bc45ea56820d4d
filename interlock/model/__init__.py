"""The railway as facts: elements, layout, topology, traversals.  No YAML, no solver."""
