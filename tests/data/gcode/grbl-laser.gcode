; grbl: a laser burns at one height, which the program does not state
G21 G90
M4 S200
G0 X0 Y0
G1 X10 F1000
G1 Y10
M5
