//! What one file holds, whatever its format.

use super::Format;
use crate::error::MisfitError;
use crate::formats::amc::Amc;
use crate::formats::asf::Asf;
use crate::formats::bvh::Bvh;
use crate::formats::c3d::C3d;
use crate::formats::csm::Csm;
use crate::formats::trc::Trc;
use crate::infer::Inference;
use crate::markers::Markers;
use crate::motion::Motion;
use crate::skeleton::Skeleton;
use std::sync::{Arc, OnceLock};

/// What one file holds. What a format does not have is `None`.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Clip {
    /// What kind of file it is.
    pub format: Format,
    /// What the file says, where it is an Acclaim skeleton.
    pub asf: Option<Asf>,
    /// What the file says, where it is an Acclaim motion.
    pub amc: Option<Amc>,
    /// What the file says, where it is a BVH.
    pub bvh: Option<Bvh>,
    /// What the file says, where it is a C3D.
    pub c3d: Option<C3d>,
    /// What the file says, where it is a CSM.
    pub csm: Option<Csm>,
    /// What the file says, where it is a TRC.
    pub trc: Option<Trc>,
    /// The file's own skeleton.
    pub skeleton: Option<Skeleton>,
    /// The file's motion, on its own skeleton or the one that was given; an AMC has none without.
    pub motion: Option<Motion>,
    notices: Vec<String>,
    named: Named,
}

/// Markers with their notices; those of a C3D from when they are first asked for.
#[derive(Debug, Clone, Default)]
struct Named(OnceLock<(Arc<Markers>, Vec<String>)>);

/// They follow from what the file says, which a clip holds as well.
impl PartialEq for Named {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

/// Returns what was inferred, with the reasons.
fn inferred(inference: &Inference) -> [String; 3] {
    let Inference { unit_m, up, facing, .. } = inference;
    [("Length unit", &unit_m.reason), ("Up axis", &up.reason), ("Facing", &facing.reason)]
        .map(|(what, reason)| format!("{what}: {reason}"))
}

/// Says what was inferred, but for [`Clip::facing_notice`], besides what the user should know anyway.
fn named((markers, mut notices): (Markers, Vec<String>)) -> (Arc<Markers>, Vec<String>) {
    notices.push(format!("Length unit: {}", markers.unit.reason));
    notices.push(format!("Up axis: {}", markers.up.reason));
    (Arc::new(markers), notices)
}

impl Clip {
    fn new(format: Format) -> Self {
        Self {
            format,
            asf: None,
            amc: None,
            bvh: None,
            c3d: None,
            csm: None,
            trc: None,
            skeleton: None,
            motion: None,
            notices: Vec::new(),
            named: Named::default(),
        }
    }

    /// Takes a skeleton, and says what was inferred.
    pub(super) fn of_asf(asf: Asf) -> Self {
        let (skeleton, inference) = asf.skeleton_and_inference();
        let mut notices = asf.notices();
        notices.extend(inferred(&inference));
        Self { asf: Some(asf), skeleton: Some(skeleton), notices, ..Self::new(Format::Asf) }
    }

    /// Takes a motion: on a skeleton, with what the user should know of both, or without.
    pub(crate) fn of_amc(amc: Amc, bound: Option<(Motion, Vec<String>)>) -> Self {
        let (motion, notices) = match bound {
            Some((motion, notices)) => (Some(motion), notices),
            None => (None, amc.notices()),
        };
        Self { amc: Some(amc), motion, notices, ..Self::new(Format::Amc) }
    }

    /// Takes a motion with its skeleton, and says what was inferred.
    pub(crate) fn of_bvh(bvh: Bvh) -> Self {
        let (skeleton, motion, inference) = bvh.skeleton_motion_and_inference();
        Self { motion, ..Self::of_bvh_without_motion(bvh, skeleton, &inference) }
    }

    /// Takes a skeleton alone with what was inferred from the motion too, some of which may be enough for that.
    pub(crate) fn of_skimmed_bvh(bvh: Bvh) -> Self {
        let (skeleton, inference) = bvh.skeleton_and_inference();
        Self::of_bvh_without_motion(bvh, skeleton, &inference)
    }

    fn of_bvh_without_motion(bvh: Bvh, skeleton: Skeleton, inference: &Inference) -> Self {
        let mut notices = bvh.notices();
        notices.extend(inferred(inference));
        Self { bvh: Some(bvh), skeleton: Some(skeleton), notices, ..Self::new(Format::Bvh) }
    }

    /// Takes a file of markers; what there is to say of them is said when it is asked for.
    pub(super) fn of_c3d(c3d: C3d) -> Self {
        Self { c3d: Some(c3d), ..Self::new(Format::C3d) }
    }

    /// Takes a file of markers with these and what the user should know of them, and says what was inferred.
    pub(crate) fn of_csm(csm: Csm, markers: (Markers, Vec<String>)) -> Self {
        let named = Named(OnceLock::from(named(markers)));
        Self { csm: Some(csm), named, ..Self::new(Format::Csm) }
    }

    /// The same of a TRC.
    pub(crate) fn of_trc(trc: Trc, markers: (Markers, Vec<String>)) -> Self {
        let named = Named(OnceLock::from(named(markers)));
        Self { trc: Some(trc), named, ..Self::new(Format::Trc) }
    }

    /// Returns the file's markers. Those of a C3D are named, and their unit and up axis worked out, when they are first asked
    /// for: their numbers stay where they lie in the file anyway.
    pub fn markers(&self) -> Option<&Arc<Markers>> {
        self.named().map(|(markers, _)| markers)
    }

    /// Returns what is odd in the file, and what was inferred, a sentence each.
    pub fn notices(&self) -> &[String] {
        self.named().map_or(&self.notices, |(_, notices)| notices)
    }

    /// Works out which way markers face, as a notice: for those who show it, and not for each file that is read.
    pub fn facing_notice(&self) -> Option<String> {
        Some(format!("Facing: {}", self.markers()?.facing().reason))
    }

    fn named(&self) -> Option<&(Arc<Markers>, Vec<String>)> {
        match &self.c3d {
            Some(c3d) => Some(self.named.0.get_or_init(|| named(c3d.markers()))),
            None => self.named.0.get(),
        }
    }

    /// Returns whether the file holds markers.
    pub fn has_markers(&self) -> bool {
        self.c3d.is_some() || self.named.0.get().is_some()
    }

    /// Returns the file anew: the same values, names and order.
    pub fn to_bytes(&self) -> Vec<u8> {
        let asf = self.asf.as_ref().map(Asf::to_bytes);
        let c3d = || self.c3d.as_ref().map(C3d::to_bytes);
        let csm = || self.csm.as_ref().map(Csm::to_bytes);
        let trc = || self.trc.as_ref().map(Trc::to_bytes);
        let amc = || self.amc.as_ref().map(Amc::to_bytes);
        let bvh = || self.bvh.as_ref().map(Bvh::to_bytes);
        asf.or_else(amc).or_else(bvh).or_else(c3d).or_else(csm).or_else(trc).unwrap_or_default()
    }

    /// Returns the file's skeleton alone as a file that gives the same one; nothing where it has none.
    pub fn skeleton_to_bytes(&self) -> Vec<u8> {
        let hierarchy = || self.bvh.as_ref().map(|bvh| Bvh::new(bvh.joints.clone(), None).to_bytes());
        self.asf.as_ref().map(Asf::to_bytes).or_else(hierarchy).unwrap_or_default()
    }

    /// Returns the names of the bones or markers, in file order.
    pub fn names(&self) -> Vec<String> {
        if let Some(markers) = self.markers() {
            return markers.names.clone();
        }
        match (&self.amc, &self.skeleton) {
            (Some(amc), _) => amc.bones.iter().map(|bone| bone.name.clone()).collect(),
            (None, Some(skeleton)) => skeleton.bones.iter().map(|bone| bone.name.clone()).collect(),
            (None, None) => Vec::new(),
        }
    }

    /// Returns how many frames of motion there are.
    pub fn frame_count(&self) -> usize {
        let of_bvh = || self.bvh.as_ref()?.motion.as_ref().map(|motion| motion.frame_count);
        let of_c3d = || self.c3d.as_ref().map(|c3d| c3d.layout().frame_count);
        let of_markers = || self.markers().map(|markers| markers.frame_count());
        let of_amc = self.amc.as_ref().map(|amc| amc.frame_count);
        of_amc.or_else(of_bvh).or_else(of_c3d).or_else(of_markers).unwrap_or(0)
    }

    /// Returns the file's own number of the first frame; 1 without motion.
    pub fn first_frame(&self) -> i64 {
        let of_c3d = || self.c3d.as_ref().map(|c3d| c3d.layout().first_frame);
        let of_markers = || self.markers().map(|markers| markers.first_frame);
        self.amc.as_ref().map(|amc| amc.first_frame).or_else(of_c3d).or_else(of_markers).unwrap_or(1)
    }

    /// Returns the frames per second; `None` where the file does not say.
    pub fn rate_hz(&self) -> Option<f64> {
        match (&self.amc, &self.bvh, &self.c3d) {
            (Some(amc), ..) => amc.header.rate_hz,
            (_, Some(bvh), _) => bvh.motion.as_ref()?.rate_hz(),
            (.., Some(c3d)) => c3d.layout().rate_hz,
            _ => self.markers()?.rate_hz,
        }
    }

    /// Whether the file's motion can be put on a skeleton: whether [`Clip::bind`] would find no misfit.
    pub fn fits(&self, skeleton: &Skeleton) -> bool {
        self.amc.as_ref().is_some_and(|amc| amc.fits(skeleton))
    }

    /// Returns the motion of an AMC on a skeleton, with what the user should know.
    ///
    /// # Errors
    /// Where the file has no motion, one of other bones, or one with a skeleton of its own.
    pub fn bind(&self, skeleton: &Skeleton) -> Result<(Motion, Vec<String>), MisfitError> {
        let why = if self.bvh.is_some() { "the file has a skeleton of its own" } else { "the file has no motion" };
        let no_motion = || MisfitError { bones: vec![why.to_owned()] };
        self.amc.as_ref().ok_or_else(no_motion)?.motion(skeleton)
    }
}
