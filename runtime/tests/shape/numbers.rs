//! Numbers for tests that try many: the same in each run.

use devc_runtime::unit::Scale;

/// Xorshift: every number but 0 once before the first comes again.
pub(crate) struct Numbers(u64);

impl Numbers {
    pub(crate) fn new() -> Self {
        Self(0x9E37_79B9_7F4A_7C15)
    }

    pub(crate) fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    pub(crate) fn bytes<const N: usize>(&mut self) -> [u8; N] {
        core::array::from_fn(|_| self.next().to_le_bytes()[0])
    }
}

/// Values at the ends and of every magnitude between.
fn values() -> Vec<i64> {
    let mut numbers = Numbers::new();
    let mut values = vec![i64::MIN, i64::MIN + 1, -1, 0, 1, i64::MAX - 1, i64::MAX];
    values.extend((0..2000).map(|n| numbers.next() as i64 >> (n % 64)));
    values
}

#[test]
fn scaling_is_exact_or_says_so_and_never_wraps() {
    for (n, d) in
        [(1, 1), (1, 2), (1, 3), (1, 100), (2, 3), (100_000, 1), (u64::MAX, 1), (1, u64::MAX), (7, u64::MAX)]
    {
        let scale = Scale::new(n, d).unwrap();
        for value in values() {
            let product = i128::from(value) * i128::from(n);
            let whole = (product % i128::from(d) == 0).then_some(product / i128::from(d));
            assert_eq!(
                scale.physical(value),
                whole.and_then(|whole| i64::try_from(whole).ok()),
                "{value} × {n}/{d}"
            );

            let rounded = scale.physical_rounded(value);
            let off = (product - i128::from(rounded) * i128::from(d)).abs();
            let end = if value < 0 { i64::MIN } else { i64::MAX };
            assert!(rounded == end || 2 * off <= i128::from(d), "{value} × {n}/{d} is not near {rounded}");
            let back = Scale::new(d, n).unwrap();
            assert_eq!(back.raw_rounded(value), rounded);
            assert_eq!(back.raw(value), scale.physical(value), "{value} of {d}/{n}");
        }
    }
}

#[test]
fn halves_go_away_from_zero() {
    let half = Scale::of::<1, 2>();
    assert_eq!([-3, -1, 1, 3].map(|raw| half.physical_rounded(raw)), [-2, -1, 1, 2]);
    assert_eq!(half.physical_f64(-3), -1.5);
    assert_eq!(Scale::of::<3, 4>().physical_f64(6), 4.5);
}

#[test]
fn a_scale_of_nothing_is_none() {
    assert_eq!((Scale::new(0, 1), Scale::new(1, 0)), (None, None));
}
