"""The emitted texts against the controller: Structured Text, the runtime, the mapping program, telegrams."""
