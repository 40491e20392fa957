%
O10
(Fanuc: five axes with control of the tool centre point)
G21 G90 G0 X0 Y0 Z100
G43.4 H1 Z50
M30
%
