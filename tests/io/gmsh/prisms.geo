// A square of triangles, extruded: prisms.
SetFactory("OpenCASCADE");
Rectangle(1) = {0, 0, 0, 1, 1};
Extrude {0, 0, 1} { Surface{1}; Layers{1}; Recombine; }
MeshSize{:} = 1;
Physical Volume("body") = {1};
