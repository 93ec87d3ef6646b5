//! A cubic through points that rises where they rise, falls where they fall, and goes nowhere beyond them.
//!
//! Slopes are those of the parabola through a point and its neighbours, cut back where the cubic would overshoot: F. N.
//! Fritsch, R. E. Carlson, Monotone piecewise cubic interpolation, SIAM J. Numer. Anal. 17 (1980) 238–246. Points of a
//! parabola give that parabola; the harmonic means of PCHIP would make its curvature at the vertex 1.5 times as large.

/// Points by ascending s, and the slopes of the cubic there; it and its derivative are continuous.
#[derive(Clone, Debug)]
pub struct MonotoneCubic {
    /// `[s, g]` \[mm\].
    pub points: Vec<[f64; 2]>,
    /// dg/ds at each of them.
    pub slopes: Vec<f64>,
}

/// Largest `√(α² + β²)`, slopes at both ends of an interval over its secant, with which a cubic stays monotone.
const ROUND: f64 = 3.0;
/// Difference of the curvatures on both sides of a point, over the larger of them, from which on it leaps there.
const LEAP: f64 = 0.4;
/// Curvature, over the largest one, up to which it is round-off.
const STRAIGHT: f64 = 1e-9;

impl MonotoneCubic {
    /// Through at least two points; where they begin at s = 0 the gap is even, and its slope there 0.
    pub fn through(points: &[[f64; 2]]) -> Self {
        let steps: Vec<f64> = points.windows(2).map(|ends| ends[1][0] - ends[0][0]).collect();
        let secants: Vec<f64> = points.windows(2).zip(&steps).map(|(ends, h)| (ends[1][1] - ends[0][1]) / h).collect();
        let last = secants.len();
        let mut slopes: Vec<f64> = (0..=last)
            .map(|k| match k {
                0 if points[0][0] >= 0.0 => 0.0,
                // At an end the parabola through the three nearest points; through two a line.
                0 if last > 1 => secants[0] + (secants[0] - secants[1]) * steps[0] / (steps[0] + steps[1]),
                0 => secants[0],
                _ if k == last && last > 1 => {
                    let [h, before] = [steps[k - 1], steps[k - 2]];
                    secants[k - 1] + (secants[k - 1] - secants[k - 2]) * h / (h + before)
                }
                _ if k == last => secants[0],
                _ if secants[k - 1] * secants[k] <= 0.0 => 0.0,
                _ => (steps[k] * secants[k - 1] + steps[k - 1] * secants[k]) / (steps[k - 1] + steps[k]),
            })
            .collect();
        for (k, secant) in secants.iter().enumerate() {
            let signed = |slope: f64| if slope * secant > 0.0 { slope } else { 0.0 };
            let [a, b] = [signed(slopes[k]), signed(slopes[k + 1])];
            let over = a.hypot(b) / (ROUND * secant.abs());
            let factor = if over > 1.0 { 1.0 / over } else { 1.0 };
            [slopes[k], slopes[k + 1]] = [a * factor, b * factor];
        }
        Self { points: points.to_vec(), slopes }
    }

    /// Gap at `s` \[mm\]; none before the first point and beyond the last.
    pub fn gap(&self, s: f64) -> f64 {
        let Some((k, [a, b], t)) = self.interval(s) else { return f64::INFINITY };
        let h = b[0] - a[0];
        let [rise, bend] = [t * t * (3.0 - 2.0 * t), t * (1.0 - t)];
        let [m, n] = [self.slopes[k], self.slopes[k + 1]];
        a[1] + (b[1] - a[1]) * rise + h * bend * (m * (1.0 - t) - n * t)
    }

    /// Its derivative; NaN before the first point and beyond the last.
    pub fn slope(&self, s: f64) -> f64 {
        let Some((k, [a, b], t)) = self.interval(s) else { return f64::NAN };
        let secant = (b[1] - a[1]) / (b[0] - a[0]);
        let [m, n] = [self.slopes[k], self.slopes[k + 1]];
        6.0 * t * (1.0 - t) * secant + (1.0 - t) * (1.0 - 3.0 * t) * m + t * (3.0 * t - 2.0) * n
    }

    /// Places at which its curvature leaps, as where an arc goes over into a line.
    ///
    /// Between points at distances h that a smooth function has, it leaps by a few h of what it is.
    pub fn leaps(&self) -> Vec<f64> {
        let pieces = self.points.windows(2).zip(self.slopes.windows(2));
        // `g'' = (6 d − 4 m − 2 n)/h` where a piece begins, `(2 m + 4 n − 6 d)/h` where it ends: slopes m and n there,
        // d of its chord.
        let curvatures: Vec<[f64; 2]> = pieces
            .map(|(ends, slopes)| {
                let h = ends[1][0] - ends[0][0];
                let (chord, [m, n]) = ((ends[1][1] - ends[0][1]) / h, [slopes[0], slopes[1]]);
                [(6.0 * chord - 4.0 * m - 2.0 * n) / h, (2.0 * m + 4.0 * n - 6.0 * chord) / h]
            })
            .collect();
        let largest = curvatures.iter().flatten().fold(0.0, |largest: f64, one| largest.max(one.abs()));
        let leaps = |two: &[[f64; 2]]| {
            let [before, after] = [two[0][1], two[1][0]];
            let size = before.abs().max(after.abs());
            size > STRAIGHT * largest && (after - before).abs() > LEAP * size
        };
        let inner = self.points.iter().skip(1).map(|point| point[0]);
        inner.zip(curvatures.windows(2)).filter(|(_, two)| leaps(two)).map(|(s, _)| s).collect()
    }

    /// Number and ends of the interval of `s`, and where in it that is.
    fn interval(&self, s: f64) -> Option<(usize, [[f64; 2]; 2], f64)> {
        let after = self.points.partition_point(|point| point[0] < s * (1.0 - 1e-12)).max(1);
        let &[a, b] = self.points.get(after - 1..=after)? else { return None };
        (s >= a[0] - 1e-12 * s.abs()).then(|| (after - 1, [a, b], ((s - a[0]) / (b[0] - a[0])).clamp(0.0, 1.0)))
    }
}
