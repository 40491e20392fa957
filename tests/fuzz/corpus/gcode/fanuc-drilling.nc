%
O4 (HOLES)
(Fanuc: drilling; the last hole returns to the initial level)
G21 G17 G40 G49 G80 G90 G94
T3 M6
G0 X0 Y0 S1200 M3
G43 Z20 H3
G99 G81 X10 Z-2 R2 F100
X20
G98 X30
G80
G0 Z20
G91 G28 Z0
M30
%
