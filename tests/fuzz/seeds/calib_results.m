% Intrinsic and Extrinsic Camera Parameters
%
% fc = [ 1 ; 1 ];   in a comment

%-- Focal length:
fc = [ 657.500000000000000 ; 658.250000000000000 ];

%-- Principal point:
cc = [ 303.250000000000000 ; 242.500000000000000 ];

%-- Skew coefficient:
alpha_c = 0.004000000000000;

%-- Distortion coefficients:
kc = [ -0.256000000000000 ; 0.130000000000000 ; -0.000200000000000 ; 3.5e-05 ; +0.010000000000000 ];

%-- Focal length uncertainty:
fc_error = [ 0.3 ; 0.4 ];

%-- Image size:
nx = 640;
ny = 480;

%-- Various other variables (may be ignored if you do not use the Matlab Calibration Toolbox):
n_ima = 1;)"
                                                       "\t\t"
                                                       R"(% Number of calibration images
est_dist = [ 1 ; 1 ; 1 ; 1 ; 0 ];

omc_1 = [ NaN ; NaN ; NaN ];
