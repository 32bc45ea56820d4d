"""Train dispatching planned: problems, plans by rules, by local search and by OR-tools CP-SAT, and what checks them.

Trains, sections and times alone; it knows no layout, table or controller.
"""
