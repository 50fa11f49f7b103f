#include "armtol/urdf/chain_check.h"

#include "console/message.h"

#include <ctype.h>
#include <math.h>
#include <string.h>

#define PI 3.14159265358979323846

static const urdf_joint *joint_at(const urdf_tree *tree, const urdf_chain *chain, size_t i)
{
    return &tree->joints[chain->joints[i]];
}

/* ---- what is wrong ---- */

static bool is_free(const urdf_joint *joint)
{
    return joint->type == URDF_PLANAR || joint->type == URDF_FLOATING;
}

/* A name as users may type it, in quotes where a shell would need them. */
static const char *typed(const char *name, quoted *quote)
{
    bool word = *name != '\0' && strlen(name) < sizeof quote->text;
    for (const char *c = name; *c != '\0'; c++) {
        word = word && (isalnum((unsigned char)*c) || strchr("_./-", *c) != NULL);
    }
    return word ? name : message_quote(name, quote);
}

/* An arm may begin below the last joint that is free. */
static bool refuse_free(const urdf_tree *tree, const urdf_chain *chain, const urdf_joint *joint)
{
    size_t last = chain->n_joints;
    for (size_t i = chain->n_up; i < chain->n_joints; i++) {
        last = is_free(joint_at(tree, chain, i)) ? i : last;
    }
    const bool below = last < chain->n_joints;
    file_message(&joint->place,
                 "joint %s is %s; an arm's joints are fixed, revolute, continuous or prismatic%s%s",
                 message_quote(joint->name, &(quoted){""}), urdf_joint_type_names[joint->type],
                 below ? "; begin below it, with --base " : "",
                 below ? typed(tree->links[joint_at(tree, chain, last)->child].name, &(quoted){""}) : "");
    return false;
}

static bool check_joint(const urdf_tree *tree, const urdf_chain *chain, const urdf_joint *joint)
{
    if (joint->fault != NULL) {
        file_message(&joint->fault_place, "%s", joint->fault);
        return false;
    }
    return !is_free(joint) || refuse_free(tree, chain, joint);
}

/* ---- what is improbable ---- */

static void warn_of_lengths(const urdf_tree *tree, const urdf_chain *chain)
{
    const double most = 100; /* metres: the largest cranes; a small arm in millimetres has more */
    double sum = 0;
    for (size_t i = 0; i < chain->n_joints; i++) {
        const double *p = joint_at(tree, chain, i)->xyz;
        sum += sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    }
    if (sum > most) {
        message("warning: %s: the joints are %.3g m apart all together; are these millimetres? A URDF has metres",
                tree->path, sum);
    }
}

static void warn_of_angles(const urdf_tree *tree, const urdf_chain *chain)
{
    for (size_t i = 0; i < chain->n_joints; i++) {
        const urdf_joint *const joint = joint_at(tree, chain, i);
        for (int k = 0; k < 3; k++) {
            if (fabs(joint->rpy[k]) > 2 * PI + 1e-3) {
                file_message(&joint->place,
                             "warning: joint %s has %g in its rpy; are these degrees? A URDF has radians",
                             message_quote(joint->name, &(quoted){""}), joint->rpy[k]);
                return;
            }
        }
    }
}

bool urdf_chain_check(const urdf_tree *tree, const urdf_chain *chain)
{
    bool fine = true;
    for (size_t i = 0; i < chain->n_joints && fine; i++) {
        fine = check_joint(tree, chain, joint_at(tree, chain, i));
    }
    return fine;
}

void urdf_chain_warn(const urdf_tree *tree, const urdf_chain *chain)
{
    warn_of_lengths(tree, chain);
    warn_of_angles(tree, chain);
}
