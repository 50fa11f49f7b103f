#ifndef ARMTOL_LIB_PRIVATE_NAMES_H
#define ARMTOL_LIB_PRIVATE_NAMES_H

/*
 * What the library's files say to each other and to nobody else. In the static library such a name is as visible as a
 * public one: it gets the library's prefix there, so that no program's own routine meets it. (The test exports.)
 */
#define allocation_add_multiple armtol_private_allocation_add_multiple
#define allocation_binds armtol_private_allocation_binds
#define allocation_center armtol_private_allocation_center
#define allocation_dot armtol_private_allocation_dot
#define allocation_element armtol_private_allocation_element
#define allocation_factor armtol_private_allocation_factor
#define allocation_factor_solve armtol_private_allocation_factor_solve
#define allocation_find_units armtol_private_allocation_find_units
#define allocation_in_range armtol_private_allocation_in_range
#define allocation_pack armtol_private_allocation_pack
#define allocation_use armtol_private_allocation_use
#define angle_of armtol_private_angle_of
#define arc_cosine_of armtol_private_arc_cosine_of
#define arc_sine_of armtol_private_arc_sine_of
#define arm_adept_one armtol_private_arm_adept_one
#define arm_iiwa_14 armtol_private_arm_iiwa_14
#define arm_intelledex_605t armtol_private_arm_intelledex_605t
#define arm_panda armtol_private_arm_panda
#define arm_puma_560 armtol_private_arm_puma_560
#define arm_scara armtol_private_arm_scara
#define arm_stanford armtol_private_arm_stanford
#define arm_ur5e armtol_private_arm_ur5e
#define columns_of_link armtol_private_columns_of_link
#define cosine_of armtol_private_cosine_of
#define length_of armtol_private_length_of
#define pose_links_of armtol_private_pose_links_of
#define sine_of armtol_private_sine_of
#define transform_of_rows armtol_private_transform_of_rows

#endif
