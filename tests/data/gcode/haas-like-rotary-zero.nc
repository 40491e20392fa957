%
O01013
(Haas: a fourth axis that stays at 0)
G21 G90 G17 G00 A0.
X0. Y0. Z5. A0.
G01 Z-1. F100.
X10. A0. F300.
M30
%
