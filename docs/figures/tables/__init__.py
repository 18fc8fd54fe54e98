"""The tables, a module for each page. The list TABLES of a module has its tables."""
