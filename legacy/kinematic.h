/*
 * kinematic.h -- transforms in Craig's order, their inverse, Euler angles, and the equation that the inverse
 * kinematics solves
 *
 * The listing's routines, the listing's names and order; the comments are ours: see README.md.
 */

#include <stdio.h>
#include <math.h>

#include "matrix4.h"

/* [printed] out = Rot(x, kalpha) Trans(ka, 0, 0) Rot(z, ktheta) Trans(0, 0, kd) */
transf(ka,kalpha,kd,ktheta,out)
double ka,		/* [forced formals] printed as float, down to ktheta */
	kalpha,
	kd,
	ktheta;
float out[4][4];
{
	float n1,
		n2,
		n3,
		n4;

	n1 = sin(kalpha);
	n2 = cos(kalpha);
	n3 = sin(ktheta);
	n4 = cos(ktheta);
	out[0][0] = n4;
	out[0][1] = -n3;
	out[0][2] = 0;
	out[0][3] = ka;
	out[1][0] = n3*n2;
	out[1][1] = n4*n2;
	out[1][2] = -n1;
	out[1][3] = -n1*kd;
	out[2][0] = n3*n1;
	out[2][1] = n4*n1;
	out[2][2] = n2;
	out[2][3] = n2*kd;
	out[3][0] = 0;
	out[3][1] = 0;
	out[3][2] = 0;
	out[3][3] = 1;
}

/* [printed] tout = the inverse of tin: [R' , -R' p] of [R, p] */
invtrf(tin,tout)
float tin[4][4],
	tout[4][4];
{
	int i,
		j;

	for(i=0;i<4;i++){
		for(j=0;j<4;j++){
			tout[i][j] = 0.;
		}
	}
	for(i=0;i<3;i++){
		for(j=0;j<3;j++){
			tout[i][j] = tin[j][i];
		}
		tout[3][i] = 0.;
	}
	for(i=0;i<3;i++){
		for(j=0;j<3;j++){
			tout[i][3] += (double)(-tout[i][j])*tin[j][3];	/* [forced cast] */
		}
	}
	tout[3][3] = 1.;
}

/* [printed] x = the position of t and its angles gamma, beta, alpha: R = Rot(z, alpha) Rot(y, beta) Rot(x, gamma) */
geulerzyx(t,x)
float t[4][4],
	x[6];
{
	x[0] = t[0][3];
	x[1] = t[1][3];
	x[2] = t[2][3];
	x[3] = atan2(t[2][1],t[2][2]);
	/* [reading sign] [forced cast] */
	x[4] = atan2(-t[2][0],sqrt((double)t[0][0]*t[0][0] + (double)t[1][0]*t[1][0]));
	x[5] = atan2(t[1][0],t[0][0]);
}

/* [printed] t = the transform of the six numbers that geulerzyx gives */
eulerzyx(x,t)
float x[6],
	t[4][4];
{
	float cg,
		sg,
		cb,
		sb,
		ca,
		sa;

	cg = cos(x[3]);
	sg = sin(x[3]);
	cb = cos(x[4]);
	sb = sin(x[4]);
	ca = cos(x[5]);
	sa = sin(x[5]);
	t[0][0] = ca*cb;
	t[0][1] = (double)ca*sb*sg - (double)sa*cg;	/* [forced cast] here and in the three like it */
	t[0][2] = (double)ca*sb*cg + (double)sa*sg;
	t[0][3] = x[0];
	t[1][0] = sa*cb;
	t[1][1] = (double)sa*sb*sg + (double)ca*cg;
	t[1][2] = (double)sa*sb*cg - (double)ca*sg;
	t[1][3] = x[1];
	t[2][0] = -sb;
	t[2][1] = cb*sg;
	t[2][2] = cb*cg;
	t[2][3] = x[2];
	t[3][0] = 0.;
	t[3][1] = 0.;
	t[3][2] = 0.;
	t[3][3] = 1.;
}

/*
 * [printed] *theta = the angle with px cos(theta) + py sin(theta) = d, of the two the one closer to tclose, of
 * two equally close the first. t1 is set and never used.
 */
solve(px,py,d,tclose,theta)
double px,		/* [forced formals] printed as float, down to tclose */
	py,
	d,
	tclose;
float *theta;
{
	float theta1,
		theta2,
		t1,
		sq,
		dist1,
		dist2;

	if(d == 0.)
	{
		*theta = atan2(px,(-py));
	}
	else
	{
		t1 = atan2(px,(-py));
		sq = sqrt(py*py + px*px - d*d);
		theta1 = atan2(px,(-py)) - atan2(d,sq);
		theta2 = atan2(px,(-py)) - atan2(d,(-sq));
		dist1 = (tclose - theta1)*(tclose - theta1);
		dist2 = (tclose - theta2)*(tclose - theta2);
		if(dist1 <= dist2 )
		{
			*theta = theta1;
		}
		else
		{
			*theta = theta2;
		}
	}
}
