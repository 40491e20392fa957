%
O01014
(Haas: a fourth axis that turns the part)
G21 G90 G00 X0. Y0. Z5.
A90.
G01 Z-1. F100.
M30
%
