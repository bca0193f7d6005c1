//! Read-only measures of a terrain.

mod card;
pub mod cave;
mod coast;
mod compare;
mod conduits;
mod directions;
mod dunes;
mod features;
mod form;
mod hypsometry;
mod metrics;
mod network;
mod spectrum;
mod summary;
mod surface;
mod variogram;
mod waters;

pub use card::{CardLine, Verdict, report_card, verdict};
pub use coast::{
    Coast, Dimension, Divider, box_counts, coast, dimension_by_boxes, dimension_by_divider, divider_steps, project,
};
pub use compare::{Comparison, compare};
pub use conduits::{NaturalRange, NetworkStatistics, Pattern, network_statistics};
pub use directions::{Directions, Gate, directions, directions_of};
pub use dunes::{DuneClass, Dunes, ShadowError, dunes, shadow_error};
pub use features::{FeatureSearch, find_features};
pub use form::{Form, form, form_of, share_in_sinks};
pub use hypsometry::{HypsometricClass, Hypsometry, ModelCurve, classify, hypsometry, of_sorted};
pub use metrics::{Drawings, Elevations, Metrics, SPECTRUM_PLOT, metrics};
pub use network::{
    Chi, Horton, Network, NetworkScaling, NetworkSizes, ProfileNode, ProfileSearch, RiverProfile, SlopeArea, carved,
    channel_area, chi_profile, horton, network, network_scaling, river_profiles, scaling, slope_area, slope_area_of,
};
pub use spectrum::{
    Density, LEAST_WINDOW, LogBin, PowerLaw, Ring, Spectrum, ThesisFit, Transects, Window, density, largest_square,
    of_density, spectrum, thesis_fit, transects,
};
pub use summary::{Summary, summary};
pub use surface::{REPOSE, Surface, surface};
pub use variogram::{LAGS, Variogram, variogram};
pub use waters::{Basin, Drainage, Lake, Polygon, RiverReach, Width, basins, lakes, rivers};
