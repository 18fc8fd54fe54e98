// The sphere of xml/jkr.xml near its lowest point, its meridian or a quarter of it: x and z outwards, y upwards, lengths
// in nm. The underside is the paraboloid y = gap + r^2/(2 radius).
DefineConstant[
  solid = 1,          // 0: the meridian
  radius = 1000,
  gap = 2.2547093,    // at the lowest point
  extent = 472.254, height = 402.254,  // of the part, as the map of xml/jkr.xml has it
  fine = 2, reach = 40,  // size of the cells up to this radius of the underside
  coarse = 80,
  growth = 0.4        // change of the size over the distance from there
];
SetFactory("OpenCASCADE");
n = 40;
For i In {0 : n}
  r = extent * (i / n)^2;
  Point(1 + i) = {r, gap + r^2 / (2 * radius), 0};
  Point(101 + i) = {r, gap + height + r^2 / (2 * radius), 0};
EndFor
Spline(1) = {1 : n + 1};
Line(2) = {n + 1, 101 + n};
Spline(3) = {101 + n : 101 : -1};
Line(4) = {101, 1};
Curve Loop(1) = {1 : 4};
Plane Surface(1) = {1};
If (solid)
  out[] = Extrude { {0, 1, 0}, {0, 0, 0}, -Pi / 2 } { Surface{1}; };
  Physical Volume("body") = {out[1]};
  Physical Surface("bottom") = {out[2]};
  Physical Surface("top") = {out[4]};
  Physical Surface("plane z") = {1};
  Physical Surface("plane x") = {out[0]};
Else
  Physical Surface("body") = {1};
  Physical Curve("bottom") = {1};
  Physical Curve("top") = {3};
EndIf

Field[1] = MathEval;
Field[1].F = Sprintf("%g + %g * Max(0, Sqrt(x*x + z*z + (y - %g)*(y - %g)) - %g)", fine, growth, gap, gap, reach);
Field[2] = MathEval;
Field[2].F = Sprintf("%g", coarse);
Field[3] = Min;
Field[3].FieldsList = {1, 2};
Background Field = 3;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
