"""The way to the railway: point telegrams, and the runtime as a soft PLC on a field bus."""
