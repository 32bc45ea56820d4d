"""The mimic panel (document B, 1.3 and 2.1): the plan in a browser, on the proved runtime.

The server holds the truth and tells it to every browser; what a browser asks for is an operator's input to the proved
runtime, which refuses what is not safe.  The panel itself decides nothing about safety.
"""
