#include "lib/arrivals/sources.h"

#include "lib/engine/drives.h"

#include <math.h>
#include <string.h>

static const armtol_drive_arrival *arrival_of(const armtol_answer *answer, size_t pose, size_t link)
{
    return &answer->arrivals[pose * answer->n_links + link];
}

size_t arrival_sources_of(const armtol_answer *answer, size_t pose, arrival_source sources[])
{
    const double *matrix = armtol_answer_matrix(answer, pose);
    size_t n = 0;
    for (size_t link = 0; link < answer->n_links; link++) {
        const armtol_drive_arrival *off = arrival_of(answer, pose, link);
        if (armtol_drive_arrival_half(off) > 0) {
            const size_t k = answer_motor_column(answer, link);
            sources[n] = (arrival_source){.off = *off, .link = link};
            for (size_t i = 0; i < 3; i++) {
                sources[n].way[i] = matrix[i * answer->n_columns + k];
            }
            n++;
        }
    }
    return n;
}

void arrival_sources_making(const armtol_answer *answer, size_t pose, double tolerances[])
{
    memcpy(tolerances, armtol_answer_bounded(answer, pose), answer->n_columns * sizeof *tolerances);
    for (size_t link = 0; link < answer->n_links; link++) {
        const double half = armtol_drive_arrival_half(arrival_of(answer, pose, link));
        if (half > 0) { /* nothing is left of a tolerance that has no bound, and counts as exact */
            double *tolerance = &tolerances[answer_motor_column(answer, link)];
            *tolerance = fmax(*tolerance - half, 0);
        }
    }
}
