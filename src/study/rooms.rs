//! The list of studies: what a room must have, and how the page meets all of them.

/// The rooms, in the order of the page. Each is a module with
///
/// * `ABOUT: About` — what its page is called, what it asks, and what it cannot tell,
/// * `plan() -> Vec<Planned<Numbers>>` — what is run,
/// * `Numbers` — what came out,
/// * `judge(&Numbers) -> Result<Vec<Judged>, Error>` — the checks with their verdicts,
/// * `section(&[Found<Numbers>]) -> Result<String, Error>` — Markdown,
/// * `pictures(&[Found<Numbers>]) -> Result<Vec<(String, Drawing)>, Error>` — file names and charts.
macro_rules! rooms {
    ($($(#[$about:meta])* $Room:ident in $room:ident),* $(,)?) => {
        /// A study.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
        pub enum Room {
            $($(#[$about])* $Room),*
        }

        /// What a trial of any study came out with; a few hundred of them are not worth a box.
        #[allow(clippy::large_enum_variant)]
        #[derive(Clone, Debug)]
        pub enum Numbers {
            $($(#[$about])* $Room($room::Numbers)),*
        }

        impl Room {
            /// All, in the order of the page.
            pub const ALL: &'static [Self] = &[$(Self::$Room),*];

            /// What its page is called, what it asks, and what it cannot tell.
            pub fn about(self) -> About {
                match self {
                    $(Self::$Room => $room::ABOUT,)*
                }
            }

            /// Name of its folder, which its page has too.
            pub fn name(self) -> &'static str {
                match self {
                    $(Self::$Room => stringify!($room),)*
                }
            }

            /// Its trials.
            pub fn plan(self) -> Vec<Trial> {
                match self {
                    $(Self::$Room => {
                        $room::plan().into_iter().map(|planned| judged(planned, self, Numbers::$Room)).collect()
                    })*
                }
            }

            /// Its part of the page, without the table of its checks.
            pub fn section(self, findings: &[Finding]) -> Result<String, Error> {
                match self {
                    $(Self::$Room => $room::section(&rooms!(@found findings, $Room)),)*
                }
            }

            /// Its charts for light and dark pages: file names and SVG.
            pub fn pictures(self, findings: &[Finding]) -> Result<Vec<(String, String)>, Error> {
                match self {
                    $(Self::$Room => {
                        let drawn = $room::pictures(&rooms!(@found findings, $Room))?;
                        $crate::study::drawn::written(&drawn)
                    })*
                }
            }
        }

        impl Numbers {
            /// The checks of its study with their verdicts.
            pub fn judge(&self) -> Result<Vec<Judged>, Error> {
                match self {
                    $(Self::$Room(numbers) => $room::judge(numbers),)*
                }
            }
        }
    };
    (@found $findings:ident, $Room:ident) => {
        $findings
            .iter()
            .filter_map(|Finding { case, name, numbers, judged, .. }| match numbers {
                Numbers::$Room(numbers) => Some(Found { case, name, numbers, judged }),
                _ => None,
            })
            .collect::<Vec<_>>()
    };
}

pub(super) use rooms;
