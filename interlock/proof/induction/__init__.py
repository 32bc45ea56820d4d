"""Base, step, dropping, and the search for a run where a claim does not follow; what is said of both."""
