; grbl: touches off before it cuts
G21 G90
G0 X0 Y0 Z5
G38.2 Z-10 F50
