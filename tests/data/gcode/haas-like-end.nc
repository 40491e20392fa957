%
O01011
(Haas: the end of a program goes to machine positions)
G21 G90 G17
G00 X0. Y0. Z6.
G01 Z-1. F200.
X20.
G00 Z6.
G53 G00 Z0. M09
G53 X-300. Y0.
M30
%
