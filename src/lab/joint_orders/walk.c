#include "lab/joint_orders/walk.h"

#include <stdlib.h>

bool walk_start(walk *walk, const family *family, const double wishes[][MOST_WISH], size_t n_wishes)
{
    *walk = (struct walk){.family = family, .wishes = wishes, .n_wishes = n_wishes};
    walk->found = malloc(n_wishes * family->n_steps * sizeof *walk->found);
    return walk->found != NULL;
}

void walk_free(walk *walk)
{
    free(walk->found);
    walk->found = NULL;
}

static size_t first_step_to_do(const walk *walk, const configuration *to)
{
    size_t first = walk->started ? walk->family->n_steps : 0;
    for (size_t i = 0; i < walk->family->n_choices; i++) {
        const size_t step = walk->family->choices[i].step;
        if (to->option[i] != walk->at.option[i] && step < first) {
            first = step;
        }
    }
    return first;
}

void walk_to(walk *walk, const configuration *configuration)
{
    const size_t n_steps = walk->family->n_steps, first = first_step_to_do(walk, configuration);
    for (size_t i = 0; i < walk->n_wishes; i++) {
        progress *found = &walk->found[i * n_steps];
        for (size_t s = first; s < n_steps; s++) {
            if (s > 0) {
                found[s] = found[s - 1];
            }
            walk->family->steps[s](configuration, walk->wishes[i], &found[s]);
        }
    }
    walk->at = *configuration;
    walk->started = true;
}

const double *walk_joints(const walk *walk, size_t wish)
{
    return walk->found[(wish + 1) * walk->family->n_steps - 1].q;
}
