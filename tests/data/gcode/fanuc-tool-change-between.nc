%
O3 (two tools)
(Fanuc: the spindle goes home for the tool change and comes back)
G21 G17 G40 G80 G90 T1 M6
G54 G0 X0 Y0 S1500 M3
G43 Z10 H1
G1 Z-1 F100
X10
G91 G28 Z0 M5
T2 M6
G90 G0 X30 Y0 S2500 M3
G43 Z10 H2
G1 Z-3 F120
Y10
G0 Z10
M30
%
