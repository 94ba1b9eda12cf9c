"""`pelage farm`: draws frames on many machines, finds missing ones, and makes clips and contact sheets."""
