%
O7
(Fanuc: a call of a subprogram)
G21 G90 G0 X0 Y0 Z5
M98 P1000
M30
%
