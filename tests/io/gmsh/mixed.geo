// Two cubes side by side: hexahedra, and tetrahedra behind the pyramids that gmsh puts between.
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 1, 1, 1};
Box(2) = {1, 0, 0, 1, 1, 1};
BooleanFragments{ Volume{1, 2}; Delete; }{}
Transfinite Curve{:} = 2;
Transfinite Surface{ Boundary{ Volume{1}; } };
Recombine Surface{ Boundary{ Volume{1}; } };
Transfinite Volume{1};
MeshSize{:} = 1;
Physical Volume("body") = {1, 2};
bottom() = Surface In BoundingBox{-0.1, -0.1, -0.1, 2.1, 1.1, 0.1};
Physical Surface("bottom") = {bottom()};
