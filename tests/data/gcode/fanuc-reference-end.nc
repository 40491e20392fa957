O0002
(Fanuc: reference returns at the start and at the end)
G91 G28 Z0.
G21 G90 G54
G0 X0. Y0. S2000 M3
G43 H1 Z10.
Z1.
G1 Z-2. F150.
X20. F500.
G0 Z10.
G91 G28 Z0.
G28 X0. Y0.
M30
