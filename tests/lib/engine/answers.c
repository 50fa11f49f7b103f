#include "lib/engine/answers.h"

#include "unity.h"

armtol_answer *answer_of(const armtol_question *question)
{
    armtol_answer *answer;
    armtol_fault fault = {ARMTOL_NO_MEMORY, ARMTOL_ABOUT_POSE, 9};
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_answer_create(question, &answer, &fault));
    TEST_ASSERT_TRUE(fault.status == ARMTOL_OK && fault.about == ARMTOL_ABOUT_NOTHING && fault.number == 0);
    TEST_ASSERT_NOT_NULL(answer);
    return answer;
}

void check_refused(const armtol_question *question, armtol_status status, armtol_subject about, size_t number)
{
    armtol_answer *answer;
    armtol_fault fault;
    TEST_ASSERT_EQUAL_INT(status, armtol_answer_create(question, &answer, &fault));
    TEST_ASSERT_EQUAL_INT(about, fault.about);
    TEST_ASSERT_EQUAL_INT(number, fault.number);
    TEST_ASSERT_NULL(answer);
}
