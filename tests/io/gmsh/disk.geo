// A disk of triangles of second order, whose rim is round.
SetFactory("OpenCASCADE");
Disk(1) = {0, 0, 0, 1};
MeshSize{:} = 0.7;
Physical Surface("body") = {1};
Physical Curve("rim") = {1};
