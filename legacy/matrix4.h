/*
 * matrix4.h -- products of matrices: 4 x 4, 4 x 1, and the 6 x n of the error model
 *
 * The listing's routines, the listing's names and order; the comments are ours. What [printed], [reading],
 * [forced] and [ours] mean, here and in the other files, is said in README.md.
 */

#include <stdio.h>
#define NN 4

/* [printed] out = in1 in2, NN x NN. out is cleared as a whole first, so it may be neither in1 nor in2. */
mpynn(in1,in2,out)
float in1[NN][NN],
	in2[NN][NN],
	out[NN][NN];
{
	int i,
		j,
		n;

	for(i=0;i<NN;i++){
		for(j=0;j<NN;j++){
			out[i][j] = 0.;
		}
	}
	for(i=0;i<NN;i++){
		for(j=0;j<NN;j++){
			for(n=0;n<NN;n++){
				out[i][j] += (double)in1[i][n]*in2[n][j];	/* [forced cast] */
			}
		}
	}
}

/* [printed] out = in1 in2, NN x NN by a column; called by neither program */
mpyn1(in1,in2,out)
float in1[NN][NN],
	in2[NN],
	out[NN];
{
	int i,
		j;

	for(i=0;i<NN;i++){
		out[i] = 0.;
	}
	for(i=0;i<NN;i++){
		for(j=0;j<NN;j++){
			out[i] += (double)in1[i][j]*in2[j];	/* [forced cast] */
		}
	}
}

/* [printed] out = in1 in2, 6 x 6 by 6 x 6 */
mpy666(in1,in2,out)
float in1[6][6],
	in2[6][6],
	out[6][6];
{
	int i,
		j,
		n;

	for(i=0;i<6;i++){
		for(j=0;j<6;j++){
			out[i][j] = 0.;
		}
	}
	for(i=0;i<6;i++){
		for(j=0;j<6;j++){
			for(n=0;n<6;n++){
				out[i][j] += (double)in1[i][n]*in2[n][j];	/* [forced cast] */
			}
		}
	}
}

/* [printed] out = in1 in2, 6 x 6 by 6 x 4 */
mpy664(in1,in2,out)
float in1[6][6],
	in2[6][4],
	out[6][4];
{
	int i,
		j,
		n;

	for(i=0;i<6;i++){
		for(j=0;j<4;j++){
			out[i][j] = 0.;
		}
	}
	for(i=0;i<6;i++){
		for(j=0;j<4;j++){
			for(n=0;n<6;n++){
				out[i][j] += (double)in1[i][n]*in2[n][j];	/* [forced cast] */
			}
		}
	}
}

/* [printed] out = in1 in2, 6 x 6 by 6 x 5 */
mpy665(in1,in2,out)
float in1[6][6],
	in2[6][5],
	out[6][5];
{
	int i,
		j,
		n;

	for(i=0;i<6;i++){
		for(j=0;j<5;j++){
			out[i][j] = 0.;
		}
	}
	for(i=0;i<6;i++){
		for(j=0;j<5;j++){
			for(n=0;n<6;n++){
				out[i][j] += (double)in1[i][n]*in2[n][j];	/* [forced cast] */
			}
		}
	}
}

/* [printed] out = in1 in2, 6 x 6 by 6 x 3; called by neither program */
mpy663(in1,in2,out)
float in1[6][6],
	in2[6][3],
	out[6][3];
{
	int i,
		j,
		n;

	for(i=0;i<6;i++){
		for(j=0;j<3;j++){
			out[i][j] = 0.;
		}
	}
	for(i=0;i<6;i++){
		for(j=0;j<3;j++){
			for(n=0;n<6;n++){
				out[i][j] += (double)in1[i][n]*in2[n][j];	/* [forced cast] */
			}
		}
	}
}

/* [printed] out = in1 in2, 3 x 3 by 3 x 3 */
mpy333(in1,in2,out)
float in1[3][3],
	in2[3][3],
	out[3][3];
{
	int i,
		j,
		n;

	for(i=0;i<3;i++){
		for(j=0;j<3;j++){
			out[i][j] = 0.;
		}
	}
	for(i=0;i<3;i++){
		for(j=0;j<3;j++){
			for(n=0;n<3;n++){
				out[i][j] += (double)in1[i][n]*in2[n][j];	/* [forced cast] */
			}
		}
	}
}
