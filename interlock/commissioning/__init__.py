"""The tests by which an installation is commissioned: wires, routes, losses and times, tried on a bench before they are
written.

What has to come is read from the interlocking table; whether it comes is tried on the emitted runtime.  Neither knows
an equation of the controller.
"""
