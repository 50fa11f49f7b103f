/* Tallies of arms: the engine's counts. */

#include "armtol/ask/options.h"
#include "armtol/cluster/tally_file.h"

static const char *subject(size_t number)
{
    return armtol_tally_subject_name((armtol_tally_subject)number);
}

static bool is_sound(const tally_head *head)
{
    (void)head;
    return true;
}

static bool start(tally_content *content, const tally_head *head, uint64_t count)
{
    (void)head;
    (void)count;
    if (content->arms != NULL) {
        armtol_tally_clear(content->arms);
        return true;
    }
    return armtol_tally_create(&content->arms) == ARMTOL_OK;
}

static armtol_tally_member member(const tally_content *content, size_t number)
{
    return armtol_tally_member_at(content->arms, number);
}

static bool fits(const tally_content *content, const tally_head *head)
{
    const shard_range range = tally_head_range(head);
    return armtol_tally_is_of(content->arms, range.first, range.count);
}

static void add(tally_content *into, const tally_content *part, const tally_head *head)
{
    (void)head;
    armtol_tally_add(into->arms, part->arms);
}

const tally_form tally_of_arms = {
    .one = "arm",
    .many = "arms",
    .number = "number of arms",
    .most = MOST_ARMS,
    .n_numbers = 1,
    .numbers = {"seed"},
    .meanings = {"seed"},
    .n_subjects = ARMTOL_TALLY_SUBJECT_COUNT,
    .subject = subject,
    .misfit = "the counts do not add up to the arms of the shard: the tally is damaged",
    .is_sound = is_sound,
    .start = start,
    .member_count = armtol_tally_member_count,
    .member = member,
    .fits = fits,
    .add = add,
};
