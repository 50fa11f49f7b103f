/*
 * kinematic2.h -- the error model: transforms in Paul's order, the matrices G of a link and J of a transform
 *
 * The listing's routines, the listing's names and order; the comments are ours: see README.md. The slips are the
 * listing's and stay.
 */

#include <stdio.h>
#include <math.h>

/*
 * [ours unset] Stands before what the programs read without having set it: empty, so that memory decides as it
 * did in 1987, or static, so that it is zero and the program is well defined.
 */
#ifndef UNSET
#define UNSET
#endif
/* [ours show] With show.h: keeps a copy of what stood on the diagonal. */
#ifndef SHOW
#define SHOW(matrix)
#endif

/* [printed] out = Rot(z, ktheta) Trans(ka, 0, kd) Rot(x, kalpha) Rot(y, kbeta), but for the slip in [1][2] */
mtransf(ka,kalpha,kd,ktheta,kbeta,out)
double ka,		/* [forced formals] printed as float, down to kbeta */
	kalpha,
	kd,
	ktheta,
	kbeta;
float out[4][4];
{
	float n1,
		n2,
		n3,
		n4,
		n5,
		n6;

	n1 = cos(kalpha);
	n2 = sin(kalpha);
	n3 = cos(ktheta);
	n4 = sin(ktheta);
	n5 = cos(kbeta);
	n6 = sin(kbeta);
	out[0][0] = (double)n3*n5 - (double)n4*n2*n6;	/* [forced cast] here and in the three like it */
	out[0][1] = -n4*n1;
	out[0][2] = (double)n3*n6 + (double)n4*n2*n5;
	out[0][3] = ka*n3;
	out[1][0] = (double)n4*n5 + (double)n3*n2*n6;
	out[1][1] = n3*n1;
	out[1][2] = (double)n4*n6 - (double)n4*n2*n5;
	out[1][3] = ka*n4;
	out[2][0] = -n1*n6;
	out[2][1] = n2;
	out[2][2] = n1*n5;
	out[2][3] = kd;
	out[3][0] = 0;
	out[3][1] = 0;
	out[3][2] = 0;
	out[3][3] = 1;
}

/* [printed] G of a non-parallel revolute joint: theta, d, a, alpha */
gnpr(ka,kalpha,out)
double ka,		/* [forced formals] printed as float, down to kalpha */
	kalpha;
float out[6][4];
{
	float n1,
		n2;
	register int i,		/* [forced register] printed as int i, j */
		j;

	n1 = cos(kalpha);
	n2 = sin(kalpha);
	for(i=0;i<6;i++){
		for(j=0;j<4;j++){
			out[i][j] = 0.;
		}
	}
	out[0][2] = 1.;
	out[1][0] = ka*n1;
	out[1][1] = n2;
	out[2][0] = -ka*n2;
	out[2][1] = n1;
	out[3][3] = 1.;
	out[4][0] = n2;
	out[5][0] = n1;
}

/* [printed] G of a non-parallel prismatic joint: theta, d, alpha; called by neither program */
gnpp(kalpha,out)
double kalpha;		/* [forced formals] printed as float */
float out[6][3];
{
	float n1,
		n2;
	int i,
		j;

	n1 = cos(kalpha);
	n2 = sin(kalpha);
	for(i=0;i<6;i++){
		for(j=0;j<3;j++){
			out[i][j] = 0.;
		}
	}
	out[1][1] = n2;
	out[2][1] = n1;
	out[3][2] = 1.;
	out[4][0] = n2;
	out[5][0] = n1;
}

/* [printed] G of a parallel or nearly parallel revolute joint: theta, a, alpha, beta. kd stands where a belongs. */
gppr(kalpha,kd,kbeta,out)
double kalpha,		/* [forced formals] printed as float, down to kbeta */
	kd,
	kbeta;
float out[6][4];
{
	float n1,
		n2,
		n3,
		n4;
	int i,
		j;

	n1 = cos(kalpha);
	n2 = sin(kalpha);
	n3 = cos(kbeta);
	n4 = sin(kbeta);
	for(i=0;i<6;i++){
		for(j=0;j<4;j++){
			out[i][j] = 0.;
		}
	}
	out[0][0] = -kd*n2*n4;
	out[0][1] = n3;
	out[1][0] = kd*n1;
	out[2][0] = -kd*n2*n3;
	out[2][1] = -n4;
	out[3][0] = n1*n4;
	out[3][2] = n3;
	out[4][0] = n2;
	out[4][3] = -1.;
	out[5][0] = n1*n3;
	out[5][2] = -n4;
}

/*
 * [printed] G of a parallel or nearly parallel prismatic joint: d, theta, a, alpha, beta. kalpha stands where ka
 * belongs. Columns 3 and 4 are not cleared: but for the three elements set below they keep what out held.
 */
gppp(ka,kalpha,kbeta,out)
double ka,		/* [forced formals] printed as float, down to kbeta */
	kalpha,
	kbeta;
float out[6][5];
{
	float n1,
		n2,
		n3,
		n4;
	int i,
		j;

	n1 = cos(kalpha);
	n2 = sin(kalpha);
	n3 = cos(kbeta);
	n4 = sin(kbeta);
	for(i=0;i<6;i++){
		for(j=0;j<3;j++){	/* [reading clearing] */
			out[i][j] = 0.;
		}
	}
	out[0][0] = n1*n4;
	out[0][1] = -kalpha*n2*n4;
	out[0][2] = n3;
	out[1][0] = n2;
	out[1][1] = kalpha*n1;
	out[2][0] = n1*n3;
	out[2][1] = -kalpha*n2*n3;
	out[2][2] = -n4;
	out[3][1] = n1*n4;
	out[3][3] = n3;
	out[4][1] = n2;
	out[4][4] = -1.;
	out[5][1] = n1*n3;
	out[5][3] = -n4;
}

/* [printed] J = [R, S R; 0, R] of the transform in = [R, p], S the skew matrix of p. S's diagonal is never set. */
getj(in,out)
float in[4][4],
	out[6][6];
{
	UNSET float skew[3][3],		/* [ours unset] */
		rot[3][3],
		temp[3][3];
	register int i,		/* [forced register] printed as int i, j */
		j;

	for(i=0;i<6;i++){
		for(j=0;j<6;j++){
			out[i][j] = 0;
		}
	}
	for(i=0;i<3;i++){
		for(j=0;j<3;j++){
			rot[i][j] = in[i][j];
			out[i][j] = rot[i][j];
			out[3+i][3+j] = rot[i][j];
		}
	}
	skew[0][1] = -in[2][3];
	skew[0][2] = in[1][3];
	skew[1][0] = in[2][3];
	skew[1][2] = -in[0][3];
	skew[2][0] = -in[1][3];
	skew[2][1] = in[0][3];
	SHOW(skew)		/* [ours show] */
	mpy333(skew,rot,temp);
	for(i=0;i<3;i++){
		for(j=0;j<3;j++){
			out[i][3+j] = temp[i][j];
		}
	}
}
