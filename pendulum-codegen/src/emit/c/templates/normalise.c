
// Derivative of the normalised quaternion at the components from `start`, in place of that of the quaternion.
static void Pendulum_normalise(int columns, double *derivative, const double end[N], int start) {
    double square = 0.0;
    for (int n = start; n < start + 4; n++) square += end[n] * end[n];
    const double scale = 1.0 / PENDULUM_SQRT(square);
    for (int j = 0; j < columns; j++) {
        double *const column = derivative + N * j, along = 0.0;
        for (int n = start; n < start + 4; n++) along += end[n] * column[n];
        for (int n = start; n < start + 4; n++) column[n] = scale * (column[n] - along / square * end[n]);
    }
}
