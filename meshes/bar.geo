// A square bar, clamped at its lower end and twisted at its upper one. Lengths in mm.
DefineConstant[
  divisions = 3,   // across, if structured; four times as many along
  structured = 1,  // 0: cells of the size that the scene asks for
  tetrahedra = 0   // 1: tetrahedra in place of hexahedra
];

Point(1) = {-0.5, -0.5, 0};
Point(2) = {0.5, -0.5, 0};
Point(3) = {0.5, 0.5, 0};
Point(4) = {-0.5, 0.5, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1 : 4};
Plane Surface(1) = {1};
If (structured)
  Transfinite Curve {1 : 4} = divisions + 1;
  Transfinite Surface {1};
EndIf
If (tetrahedra)
  solid[] = Extrude {0, 0, 4} { Surface{1}; };
  If (structured)
    Transfinite Curve {6, 7, 8, 9} = divisions + 1;
    Transfinite Curve {11, 12, 16, 20} = 4 * divisions + 1;
    Transfinite Surface {:};
    Transfinite Volume {solid[1]};
  EndIf
Else
  Recombine Surface {1};
  solid[] = Extrude {0, 0, 4} { Surface{1}; Layers{4 * divisions}; Recombine; };
EndIf

Physical Volume("bar") = {solid[1]};
Physical Surface("clamped") = {1};
Physical Surface("twisted") = {solid[0]};
