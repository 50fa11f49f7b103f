#include "armtol/against/against.h"

#include "armtol/names/link_name.h"
#include "armtol/tell/json_arms.h"

#include <math.h>
#include <stdio.h>

/* docs/json.md describes what is written here; names and meanings stay, new ones may come. */

static void write_error(json *json, const units *units, const char *name, const double error[6])
{
    double shown[6];
    for (size_t i = 0; i < 6; i++) {
        shown[i] = units_shown(units, i < 3, error[i]);
    }
    json_numbers(json, name, shown, 6);
}

static void write_sizes(json *json, const units *units, const double sizes[2])
{
    json_number(json, "distance", units_shown(units, true, sizes[0]));
    json_number(json, "angle", units_shown(units, false, sizes[1]));
}

static void write_name(json *json, const armtol_arm *arm, const armtol_difference *difference)
{
    json_count(json, "link", difference->link);
    json_text_if(json, "name", link_name(arm, difference->link));
    json_text(json, "parameter", armtol_parameter_name(difference->parameter));
}

static void write_poses(json *json, against *against)
{
    const units *units = &against->request->units;
    json_open_array(json, "poses");
    for (size_t pose = 0; pose < against->request->question.n_poses; pose++) {
        double error[6];
        against_pose(against, pose, error);
        json_open_object(json, NULL);
        write_error(json, units, "error", error);
        write_sizes(json, units, against_size_of(error).size);
        json_open_array(json, "explained");
        for (size_t k = 0; k < against->n_differences; k++) {
            json_open_object(json, NULL);
            write_name(json, &against->request->arm, &against->differences[k]);
            write_error(json, units, "error", against->explained + 6 * k);
            json_close_object(json);
        }
        json_close_array(json);
        json_close_object(json);
    }
    json_close_array(json);
}

static void write_shares(json *json, const double shares[2])
{
    json_known(json, "of_distance", shares[0]);
    json_known(json, "of_angle", shares[1]);
}

static void write_differences(json *json, const against *against, const against_summary *summary)
{
    const units *units = &against->request->units;
    json_open_array(json, "differences");
    for (size_t k = 0; k < against->n_differences; k++) {
        const against_share *share = &summary->shares[k];
        const armtol_difference *difference = &against->differences[share->difference];
        const bool is_length = armtol_parameter_is_length(difference->parameter);
        json_open_object(json, NULL);
        write_name(json, &against->request->arm, difference);
        json_number(json, "difference", units_shown(units, is_length, difference->value));
        json_text(json, "unit", units_name(units, is_length));
        write_sizes(json, units, share->largest);
        write_shares(json, share->share);
        json_close_object(json);
    }
    json_close_array(json);
    json_open_object(json, "together");
    write_shares(json, summary->together);
    json_close_object(json);
}

static void write_summary(json *json, const units *units, const against_summary *summary)
{
    json_open_object(json, "mean");
    write_sizes(json, units, summary->mean);
    json_close_object(json);
    json_open_object(json, "largest");
    write_sizes(json, units, summary->largest);
    json_count(json, "pose_of_distance", summary->worst[0] + 1);
    json_count(json, "pose_of_angle", summary->worst[1] + 1);
    json_close_object(json);
}

void against_json(against *against, const against_summary *summary)
{
    const units *units = &against->request->units;
    json json;
    json_start(&json, stdout);
    json_text(&json, "arm", against->request->arm.name);
    json_text(&json, against->request->options->against != NULL ? "against" : "deviations", against->other);
    json_units(&json, units);
    write_poses(&json, against);
    write_summary(&json, units, summary);
    write_differences(&json, against, summary);
    json_end(&json);
}
