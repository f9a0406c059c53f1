// The self-check of a device: the operations that the stages use, on numbers of every size. Twin of host.Arithmetic.

__kernel void c2d_arithmetic(__global const float *a, __global const float *b, __global float *result, int count) {
    const int i = (int)get_global_id(0);
    if (i < count) {
        const float x = a[i];
        const float y = b[i];
        __global float *r = result + 6 * i;
        r[0] = x + y;
        r[1] = x * y + x; // a contracted multiply-add rounds once and shows here
        r[2] = x / y;
        r[3] = sqrt(x * x + y * y);
        r[4] = 1.0f / y - x * x;
        r[5] = (float)(int)(x * 16.0f) * y;
    }
}
