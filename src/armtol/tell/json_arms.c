#include "armtol/tell/json_arms.h"

#include "armtol/armtol.h"
#include "armtol/names/link_name.h"
#include "armtol/tables/arm_table.h"
#include "armtol/tell/laying.h"

#include <math.h>
#include <stdio.h>

/* docs/json.md describes what is written here. */

void json_arm_texts(json *json, const armtol_arm *arm)
{
    json_text(json, "name", arm->name);
    json_text(json, "title", arm->title);
    json_text(json, "source", arm->source);
}

void json_units(json *json, const units *units)
{
    json_open_object(json, "units");
    json_text(json, "length", units_name(units, true));
    json_text(json, "angle", units_name(units, false));
    json_close_object(json);
}

void json_joint_names(json *json, const armtol_arm *arm)
{
    if (!links_have_names(arm)) {
        return;
    }
    json_open_array(json, "joint_names");
    for (size_t i = 0; i < arm->n_links; i++) {
        if (armtol_arm_is_driven(arm, i)) {
            json_text(json, NULL, link_name(arm, i) != NULL ? link_name(arm, i) : "");
        }
    }
    json_close_array(json);
}

void json_list(void)
{
    json json;
    json_start(&json, stdout);
    json_text(&json, "armtol", armtol_version());
    json_open_array(&json, "arms");
    for (size_t i = 0; i < armtol_arm_count(); i++) {
        const armtol_arm *arm = armtol_arm_at(i);
        json_open_object(&json, NULL);
        json_arm_texts(&json, arm);
        json_count(&json, "links", arm->n_links);
        json_count(&json, "joints", armtol_arm_joint_count(arm));
        json_joint_names(&json, arm);
        json_text(&json, "length", armtol_length_unit_name(arm->unit));
        json_close_object(&json);
    }
    json_close_array(&json);
    json_end(&json);
}

/* What is not known is left out: limits without an end, drives, masses. */
static bool is_known(const armtol_arm *arm, const arm_entry *entry, arm_column column, double value)
{
    const armtol_drive *drive = &entry->drive;
    if (arm_column_is_mass(column)) {
        return arm->masses != NULL;
    }
    if (!arm_column_is_drive(column)) {
        return true;
    }
    const bool gives_way = drive->compliance != 0 || drive->moment != 0;
    const bool said = column <= COLUMN_BACKLASH                                ? isfinite(value)
                      : column == COLUMN_COMPLIANCE || column == COLUMN_MOMENT ? gives_way
                                                                               : value != 0;
    return said && entry->link.joint != ARMTOL_FIXED && column != COLUMN_STIFFNESS && column != COLUMN_BITS;
}

/* How a joint moves that does not simply move by itself. */
static void write_motion(json *json, const arm_entry *entry, const units *units, size_t link)
{
    const armtol_motion *motion = &entry->motion;
    if (motion->sign != 1) {
        json_number(json, "sign", motion->sign);
    }
    if (motion->follows != link) {
        const bool angle = entry->link.joint == ARMTOL_REVOLUTE;
        json_count(json, "couple", motion->follows);
        json_number(json, "multiplier", motion->multiplier);
        json_number(json, "offset", angle ? units_typed(units, false, motion->offset) : motion->offset);
    }
}

static void write_link(json *json, const armtol_arm *arm, const units *units, size_t i)
{
    arm_entry entry = arm_entry_of(arm, i);
    json_open_object(json, NULL);
    json_text_if(json, "name", entry.name);
    json_text(json, "kind", armtol_kind_name(entry.link.kind));
    json_text(json, "joint", arm_joint_name(entry.link.joint));
    for (arm_column column = COLUMN_A; column < ARM_COLUMNS; column++) {
        if (arm_column_is_motion(column)) {
            continue;
        }
        const double value = *arm_column_number(column, &entry);
        const bool angle = arm_column_is_angle(column, entry.link.joint);
        if (is_known(arm, &entry, column, value)) {
            json_number(json, arm_column_name(column), angle ? units_typed(units, false, value) : value);
        }
    }
    if (entry.link.joint != ARMTOL_FIXED) {
        write_motion(json, &entry, units, i);
    }
    json_close_object(json);
}

void json_show(const arm_model *model, const units *units, const struct units *laid)
{
    const armtol_arm *arm = &model->arm;
    json json;
    json_start(&json, stdout);
    json_text(&json, "armtol", armtol_version());
    json_open_object(&json, "arm");
    json_arm_texts(&json, arm);
    json_close_object(&json);
    json_units(&json, units);
    laying_write(&json, &model->laying, laid);
    json_open_array(&json, "links");
    for (size_t i = 0; i < arm->n_links; i++) {
        write_link(&json, arm, units, i);
    }
    json_close_array(&json);
    json_end(&json);
}
