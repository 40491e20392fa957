%
(modes, and nothing that moves)
G21 G90 G17
M30
%
