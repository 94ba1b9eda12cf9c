"""Makes modules of the package from the contract; not part of the wheel."""
