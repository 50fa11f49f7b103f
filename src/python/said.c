/* Messages of what reads, kept for an exception. */

#include "console/message.h"
#include "python/binding.h"

#include <stdio.h>
#include <string.h>

static char said[8192];

static void keep(const char *text)
{
    const size_t length = strlen(said);
    snprintf(said + length, sizeof said - length, "%s%s", length > 0 ? "\n" : "", text);
}

void binding_listen(void)
{
    said[0] = '\0';
    message_hand_to(keep);
}

const char *binding_said(void)
{
    message_hand_to(NULL);
    return said;
}
