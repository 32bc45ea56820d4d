"""Runs on controller and plant: every route, what an operator may do, routes used together."""
