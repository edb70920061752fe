//! One bone through all entries of a stack.

use glam::{DQuat, DVec3};

use super::entry::{FilterEntry, Prepared, PreparedTrack};
use super::notice::Event;
use super::output::{Channel, ResultChannel};
use super::rig::{BaseChannel, Rig, RigBone};
use crate::combine::{align, lay_over, Manner, Overlay, Rigid, RootPose};
use crate::keys::{Interpolation, Key, Keys, SAME_FRAME};
use crate::motion::BoneMotion;
use crate::value::{EulerFrame, Turn, Value};

/// What became of one bone: its channels and which entry had something to say.
pub(super) struct Outcome<R> {
    pub rotation: Lane<R>,
    pub location: Lane<DVec3>,
    /// Which entry, and what.
    pub events: Vec<(usize, Event)>,
}

/// A rotation as the channels of a bone hold it.
pub(super) trait Rotation: Value {
    fn read(components: &[f64], frame: &EulerFrame) -> Self;
    fn write(self, frame: &EulerFrame, components: &mut [f64]);
    fn rotation(self) -> DQuat;
    fn turned_to(self, rotation: DQuat, frame: &EulerFrame) -> Self;
}

impl Rotation for DQuat {
    fn read(components: &[f64], _: &EulerFrame) -> Self {
        match *components {
            [w, x, y, z] => Self::from_xyzw(x, y, z, w),
            _ => Self::IDENTITY,
        }
    }

    fn write(self, _: &EulerFrame, components: &mut [f64]) {
        components.copy_from_slice(&[self.w, self.x, self.y, self.z]);
    }

    fn rotation(self) -> DQuat {
        self.normalize()
    }

    fn turned_to(self, rotation: DQuat, _: &EulerFrame) -> Self {
        rotation
    }
}

impl Rotation for Turn {
    fn read(components: &[f64], frame: &EulerFrame) -> Self {
        match *components {
            [x, y, z] => Self { rotation: frame.order.quat([x, y, z]), angles: [x, y, z] },
            _ => Self::default(),
        }
    }

    fn write(self, frame: &EulerFrame, components: &mut [f64]) {
        components[..3].copy_from_slice(&frame.order.angles_near(self.rotation, self.angles));
    }

    fn rotation(self) -> DQuat {
        self.rotation
    }

    fn turned_to(self, rotation: DQuat, frame: &EulerFrame) -> Self {
        Self { rotation, angles: frame.order.angles_near(rotation, self.angles) }
    }
}

/// One channel on its way through the stack.
pub(super) struct Lane<V> {
    pub keys: Keys<V>,
    /// First and last frame at which an entry changed something.
    pub touched: Option<(f64, f64)>,
    /// Frames of the host's own keys in the base.
    base_keys: Vec<f64>,
}

impl<V: Value> Lane<V> {
    fn new(base: Option<&BaseChannel>, channel: Channel, read: impl Fn(&[f64]) -> V) -> Self {
        let Some(base) = base else { return Self { keys: Keys::default(), touched: None, base_keys: Vec::new() } };
        let values = base.values.chunks_exact(channel.components()).map(read);
        let keys = base.frames.iter().zip(values);
        let keys = keys.map(|(&frame, value)| Key { frame, value, interpolation: Interpolation::Linear }).collect();
        let is_own = |index: usize| base.is_key.get(index).copied().unwrap_or(true);
        let own = base.frames.iter().enumerate().filter(|&(index, _)| is_own(index));
        Self { keys: Keys(keys), touched: None, base_keys: own.map(|(_, &frame)| frame).collect() }
    }

    fn touch(&mut self, (start, end): (f64, f64)) {
        let (first, last) = self.touched.unwrap_or((start, end));
        self.touched = Some((first.min(start), last.max(end)));
    }

    fn touch_all(&mut self) {
        if let Some(range) = self.keys.range() {
            self.touch(range);
        }
    }

    fn discard(&mut self) {
        self.touch_all();
        self.keys.0.clear();
    }

    fn take(&mut self, overlay: Overlay<V>) {
        self.keys = overlay.keys;
        self.touch(overlay.affected);
    }

    fn filter(&mut self, filter: &FilterEntry, frame: &EulerFrame) {
        self.keys.fill_whole_frames();
        let values: Vec<V> = self.keys.0.iter().map(|key| key.value).collect();
        let filtered = V::filter(&values, filter.kind, filter.depth, filter.channels, frame);
        for (key, value) in self.keys.0.iter_mut().zip(filtered) {
            key.value = value;
            key.interpolation = Interpolation::Linear;
        }
        self.touch_all();
    }

    /// Returns the touched frames, widened to the base's own keys where the base is sparse: the curve between two keys
    /// of the base cannot keep its shape when one of them gets a new neighbour, so what was seen there is keyed.
    fn replaced(&self) -> Option<(f64, f64)> {
        let (start, end) = self.touched?;
        let before = self.base_keys.partition_point(|&frame| frame < start - SAME_FRAME);
        let after = self.base_keys.partition_point(|&frame| frame <= end + SAME_FRAME);
        let start = match before.checked_sub(1).map(|index| self.base_keys[index]) {
            Some(key) if key < start - 1.0 - SAME_FRAME => key,
            _ => start,
        };
        let end = match self.base_keys.get(after) {
            Some(&key) if key > end + 1.0 + SAME_FRAME => {
                let inside = self.keys.0.partition_point(|sample| sample.frame < key - SAME_FRAME);
                inside.checked_sub(1).map_or(end, |index| self.keys.0[index].frame.max(end))
            }
            _ => end,
        };
        Some((start, end))
    }
}

/// Takes bone `index` of the rig through all entries.
pub(super) fn evaluate<R: Rotation>(
    rig: &Rig,
    index: usize,
    base: &[BaseChannel],
    entries: &[Prepared<'_>],
) -> Outcome<R> {
    let bone = &rig.bones[index];
    let frame = bone.euler_frame();
    let rotation_channel = bone.rotation_channel();
    let find = |channel| base.iter().find(|found| found.bone == index && found.channel == channel);
    let mut state = State {
        bone,
        up: rig.up,
        frame,
        rotation: Lane::new(find(rotation_channel), rotation_channel, |components| R::read(components, &frame)),
        location: Lane::new(find(Channel::Location), Channel::Location, |components| match *components {
            [x, y, z] => DVec3::new(x, y, z),
            _ => DVec3::ZERO,
        }),
    };
    let mut events = Vec::new();
    for (number, entry) in entries.iter().enumerate().filter(|(_, entry)| entry.includes(index)) {
        let said = match entry {
            Prepared::Track(track) => state.add_track(track, index),
            Prepared::Filter(filter) => state.filter(filter),
        };
        events.extend(said.into_iter().map(|event| (number, event)));
    }
    Outcome { rotation: state.rotation, location: state.location, events }
}

impl<R: Rotation> Outcome<R> {
    /// Returns what is to be written of bone `index`, and the events.
    pub fn into_channels(self, rig: &Rig, index: usize) -> (Vec<ResultChannel>, Vec<(usize, Event)>) {
        let bone = &rig.bones[index];
        let frame = bone.euler_frame();
        let rotation = self.rotation.replaced().map(|range| {
            ResultChannel::new(index, bone.rotation_channel(), range, &self.rotation.keys, |value, components| {
                value.write(&frame, components);
            })
        });
        let location = self.location.replaced().map(|range| {
            ResultChannel::new(index, Channel::Location, range, &self.location.keys, |value, components| {
                components[..3].copy_from_slice(&value.to_array());
            })
        });
        (rotation.into_iter().chain(location).collect(), self.events)
    }
}

struct State<'a, R> {
    bone: &'a RigBone,
    up: DVec3,
    frame: EulerFrame,
    rotation: Lane<R>,
    location: Lane<DVec3>,
}

impl<R: Rotation> State<'_, R> {
    fn add_track(&mut self, track: &PreparedTrack<'_>, index: usize) -> Vec<Event> {
        let Some(samples) = track.motion.bones.get(index).filter(|samples| !samples.is_empty()) else {
            return vec![Event::NoData];
        };
        if track.track.discard {
            self.rotation.discard();
            self.location.discard();
        }
        let first = track.motion.first_frame as f64;
        let sampling = track.track.sampling;
        let manner = Manner {
            track: &track.placement,
            blend_depth: track.blend_depth,
            blend: track.track.blend,
            frame: &self.frame.clone(),
        };
        let rigid = self.rigid_start(track, samples);
        let rotations = |x: f64| {
            let value = R::sample(samples, x - first, sampling)?;
            Some(rigid.map_or(value, |rigid| self.turn(value, &rigid)))
        };
        let locations = |x: f64| {
            let value = DVec3::sample(samples, x - first, sampling)?;
            Some(rigid.map_or(value, |rigid| self.shift(value, &rigid)))
        };
        let rotation = (!samples.rotations.is_empty()).then(|| lay_over(&self.rotation.keys, rotations, manner));
        let location = (!samples.translations.is_empty()).then(|| lay_over(&self.location.keys, locations, manner));
        let borders = rotation.as_ref().map(|laid| laid.borders).or(location.as_ref().map(|laid| laid.borders));
        if let Some(laid) = rotation {
            self.rotation.take(laid);
        }
        if let Some(laid) = location {
            self.location.take(laid);
        }
        let mut events = vec![Event::Laid];
        events.extend(Event::of_borders(borders.unwrap_or_default(), track.blend_depth));
        if track.track.preserve.is_some() && self.bone.parent.is_none() {
            self.align_what_follows(track);
            events.push(Event::RootAligned);
        }
        events
    }

    fn filter(&mut self, filter: &FilterEntry) -> Vec<Event> {
        self.rotation.filter(filter, &self.frame);
        self.location.filter(filter, &self.frame);
        if self.rotation.keys.0.is_empty() && self.location.keys.0.is_empty() {
            Vec::new()
        } else {
            vec![Event::Filtered]
        }
    }

    /// The root in armature space.
    fn pose(&self, rotation: Option<R>, location: Option<DVec3>) -> RootPose {
        let rest = self.bone.rest_rotation;
        RootPose {
            position: self.bone.rest_head + rest * location.unwrap_or_default(),
            rotation: rest * rotation.map_or(DQuat::IDENTITY, Rotation::rotation),
        }
    }

    fn turn(&self, value: R, rigid: &Rigid) -> R {
        let moved = rigid.apply(self.pose(Some(value), None));
        value.turned_to(self.bone.rest_rotation.conjugate() * moved.rotation, &self.frame)
    }

    fn shift(&self, location: DVec3, rigid: &Rigid) -> DVec3 {
        let moved = rigid.apply(self.pose(None, Some(location)));
        self.bone.rest_rotation.conjugate() * (moved.position - self.bone.rest_head)
    }

    /// Where the new motion is to be moved so that it goes on from the old root; `None` where there is none.
    fn rigid_start(&self, track: &PreparedTrack<'_>, samples: &BoneMotion) -> Option<Rigid> {
        let alignment = track.track.preserve.filter(|_| self.bone.parent.is_none())?;
        let begins_before =
            |range: Option<(f64, f64)>| range.is_some_and(|(first, _)| first < track.placement.start - SAME_FRAME);
        if !begins_before(self.rotation.keys.range()) && !begins_before(self.location.keys.range()) {
            return None;
        }
        let before = track.placement.start - 1.0;
        let old = self.pose(self.rotation.keys.at(before), self.location.keys.at(before));
        let at = track.placement.file_frame(track.placement.start) - track.motion.first_frame as f64;
        let sampling = track.track.sampling;
        let new = self.pose(R::sample(samples, at, sampling), DVec3::sample(samples, at, sampling));
        Some(align(old, new, self.up, alignment))
    }

    /// Moves what follows the track so that it goes on from where the track ended.
    fn align_what_follows(&mut self, track: &PreparedTrack<'_>) {
        let Some(alignment) = track.track.preserve else { return };
        let end = track.placement.end;
        let ends_after = |range: Option<(f64, f64)>| range.is_some_and(|(_, last)| last > end + SAME_FRAME);
        if !ends_after(self.rotation.keys.range()) && !ends_after(self.location.keys.range()) {
            return;
        }
        let ended = self.pose(self.rotation.keys.at(end), self.location.keys.at(end));
        let follows = self.pose(self.rotation.keys.at(end + 1.0), self.location.keys.at(end + 1.0));
        let rigid = align(ended, follows, self.up, alignment);

        let turned: Vec<R> = following(&self.rotation.keys, end).map(|key| self.turn(key.value, &rigid)).collect();
        let shifted: Vec<DVec3> =
            following(&self.location.keys, end).map(|key| self.shift(key.value, &rigid)).collect();
        let last_turn = self.rotation.keys.at(end);
        replace_following(&mut self.rotation, end, turned, last_turn, &self.frame);
        let last_shift = self.location.keys.at(end);
        replace_following(&mut self.location, end, shifted, last_shift, &self.frame);
    }
}

fn following<V: Copy>(keys: &Keys<V>, end: f64) -> impl Iterator<Item = &Key<V>> {
    keys.0.iter().filter(move |key| key.frame > end + SAME_FRAME)
}

fn replace_following<V: Value>(
    lane: &mut Lane<V>,
    end: f64,
    mut values: Vec<V>,
    neighbour: Option<V>,
    frame: &EulerFrame,
) {
    let Some((_, last)) = lane.keys.range().filter(|_| !values.is_empty()) else { return };
    if let Some(neighbour) = neighbour {
        V::go_on_from(&mut values, neighbour, frame);
    }
    let from = lane.keys.0.len() - values.len();
    for (key, value) in lane.keys.0[from..].iter_mut().zip(values) {
        key.value = value;
    }
    // The border is crossed in one go now: no seam is left to step over.
    if let Some(border) = from.checked_sub(1).and_then(|index| lane.keys.0.get_mut(index)) {
        if border.interpolation == Interpolation::Constant {
            border.interpolation = Interpolation::Linear;
        }
    }
    lane.touch((end, last));
}
