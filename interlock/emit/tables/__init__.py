"""The interlocking table as JSON, CSV, XLSX and HTML."""
