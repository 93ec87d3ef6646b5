// Two quarter rings, 20 ... 40.02 and 40 ... 70, meshed apart: the inner one is too large by 0.02.
// gmsh -2 -format msh41 rings.geo
Mesh.ElementOrder = 2;
Mesh.SecondOrderIncomplete = 1;
Mesh.HighOrderOptimize = 0;
Point(1) = {0, 0, 0};

Point(11) = {0, -20, 0};
Point(12) = {0, -40.02, 0};
Point(13) = {40.02, 0, 0};
Point(14) = {20, 0, 0};
Line(11) = {11, 12};
Circle(12) = {12, 1, 13};
Line(13) = {13, 14};
Circle(14) = {14, 1, 11};
Curve Loop(1) = {11, 12, 13, 14};
Plane Surface(1) = {1};
Transfinite Curve {12, 14} = 20;
Transfinite Curve {11, 13} = 8;
Transfinite Surface {1};
Recombine Surface {1};

Point(21) = {0, -40, 0};
Point(22) = {0, -70, 0};
Point(23) = {70, 0, 0};
Point(24) = {40, 0, 0};
Line(21) = {21, 22};
Circle(22) = {22, 1, 23};
Line(23) = {23, 24};
Circle(24) = {24, 1, 21};
Curve Loop(2) = {21, 22, 23, 24};
Plane Surface(2) = {2};
Transfinite Curve {22, 24} = 14;
Transfinite Curve {21, 23} = 9;
Transfinite Surface {2};
Recombine Surface {2};

Physical Surface("inner") = {1};
Physical Surface("outer") = {2};
Physical Curve("inner start") = {11};
Physical Curve("inner end") = {13};
Physical Curve("fit inside") = {12};
Physical Curve("outer start") = {21};
Physical Curve("outer end") = {23};
Physical Curve("fit outside") = {24};
