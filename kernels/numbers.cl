// The numbers of a substep, in `rule`; where they come from, pipeline.Substeps.

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
#define C2D_TURN rule[23]

// Those that circles, walls and contacts need are read once, for the compiler cannot know that nothing is stored over them.

// Of an axis: what gravity adds to a velocity, the highest speed, and where the walls are.
typedef struct {
    float gain;
    float speed;
    float min;
    float max;
} c2d_along;

typedef struct {
    float time;
    float perTime;
    float bounceFrom;
    float restitution;
    float push;
    float pushMost;
    float slop;
    float deep;
    float extrapolate;
    float extrapolateUneven;
    float uneven;
    float impulseMost;
    float turn;
    float slowed;
    c2d_along x;
    c2d_along y;
} c2d_numbers;

static c2d_along c2d_along_of(__global const float *rule, int axis) {
    const c2d_along n = {C2D_GAIN(axis), C2D_SPEED(axis), C2D_MIN(axis), C2D_MAX(axis)};
    return n;
}

static c2d_numbers c2d_numbers_of(__global const float *rule) {
    const c2d_numbers n = {C2D_TIME,        C2D_PER_TIME,           C2D_BOUNCE_FROM,       C2D_RESTITUTION, C2D_PUSH,
                           C2D_PUSH_MOST,   C2D_SLOP,               C2D_DEEP,              C2D_EXTRAPOLATE, C2D_EXTRAPOLATE_UNEVEN,
                           C2D_UNEVEN,      C2D_IMPULSE_MOST,       C2D_TURN,              C2D_SLOWED,      c2d_along_of(rule, 0),
                           c2d_along_of(rule, 1)};
    return n;
}
