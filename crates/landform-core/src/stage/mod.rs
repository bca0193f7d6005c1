//! Stages by name, as recipes use them, and how they are run.
//!
//! A [`Stage`] is a row of a table: a name, a description of its parameters, and a function for
//! each kind of terrain. Every phenomenon exports its own rows, made by [`stages!`](crate::stages).
//! Only the facade has a list of all; it joins the rows. Parameters are read once, to a
//! [`ReadStage`].

mod parameters;
mod read;
mod row;

pub use parameters::Refusal;
pub use read::{ReadStage, bytes_a_node_of, warnings_of};
pub use row::{Act, Form, Run, Stage, Verb};

#[doc(hidden)]
pub use row::{convert, edit, export, generate, measure, process};

/// The rows of a phenomenon: each stage once, with the kinds of terrain that it runs on.
///
/// ```ignore
/// stages! {
///     generate StreamGraph => Mesh;
///     edit Add where HeightField, Mesh;
///     convert ToHeightField where Mesh => HeightField;
///     process Uplift where HeightField, Mesh;
///     measure MeasureSummary where HeightField, Mesh;
///     export WriteRaster where HeightField;
/// }
/// ```
#[macro_export]
macro_rules! stages {
    ($($verb:ident $params:ty $(where $($on:ty),+)? $(=> $to:ty)?;)*) => {
        /// The rows of the table of stages.
        pub static STAGES: &[$crate::stage::Stage] = &[$($crate::stages!(@row $verb $params, [$($($on),+)?], [$($to)?])),*];
    };
    (@row generate $params:ty, [], [$to:ty]) => {
        $crate::stage::Stage {
            module: module_path!(),
            acts: &[$crate::stage::generate::<$params, $to>()],
            ..$crate::stage::Stage::new::<$params>($crate::stage::Verb::Generate, &[])
        }
    };
    (@row edit $params:ty, [$($on:ty),+], []) => {
        $crate::stage::Stage {
            module: module_path!(),
            acts: &[$($crate::stage::edit::<$params, $on>()),+],
            ..$crate::stage::Stage::new::<$params>($crate::stage::Verb::Edit, &[])
        }
    };
    (@row convert $params:ty, [$on:ty], [$to:ty]) => {
        $crate::stage::Stage {
            module: module_path!(),
            acts: &[$crate::stage::convert::<$params, $on, $to>()],
            ..$crate::stage::Stage::new::<$params>($crate::stage::Verb::Convert, &[])
        }
    };
    (@row process $params:ty, [$first:ty $(, $on:ty)*], []) => {
        $crate::stage::Stage {
            module: module_path!(),
            acts: &[$crate::stage::process::<$params, $first>() $(, $crate::stage::process::<$params, $on>())*],
            ..$crate::stage::Stage::new::<$params>(
                $crate::stage::Verb::Process,
                <$params as $crate::verb::Process<$first>>::WRITES,
            )
        }
    };
    (@row measure $params:ty, [$($on:ty),+], []) => {
        $crate::stage::Stage {
            module: module_path!(),
            acts: &[$($crate::stage::measure::<$params, $on>()),+],
            ..$crate::stage::Stage::new::<$params>($crate::stage::Verb::Measure, &[])
        }
    };
    (@row export $params:ty, [$($on:ty),+], []) => {
        $crate::stage::Stage {
            module: module_path!(),
            acts: &[$($crate::stage::export::<$params, $on>()),+],
            ..$crate::stage::Stage::new::<$params>($crate::stage::Verb::Export, &[])
        }
    };
}
