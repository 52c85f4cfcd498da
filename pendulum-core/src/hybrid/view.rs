//! A step while it is searched for the end of a mode.

use super::MOST;
use super::fired::{FORWARD, Fired, Values};
use super::functions::{Place, Scene};
use super::mode::Mode;
use crate::method::{places, unseen_bend};
use crate::real::Float;

/// A step and the bounds that its search has found.
pub(super) struct View<T> {
    pub(super) start: Place<T>,
    /// The mode starts with it.
    pub(super) starts: bool,
    /// The functions that may end the mode.
    pub(super) live: Fired,
    /// Within what of zero they may be rounding errors.
    pub(super) noise: Values<T>,
    /// Largest bend of each gap between places that was seen.
    pub(super) bends: [T; MOST],
    /// In how many places forces are looked at.
    pub(super) count: usize,
}

impl<T: Float> View<T> {
    /// Where what is not held is looked at.
    pub(super) fn places(&self, mode: &Mode) -> impl Iterator<Item = T> + use<T> {
        let mut free = self.live.pairs().filter(|&(n, _)| !mode.is_held(n)).peekable();
        let is_any = free.peek().is_some();
        // what rebounds may come back at once
        let may_come_back = free.any(|(_, way)| way != FORWARD);
        places(self.starts && may_come_back).filter(move |_| is_any)
    }

    /// Looks at all of the step where gaps that move by themselves have ended the mode: whether they bend more than was
    /// known before.
    pub(super) fn look_ahead<const N: usize>(
        &mut self,
        scene: &Scene<'_, T, N>,
        fired: Fired,
        known: &[T; MOST],
    ) -> bool {
        let is_gap = |&(n, way): &(usize, usize)| !scene.mode.is_held(n) && way != FORWARD;
        let mut finds = false;
        for (n, way) in fired.pairs().filter(is_gap).filter(|&(n, _)| scene.moves_by_itself(n)) {
            let mut seen = Seen::new(scene.known(&self.start, (n, way)));
            for theta in places(false) {
                let (t, x) = scene.at(theta);
                let here = scene.known(&scene.place(theta, t, &x, None), (n, way));
                if let Some(earlier) = seen.earlier {
                    let bend = unseen_bend([earlier, seen.last, here], self.noise[n][way]);
                    self.bends[n] = self.bends[n].max(bend);
                }
                seen.go_to(here);
            }
            finds |= self.bends[n] > known[n];
        }
        finds
    }
}

/// The two places that were looked at last.
pub(super) struct Seen<P> {
    pub(super) earlier: Option<P>,
    pub(super) last: P,
}

impl<P: Copy> Seen<P> {
    pub(super) fn new(start: P) -> Self {
        Self {
            earlier: None,
            last: start,
        }
    }

    pub(super) fn go_to(&mut self, here: P) {
        (self.earlier, self.last) = (Some(self.last), here);
    }
}
