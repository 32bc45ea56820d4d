"""The C runtime: one C99 file with its header, for controllers that have a C compiler and no Structured Text."""
