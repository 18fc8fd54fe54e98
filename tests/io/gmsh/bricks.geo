// A cube of 2 x 2 x 2 cells.
Point(1) = {0, 0, 0};
line[] = Extrude {1, 0, 0} { Point{1}; Layers{2}; };
face[] = Extrude {0, 1, 0} { Curve{line[1]}; Layers{2}; Recombine; };
body[] = Extrude {0, 0, 1} { Surface{face[1]}; Layers{2}; Recombine; };
Physical Volume("block") = {body[1]};
Physical Surface("bottom") = {face[1]};
Physical Surface("top") = {body[0]};
Physical Curve("edge") = {line[1]};
Physical Point("corner") = {1};
