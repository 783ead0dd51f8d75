/* Solves for n unknowns by elimination with row exchanges. x is the right side, then the solution: not finite where the matrix is singular. */
static void ezy_solve(int n, double *matrix, double *x) {
    for (int k = 0; k < n; k++) {
        int largest = k;
        for (int i = k + 1; i < n; i++)
            if (fabs(matrix[i * n + k]) > fabs(matrix[largest * n + k])) largest = i;
        for (int j = k; j < n && largest != k; j++) {
            double held = matrix[k * n + j];
            matrix[k * n + j] = matrix[largest * n + j];
            matrix[largest * n + j] = held;
        }
        double held = x[k];
        x[k] = x[largest];
        x[largest] = held;
        for (int i = k + 1; i < n; i++) {
            double factor = matrix[i * n + k] / matrix[k * n + k];
            for (int j = k + 1; j < n && factor != 0; j++) matrix[i * n + j] -= factor * matrix[k * n + j];
            x[i] -= factor * x[k];
        }
    }
    for (int i = n - 1; i >= 0; i--) {
        for (int j = i + 1; j < n; j++) x[i] -= matrix[i * n + j] * x[j];
        x[i] /= matrix[i * n + i];
    }
}
