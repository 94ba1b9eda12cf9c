"""`pelage farm`: frames on many machines, what is missing of them, and clips and contact sheets of what is there."""
