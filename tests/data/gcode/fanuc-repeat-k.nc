%
O5
(Fanuc: K repeats a cycle in increments)
G21 G90 G0 X0 Y0 Z2 S900 M3
G91 G99 G81 X10 Z-5 R0 K3 F80
G80
M30
%
