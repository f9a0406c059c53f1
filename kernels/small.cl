// What the stages of Solver.SMALL_STEPS share. Twins: host.SmallState, pipeline.Levels, pipeline.Substeps.
//
// A circle in the order of the cells, its body, is a float8:
//   .s01 centre   .s23 velocity   .s45 kick to come   .s6 radius   .s7 inverse mass
// By number: its cell, an int4 (finest column, finest row, level, -; level -1 where it was not there), and its walls, a float8:
// of the left, right, lower and upper wall the impulse to come, then the last one of each (-1 after a bounce).
// A contact: `pair`, the places of its circles among the bodies, and `ids`, their numbers, lower first; `memory`, the impulse
// to come and the last one (-1 after a bounce).

// The numbers of a substep, in `rule`.
#define C2D_TIME rule[0]
#define C2D_PER_TIME rule[1]
#define C2D_BOUNCE_FROM rule[2]
#define C2D_PUSH_MOST rule[3]
#define C2D_SLOWED rule[4]
#define C2D_GAIN(axis) rule[5 + (axis)]
#define C2D_RESCALE rule[7]
#define C2D_SPEED(axis) rule[8 + (axis)]
#define C2D_MIN(axis) rule[10 + (axis)]
#define C2D_MAX(axis) rule[12 + (axis)]
#define C2D_RESTITUTION rule[14]
#define C2D_PUSH rule[15]
#define C2D_SLOP rule[16]
#define C2D_DEEP rule[17]
#define C2D_EXTRAPOLATE rule[18]
#define C2D_EXTRAPOLATE_UNEVEN rule[19]
#define C2D_UNEVEN rule[20]
#define C2D_IMPULSE_MOST rule[21]
#define C2D_ALWAYS_NEAR rule[22]

// A level of cells, an int8.
#define C2D_SHIFT s0
#define C2D_LAST_X s1
#define C2D_LAST_Y s2
#define C2D_WIDTH s3
#define C2D_HEIGHT s4
#define C2D_SHEAR s5
#define C2D_BASE s6
#define C2D_OWNERS s7

// Column and row of buckets of a cell.
static int2 c2d_folded(int8 level, int2 cell) {
    if (cell.x < level.C2D_WIDTH && cell.y < level.C2D_HEIGHT) {
        return cell;
    }
    const int turn = cell.x / level.C2D_WIDTH;
    const long row = (long)cell.y + (long)turn * (long)level.C2D_SHEAR;
    return (int2)(cell.x - turn * level.C2D_WIDTH, (int)(row % (long)level.C2D_HEIGHT));
}

static int c2d_bucket(int8 level, int2 cell) {
    const int2 at = c2d_folded(level, cell);
    return level.C2D_BASE + at.y * level.C2D_WIDTH + at.x;
}

static int c2d_owner_at(int8 level, int2 cell) {
    const int2 at = c2d_folded(level, cell);
    return level.C2D_BASE + (at.x % 3 + 3 * (at.y % 2)) * level.C2D_OWNERS + at.y / 2 * ((level.C2D_WIDTH + 2) / 3) +
           at.x / 3;
}

// The owner of a contact of circles in two cells of one level: the lower, by row and then by column; -1 where they are not
// neighbours.
static int c2d_owner_of_two(int8 level, int2 a, int2 b) {
    if (abs(a.x - b.x) > 1u || abs(a.y - b.y) > 1u) {
        return -1;
    }
    const bool lower = a.y < b.y || (a.y == b.y && a.x <= b.x);
    return c2d_owner_at(level, lower ? a : b);
}

// The finest column or row of a coordinate; whatever lies outside, or nowhere, counts to the nearest.
static int c2d_finest(float coordinate, float min, float perUnit, int last) {
    const float cell = (coordinate - min) * perUnit;
    const float low = cell > 0.0f ? cell : 0.0f;
    return (int)(low < (float)last ? low : (float)last);
}

static float c2d_positive(float x) { return x > 0.0f ? x : 0.0f; }

// The impulse to come.
static float c2d_extrapolated(float impulse, float last, float beta, float most) {
    const float next = c2d_positive(impulse + beta * (impulse - c2d_positive(last)));
    return next < most ? next : most;
}
