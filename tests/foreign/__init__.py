"""Foreign compilers against the emitted runtime: what is recorded, how a compiled text is driven, what is compared.

A layout's trains run on the emitted Python runtime in its cabinet (`interlock.field.plc.SoftPlc`); each scan's inputs
are laid down as they stand on the wires (%I bits, what the operator's place writes, the time that has passed) with the
outputs that must follow (%Q bits, what the operator's place reads).  Then the emitted Structured Text with its mapping
program, compiled by somebody else's compiler, gets the same inputs, and has to give the same outputs in every scan.
"""
