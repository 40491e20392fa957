%
O9
(Fanuc: back boring moves an oriented tool sideways through the hole)
G21 G90 G0 X0 Y0 Z5 S300 M3
G87 X0 Y0 Z-10 R-20 Q1 F50
M30
%
