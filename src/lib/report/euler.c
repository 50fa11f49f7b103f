#include "armtol/euler.h"

#include "lib/report/arithmetic.h"
#include "lib/report/rows.h"
#include "lib/report/trigonometry.h"

#include <math.h>

armtol_transform armtol_pose_to_transform(const double pose[6], const armtol_errata *errata)
{
    const double cg = store(errata, cosine_of(errata, pose[3])), sg = store(errata, sine_of(errata, pose[3]));
    const double cb = store(errata, cosine_of(errata, pose[4])), sb = store(errata, sine_of(errata, pose[4]));
    const double ca = store(errata, cosine_of(errata, pose[5])), sa = store(errata, sine_of(errata, pose[5]));
    const double rows[3][4] = {
        {ca * cb, ca * sb * sg - sa * cg, ca * sb * cg + sa * sg, pose[0]},
        {sa * cb, sa * sb * sg + ca * cg, sa * sb * cg - ca * sg, pose[1]},
        {-sb, cb * sg, cb * cg, pose[2]},
    };
    return transform_of_rows(rows, errata);
}

void armtol_transform_to_pose(const armtol_transform *transform, const armtol_errata *errata, double pose[6])
{
    const double(*t)[4] = transform->m;
    for (int i = 0; i < 3; i++) {
        pose[i] = t[i][3];
    }
    pose[3] = store(errata, angle_of(errata, t[2][1], t[2][2]));
    pose[4] = store(errata, angle_of(errata, -t[2][0], sqrt(t[0][0] * t[0][0] + t[1][0] * t[1][0])));
    pose[5] = store(errata, angle_of(errata, t[1][0], t[0][0]));
}
