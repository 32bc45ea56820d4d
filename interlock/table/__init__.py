"""The interlocking table: one row per route; every derived cell carries its reason."""
