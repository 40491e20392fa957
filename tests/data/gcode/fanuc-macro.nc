%
O8
(Fanuc: macro variables)
G21 G90
#100=10.
G0 X#100 Y0 Z5
M30
%
