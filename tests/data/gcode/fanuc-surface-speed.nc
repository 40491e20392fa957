O6
(a control that cuts at a constant surface speed, then at a spindle speed)
G96 S120 M3
G21 G90 G0 X0 Y0 Z5
G1 Z-1 F100
G97 S2000
X10
M30
