%
O01010 (Haas like)
(Haas: the tool goes up in machine coordinates before the first move)
G00 G53 Z0. ; machine zero
G20 G90 G17 G40 G80
T1 M06
G00 G54 X0. Y0. S4000 M03
G43 H01 Z0.1 M08
G01 Z-0.05 F10.
Y2.
G00 Z0.1
M30
%
