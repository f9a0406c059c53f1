// The numbers of a substep, part of the argument `world` of every kernel of small steps. Where they come from, and their order:
// pipeline.Substeps. GPUs keep arguments in constant memory, where instructions find them without a register.

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
    float alwaysNear;
    float rescale;
    c2d_along x;
    c2d_along y;
} c2d_numbers;
