// What the stages of Solver.SMALL_STEPS share. Twins: host.SmallState, pipeline.Levels, pipeline.Substeps.
//
// Circles are kept in the order of the cells; where one is in that order is its place. By place: `body`, a float8,
//   .s01 centre   .s23 velocity   .s45 kick to come   .s6 radius   .s7 inverse mass
// and `id`, its number. By number: `walls`, for each axis the impulse to come and the last one, positive from the lower wall,
// negative from the upper; a circle at both of them at once remembers the lower.
//
// Every contact is in the list of one of its circles: of the one at the wider level; on one level, of the one in the lower
// cell, by row and then by column; in one cell, of the one at the lower place. The list of a circle is
// `other[listStart[place]]` up to `other[listStart[place + 1]]`, the places of the other circles, ascending. `memory`, the impulse
// to come and the last one (-1 after a bounce), is in the order of solving, and `where` says of each contact where in it.

// All of that is in one buffer, for a launch takes longer with every buffer that it gets: a kernel gets the `heap`, the status, and
// a c2d_world, which says where the parts of the heap begin, in units of 32 bytes, and has the numbers of a substep. Twins:
// opencl.Heap and WorldArgument. `Before`: those of the detection before. What a part holds while it is not needed for that, each
// file says where it names it with C2D_AT.
typedef struct {
    uint body;
    uint bodyBefore;
    uint id;
    uint idBefore;
    uint listStart;
    uint listStartBefore;
    uint other;
    uint otherBefore;
    uint memory;
    uint found;
    uint where;
    uint walls;
    uint kicked;
    uint from;
    uint bucketStart;
    uint partSums;
    uint levels;
    uint tilings;
    uint tileStart;
    uint solves;
    uint live;
    int circles;
    // Contacts that there is room for.
    int capacity;
    c2d_numbers numbers;
} c2d_world;

// Of a kernel for one work-group: compilers count on small ones where nothing is said.
#define C2D_ONE __attribute__((reqd_work_group_size(C2D_ONE_GROUP, 1, 1)))

#define C2D_WORLD __global uchar *heap, __global uint *status, const c2d_world world
#define C2D_AT(type, part) ((__global type *)(heap + 32ul * world.part))

#define C2D_BODY C2D_AT(float8, body)
#define C2D_ID C2D_AT(int, id)
#define C2D_LIST_START C2D_AT(int, listStart)
#define C2D_OTHER C2D_AT(int, other)
#define C2D_MEMORY C2D_AT(float2, memory)
#define C2D_WHERE C2D_AT(int, where)
#define C2D_WALLS C2D_AT(float2, walls)
#define C2D_KICKED C2D_AT(float2, kicked)
// By place: the place at the detection before.
#define C2D_FROM C2D_AT(int, from)
#define C2D_BUCKET_START C2D_AT(int, bucketStart)
#define C2D_LEVEL_TABLE C2D_AT(const int8, levels)
#define C2D_TILING_TABLE C2D_AT(const int8, tilings)
#define C2D_TILE_START C2D_AT(int, tileStart)
// Of each tiling, of which there may be so many, how many tiles have anything in them; then, from its first tile on, they. For GPUs,
// where a work-group costs even if it has nothing to do. Processors go through all tiles: their threads take so many groups at a
// time, be there anything to do or not.
#define C2D_LIVE C2D_AT(int, live)
#define C2D_TILINGS 64
// Once a detection has what it needs of the one before, the parts of that one hold the order of solving: kernels/batch.cl.
#define C2D_BATCH C2D_AT(int, bodyBefore)
#define C2D_BY_TILE C2D_AT(int, otherBefore)
#define C2D_MEMBERS C2D_AT(int, idBefore)
#define C2D_CODE C2D_AT(ushort, listStartBefore)

// `levels`, int8s: first one for all of the cells, then one a level, finest first.
#define C2D_LEVELS s0
#define C2D_PER_UNIT s3

#define C2D_SHIFT s0
#define C2D_LAST_X s1
#define C2D_LAST_Y s2
#define C2D_WIDTH s3
#define C2D_HEIGHT s4
#define C2D_SHEAR s5
#define C2D_BASE s6
#define C2D_LARGEST s7

static bool c2d_is_folded(int8 level) { return level.C2D_LAST_X >= level.C2D_WIDTH || level.C2D_LAST_Y >= level.C2D_HEIGHT; }

static int c2d_bucket(int8 level, int x, int y) {
    if (x >= level.C2D_WIDTH || y >= level.C2D_HEIGHT) {
        const int turn = x / level.C2D_WIDTH;
        x -= turn * level.C2D_WIDTH;
        y = (int)(((long)y + (long)turn * (long)level.C2D_SHEAR) % (long)level.C2D_HEIGHT);
    }
    return level.C2D_BASE + y * level.C2D_WIDTH + x;
}

// The finest column or row of a coordinate; whatever lies outside, or nowhere, counts to the nearest.
static int c2d_finest(float coordinate, float min, float perUnit, int last) {
    const float cell = (coordinate - min) * perUnit;
    const float low = cell > 0.0f ? cell : 0.0f;
    return (int)(low < (float)last ? low : (float)last);
}

static int2 c2d_finest_cell(float2 centre, int8 all, const c2d_numbers numbers) {
    const float perUnit = as_float(all.C2D_PER_UNIT);
    return (int2)(c2d_finest(centre.x, numbers.x.min, perUnit, all.C2D_LAST_X),
                  c2d_finest(centre.y, numbers.y.min, perUnit, all.C2D_LAST_Y));
}

// The cell of a circle: finest column and row, and the number of its level.
static int4 c2d_cell(float8 body, __global const int8 *levels, const c2d_numbers numbers) {
    const int8 all = levels[0];
    int number = 0;
    while (number < all.C2D_LEVELS - 1 && body.s6 > as_float(levels[1 + number].C2D_LARGEST)) {
        number++;
    }
    return (int4)(c2d_finest_cell(body.s01, all, numbers), number, 0);
}

static float c2d_positive(float x) { return x > 0.0f ? x : 0.0f; }

// The impulse to come.
static float c2d_extrapolated(float impulse, float last, float beta, float most) {
    const float next = c2d_positive(impulse + beta * (impulse - c2d_positive(last)));
    return next < most ? next : most;
}

// What is remembered of a wall, whose `sign` leads inside, as for a contact. After a bounce the last impulse is beyond all.
#define C2D_BOUNCED 3e38f

static float2 c2d_of_wall(float2 walls, float sign) {
    const float last = c2d_positive(sign * walls.y);
    return (float2)(c2d_positive(sign * walls.x), last >= C2D_BOUNCED ? -1.0f : last);
}

static float2 c2d_of_walls(float2 low, float2 high) {
    const float lastLow = low.y < 0.0f ? C2D_BOUNCED : low.y;
    const float lastHigh = high.y < 0.0f ? C2D_BOUNCED : high.y;
    return (float2)(low.x != 0.0f ? low.x : -high.x, lastLow != 0.0f ? lastLow : -lastHigh);
}
