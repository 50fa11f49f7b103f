#ifndef ARMTOL_SEAT_H
#define ARMTOL_SEAT_H

#include "armtol/interface.h"

ARMTOL_INTERFACE_BEGIN

/* What an axis may be off that is held in two bearing seats. */
typedef struct armtol_seat {
    double offset; /* of the line from where it is meant, between the seats; length unit */
    double angle;  /* of its direction; radians */
} armtol_seat;

/*
 * The errors of an axis in two seats.
 *
 * Given:
 *    apart      the distance L between the middles of the seats, > 0
 *    position   the tolerance p of the position of each seat: the diameter of the circle that its middle has to be in
 *    play       the play c of the axis in a seat, from one side to the other
 * Returned (function value):
 *    offset (p + c) / 2 and angle (p + c) / L; nan where L is not > 0, or p or c is not >= 0.
 * Notes:
 * 1) In each seat the axis is off by (p + c) / 2 at most, in any direction: both to the same side is the offset, to
 *    opposite sides the angle. The tangent of the angle is no more than (p + c) / L, so the angle is less. An axis has
 *    not the whole of both at once: to allow both is on the safe side.
 * 2) The offset is that between the seats. At a place x beyond the nearer seat the line is up to x angle farther off.
 * 3) Lengths have any unit, the same for all three.
 */
armtol_seat armtol_seat_errors(double apart, double position, double play);

ARMTOL_INTERFACE_END

#endif
