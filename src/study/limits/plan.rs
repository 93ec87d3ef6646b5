//! The list of limits: what is run, what comes out, and how it is judged and shown.

use serde::Serialize;

use crate::case::Judged;
use crate::error::Error;
use crate::study::Planned;
use crate::study::limits::row::{Detail, Limit};
use crate::study::limits::{
    body_end, cycling, distorted, gauss_points, incompressible, large_contact, layer_thickness, no_load, non_matching,
    pulled_apart, short_candidates, small_load, springs, unequal_sizes,
};

/// Declares the limits in the order of the page: each file has `run`, and what comes out has `judge`, `limit` and `detail`.
macro_rules! limits {
    ($($trial:literal: $Limit:ident in $file:ident),* $(,)?) => {
        /// What was found when one thing was pushed.
        #[derive(Clone, Debug, Serialize)]
        pub enum Numbers {
            $(#[doc = concat!("The trial `", $trial, "`.")] $Limit($file::$Limit)),*
        }

        /// A trial for each limit.
        pub fn plan() -> Vec<Planned<Numbers>> {
            vec![$(Planned::new("limits", $trial, || $file::run().map(Numbers::$Limit))),*]
        }

        /// The checks.
        pub fn judge(numbers: &Numbers) -> Result<Vec<Judged>, Error> {
            Ok(match numbers {
                $(Numbers::$Limit(found) => found.judge()),*
            })
        }

        impl Numbers {
            /// Its row of the table of limits.
            pub fn limit(&self) -> Limit {
                match self {
                    $(Self::$Limit(found) => found.limit()),*
                }
            }

            /// The table behind the row; none where the row says all.
            pub fn detail(&self) -> Option<Detail> {
                match self {
                    $(Self::$Limit(found) => found.detail()),*
                }
            }
        }
    };
}

limits! {
    "three Gauss points": ThreeGaussPoints in gauss_points,
    "spring stiffness": SpringStiffness in springs,
    "supported by contact alone": PulledApart in pulled_apart,
    "zero load": NoLoad in no_load,
    "load too small for the mesh": SmallLoad in small_load,
    "candidates too short": ShortCandidates in short_candidates,
    "surface too short": BodyEnd in body_end,
    "near incompressibility": Incompressible in incompressible,
    "distorted cells": Distorted in distorted,
    "element sizes across the interface": UnequalSizes in unequal_sizes,
    "non-matching meshes": NonMatching in non_matching,
    "layer thickness": LayerThickness in layer_thickness,
    "a/R": LargeContact in large_contact,
    "cycling": Cycling in cycling,
}
