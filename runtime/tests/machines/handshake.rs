//! Handshakes against drives that answer late, over lines that lose, delay and repeat frames.

use devc_runtime::cia402::{
    Halt, HaltProgress, Homing, HomingBits, HomingProgress, Move, Output, Progress, SetPointProgress,
    SetPoints, Timing,
};

use crate::plant::{Dice, Line, ROUND_TRIP};

const TIMING: Timing = Timing { round_trip: ROUND_TRIP, resend: 60, timeout: 400 };
const START: u16 = 1 << 4;
const REACHED: u16 = 1 << 10;
const ATTAINED: u16 = 1 << 12;
const ERROR: u16 = 1 << 13;

fn output(motion: bool) -> Output {
    Output { controlword: 0x000F, mode: 0, seed: !motion, motion, progress: Progress::Reached }
}

/// The drive's side of homing: a rising edge starts it, a falling edge ends it, `takes` cycles bring it to its end.
struct Reference {
    bits: u16,
    word: u16,
    runs: Option<u32>,
    takes: u32,
    ends_with: u16,
    starts: u32,
}

impl Reference {
    fn cycle(&mut self, controlword: u16) -> u16 {
        let before = std::mem::replace(&mut self.word, controlword);
        if !before & controlword & START != 0 {
            (self.runs, self.bits, self.starts) = (Some(0), 0, self.starts + 1);
        } else if before & !controlword & START != 0 && self.runs.take().is_some() {
            self.bits = REACHED;
        }
        match &mut self.runs {
            Some(cycles) if *cycles >= self.takes => (self.runs, self.bits) = (None, self.ends_with),
            Some(cycles) => *cycles += 1,
            None => (),
        }
        self.bits
    }
}

/// Homes over a line, with what the statusword shows from before, and checks that it ends as the drive ended it.
fn home(seed: u64, stale: u16, takes: u32, ends_with: u16) -> HomingProgress {
    let mut dice = Dice::new(seed);
    let mut drive = Reference { bits: stale, word: 0, runs: None, takes, ends_with, starts: 0 };
    let (mut down, mut up) = (Line::new(0x000F), Line::new(stale));
    let mut homing = Homing::new(HomingBits::PROFILE, TIMING);
    homing.start();
    let mut statusword = stale;
    for _ in 0..300 {
        let controlword = homing.cycle(&output(true), statusword);
        let ended = drive.runs.is_none() && drive.starts == 1;
        assert!(ended || homing.progress().is_active(), "{:?} before its end", homing.progress());
        let bits = drive.cycle(down.carry(controlword, Some(&mut dice)));
        statusword = up.carry(bits, Some(&mut dice));
    }
    assert_eq!(drive.starts, 1, "one start, one reference move");
    assert_eq!(drive.word & START, 0);
    homing.progress()
}

#[test]
fn homing_ends_as_the_drive_ends_it_whatever_was_shown_before() {
    for seed in 0..40 {
        for stale in [0, REACHED, ATTAINED, REACHED | ATTAINED, ERROR, ERROR | ATTAINED, ERROR | REACHED] {
            for takes in [0, 1, 5, 40] {
                let context = format!("seed {seed}, {stale:04X}, {takes} cycles");
                let completed = home(seed, stale, takes, REACHED | ATTAINED);
                assert_eq!(completed, HomingProgress::Completed, "{context}");
                for error in [ERROR, ERROR | ATTAINED] {
                    assert_eq!(home(seed, stale, takes, error), HomingProgress::Failed, "{context}");
                }
            }
        }
    }
}

/// The result of the homing before must not be taken for that of the next, though the bit is low only for a moment.
#[test]
fn each_request_is_a_reference_move_of_its_own() {
    for seed in 0..100 {
        let mut dice = Dice::new(seed);
        let mut drive =
            Reference { bits: 0, word: 0, runs: None, takes: 3, ends_with: REACHED | ATTAINED, starts: 0 };
        let (mut down, mut up) = (Line::new(0x000F), Line::new(0));
        let mut homing = Homing::new(HomingBits::PROFILE, TIMING);
        let (mut statusword, mut requests) = (0, 0);
        for now in 0..2000 {
            if !homing.progress().is_active() {
                assert_eq!(drive.starts, requests, "seed {seed}");
                assert!(requests == 0 || homing.progress() == HomingProgress::Completed);
                requests += 1;
                homing.start();
            }
            let controlword = homing.cycle(&output(true), statusword);
            statusword = up.carry(drive.cycle(down.carry(controlword, Some(&mut dice))), Some(&mut dice));
            assert!(now < 1999 || requests > 20);
        }
    }
}

#[test]
fn homing_ends_with_motion_and_starts_again_only_when_asked() {
    let mut homing = Homing::new(HomingBits::PROFILE, TIMING);
    homing.start();
    for _ in 0..100 {
        assert_eq!(homing.cycle(&output(false), 0) & START, 0, "not before there is motion");
    }
    assert_eq!(homing.cycle(&output(true), 0) & START, START);
    homing.cycle(&output(true), 0);
    assert_eq!(homing.cycle(&output(false), 0) & START, 0);
    assert_eq!(homing.progress(), HomingProgress::Interrupted);
    for _ in 0..100 {
        assert_eq!(homing.cycle(&output(true), 0) & START, 0);
    }
}

#[test]
fn homing_that_does_not_end_is_ended() {
    let mut homing = Homing::new(HomingBits::PROFILE, TIMING);
    homing.start();
    let words: Vec<u16> = (0..1000).map(|_| homing.cycle(&output(true), 0)).collect();
    assert_eq!(homing.progress(), HomingProgress::Overdue);
    assert_eq!(words.last(), Some(&0x000F));
}

/// The S700 starts by bit 11 and shows the reference in bit 9 (EtherCAT manual 07/2016, 3.4.2, 3.4.3).
#[test]
fn homing_takes_the_bits_of_the_device() {
    let bits = HomingBits { start: 1 << 11, reached: 0x0400, attained: 1 << 9, error: 1 << 13 };
    let mut homing = Homing::new(bits, Timing { round_trip: 0, ..TIMING });
    homing.start();
    assert_eq!(homing.cycle(&output(true), 0), 0x080F);
    homing.cycle(&output(true), 0);
    assert_eq!(homing.cycle(&output(true), 0x0600), 0x000F);
    assert_eq!(homing.progress(), HomingProgress::Completed);
}

/// The drive's side of set-points: takes one at each rising edge while it is ready, and travels to it.
#[derive(Default)]
struct Travel {
    word: u16,
    taken: Vec<(i32, u16)>,
    acknowledge: bool,
    left: u32,
    /// It acknowledges for that long at least, as long as it cannot take another.
    full: u32,
}

impl Travel {
    fn cycle(&mut self, (controlword, target): (u16, i32)) -> u16 {
        let before = std::mem::replace(&mut self.word, controlword);
        self.left = self.left.saturating_sub(1);
        if !before & controlword & START != 0 {
            self.taken.push((target, controlword & 0x0060));
            (self.acknowledge, self.left) = (true, 9 + self.full);
        } else if controlword & START == 0 && self.left <= 9 {
            self.acknowledge = false;
        }
        let reached = if self.left == 0 { REACHED } else { 0 };
        reached | if self.acknowledge { ATTAINED } else { 0 }
    }
}

#[test]
fn every_set_point_is_taken_once_and_in_order() {
    let kinds = [(false, false), (false, true), (true, false), (true, true)];
    let kinds = kinds.map(|(relative, immediate)| Move { relative, immediate });
    for seed in 0..100 {
        let mut dice = Dice::new(seed);
        let mut drive = Travel::default();
        let (mut down, mut up) = (Line::new((0x000F, 0)), Line::new(REACHED));
        let mut points = SetPoints::new(TIMING);
        let (mut target, mut statusword, mut offered) = (0, REACHED, Vec::new());
        for _ in 0..3000 {
            let kind = kinds[target as usize % kinds.len()];
            if dice.below(5) == 0 && points.offer(kind) {
                target += 1;
                offered.push((target, u16::from(kind.immediate) << 5 | u16::from(kind.relative) << 6));
            }
            let controlword = points.cycle(&output(true), statusword);
            assert_ne!(points.progress(), SetPointProgress::Overdue);
            let sent = down.carry((controlword, target), Some(&mut dice));
            statusword = up.carry(drive.cycle(sent), Some(&mut dice));
        }
        let taken = &drive.taken;
        assert!(taken.len() > 30);
        assert_eq!(taken[..], offered[..taken.len()], "seed {seed}");
        assert!(offered.len() - taken.len() < 2);
    }
}

/// Motion ends and begins again at any time; a set-point that counts as acknowledged is one that the drive has taken.
#[test]
fn after_an_interruption_no_older_answer_counts() {
    for seed in 0..100 {
        let mut dice = Dice::new(seed);
        let mut drive = Travel { full: 60, ..Travel::default() };
        let (mut down, mut up) = (Line::new((0x000F, 0)), Line::new(REACHED));
        let mut points = SetPoints::new(TIMING);
        let (mut target, mut statusword, mut acknowledged) = (0, REACHED, 0);
        for _ in 0..6000 {
            let motion = dice.below(20) != 0;
            if points.offer(Move::ABSOLUTE) {
                target += 1;
            }
            let before = points.progress();
            let controlword = points.cycle(&output(motion), statusword);
            if before == SetPointProgress::Given && points.progress() == SetPointProgress::Acknowledged {
                assert_eq!(drive.taken.last(), Some(&(target, 0)), "seed {seed}");
                acknowledged += 1;
            }
            let sent = down.carry((controlword, target), Some(&mut dice));
            statusword = up.carry(drive.cycle(sent), Some(&mut dice));
        }
        assert!(acknowledged > 10);
    }
}

#[test]
fn arrival_is_that_at_the_last_set_point() {
    for seed in 0..100 {
        let mut dice = Dice::new(seed);
        let mut drive = Travel::default();
        let (mut down, mut up) = (Line::new((0x000F, 0)), Line::new(REACHED));
        let mut points = SetPoints::new(TIMING);
        let mut statusword = REACHED;
        for target in 1..20 {
            assert!(points.offer(Move::ABSOLUTE));
            for _ in 0..100 {
                let controlword = points.cycle(&output(true), statusword);
                if points.progress() == SetPointProgress::Arrived {
                    assert_eq!(drive.taken.last(), Some(&(target, 0)));
                    assert_eq!(drive.left, 0);
                }
                let sent = down.carry((controlword, target), Some(&mut dice));
                statusword = up.carry(drive.cycle(sent), Some(&mut dice));
            }
            assert_eq!(points.progress(), SetPointProgress::Arrived);
        }
    }
}

#[test]
fn a_set_point_that_is_not_acknowledged_is_named() {
    let mut points = SetPoints::new(TIMING);
    assert!(points.offer(Move::ABSOLUTE));
    let words: Vec<u16> = (0..1000).map(|_| points.cycle(&output(true), 0)).collect();
    assert_eq!(points.progress(), SetPointProgress::Overdue);
    assert_eq!(words.last(), Some(&0x000F));
    // the bit stays low until the drive has seen it, so that the next one is an edge
    assert!(points.offer(Move::ABSOLUTE));
    assert_eq!(points.cycle(&output(true), 0) & START, START);
}

#[test]
fn set_points_wait_for_motion_and_end_with_it() {
    let mut points = SetPoints::new(TIMING);
    assert!(points.offer(Move::ABSOLUTE));
    for _ in 0..100 {
        assert_eq!(points.cycle(&output(false), 0) & START, 0);
    }
    assert_eq!(points.cycle(&output(true), 0) & START, START);
    assert_eq!(points.cycle(&output(false), 0) & START, 0);
    assert_eq!(points.progress(), SetPointProgress::Interrupted);
}

#[test]
fn halt_stands_when_the_drive_does_not_when_it_stood_before() {
    for takes in 0..40_u16 {
        for seed in 0..20 {
            let mut dice = Dice::new(seed);
            let (mut down, mut up) = (Line::new(0x000F), Line::new(REACHED));
            let (mut moving, mut statusword) = (takes, REACHED);
            let mut halt = Halt::new(TIMING);
            halt.give(true);
            for _ in 0..120 {
                let word = down.carry(halt.cycle(0x000F, statusword), Some(&mut dice));
                let halts = word & 1 << 8 != 0;
                assert!(halt.progress() != HaltProgress::Standing || moving == 0);
                moving -= u16::from(halts && moving > 0);
                let bits = if halts && moving > 0 { 0 } else { REACHED };
                statusword = up.carry(bits, Some(&mut dice));
            }
            assert_eq!(halt.progress(), HaltProgress::Standing);
            halt.give(false);
            assert_eq!((halt.cycle(0x000F, REACHED), halt.progress()), (0x000F, HaltProgress::Released));
        }
    }
}

/// Homing is asked for before the axis is in the mode for it: it begins once there is motion.
#[test]
fn homing_waits_for_motion() {
    let mut homing = Homing::new(HomingBits::PROFILE, TIMING);
    homing.start();
    for _ in 0..2 * ROUND_TRIP {
        assert_eq!(homing.cycle(&output(false), 0) & START, 0);
        assert_eq!(homing.progress(), HomingProgress::Starting);
    }
    assert_eq!(homing.cycle(&output(true), 0) & START, START);
    assert_eq!(homing.cycle(&output(false), 0) & START, 0);
    assert_eq!(homing.progress(), HomingProgress::Interrupted);
}
