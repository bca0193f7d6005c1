//! Measures without parameters of their own.

use landform_core::Result;
use landform_core::algo::thin_plate::bending_energy;
use landform_core::analysis::{
    Directions, Drainage, Form, Hypsometry, Network, Spectrum, Surface, Transects, Variogram, directions_of, form_of,
    hypsometry, network, spectrum, surface, transects, variogram,
};
use landform_core::terrain::{NodeSurface, Rasterize};
use landform_core::verb::{Landscape, Measure, Params, Source, check_path};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

const STRAHLER: Source = Source {
    authors: "Strahler (1952)",
    title: "Hypsometric (area-altitude) analysis of erosional topography, GSA Bulletin 63",
    doi: "10.1130/0016-7606(1952)63[1117:HAAOET]2.0.CO;2",
};
const SAUPE: Source = Source {
    authors: "Saupe (1988)",
    title: "Algorithms for random fractals, in: The Science of Fractal Images, Springer",
    doi: "10.1007/978-1-4612-3784-6_2",
};
const PERRON: Source = Source {
    authors: "Perron, Kirchner & Dietrich (2008)",
    title: "Spectral signatures of characteristic spatial scales and nonfractal structure in landscapes, Journal of Geophysical Research 113",
    doi: "10.1029/2007JF000866",
};
const HORTON: Source = Source {
    authors: "Horton (1945)",
    title: "Erosional development of streams and their drainage basins, GSA Bulletin 56",
    doi: "10.1130/0016-7606(1945)56[275:EDOSAT]2.0.CO;2",
};
const CHI: Source = Source {
    authors: "Perron & Royden (2013)",
    title: "An integral approach to bedrock river profile analysis, Earth Surface Processes and Landforms 38",
    doi: "10.1002/esp.3302",
};
const HORN: Source = Source {
    authors: "Horn (1981)",
    title: "Hill shading and the reflectance map, Proceedings of the IEEE 69(1)",
    doi: "10.1109/PROC.1981.11918",
};
const EVANS: Source = Source {
    authors: "Evans (1972)",
    title: "General geomorphometry, derivatives of altitude, and descriptive statistics, in: Spatial Analysis in Geomorphology, Methuen",
    doi: "",
};

/// A stage whose only parameter is the path of its file.
macro_rules! measure {
    ($(#[$doc:meta])* $name:ident, $stage:literal, $path:literal, [$($source:expr),*], $out:ty, |$raster:ident| $body:expr) => {
        $(#[$doc])*
        #[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
        #[serde(default, deny_unknown_fields)]
        pub struct $name {
            /// Path below the output folder.
            pub path: String,
        }

        impl Default for $name {
            fn default() -> Self {
                Self { path: $path.into() }
            }
        }

        impl Params for $name {
            const NAME: &'static str = $stage;
            const SOURCES: &'static [Source] = &[$($source),*];

            fn outputs(&self) -> Vec<String> {
                vec![self.path.clone()]
            }

            fn check(&self) -> Result<()> {
                check_path(&self.path, &["json"])
            }
        }

        impl<T: Rasterize> Measure<T> for $name {
            type Out = $out;

            fn path(&self) -> &str {
                &self.path
            }

            fn measure(&self, landscape: &Landscape<'_, T>) -> Result<$out> {
                let $raster = landscape.terrain.rasterized()?;
                Ok($body)
            }
        }
    };
}

measure!(
    /// Measures hypsometry, the area of ground at each height: the hypsometric curve, its integral
    /// and skew, Strahler's model and class.
    MeasureHypsometry, "measure_hypsometry", "hypsometry.json", [STRAHLER], Hypsometry, |raster| hypsometry(raster.elevation())
);

/// Spectrum, profiles and variogram.
#[derive(Clone, Debug, Serialize)]
pub struct SpectrumMeasured {
    /// Spectrum of the surface; none if no square of 32 nodes a side has data.
    pub spectrum: Option<Spectrum>,
    /// Spectra of its rows and columns, with the spacing of valleys that stands out.
    pub transects: Option<Transects>,
    /// Differences against distance.
    pub variogram: Variogram,
}

measure!(
    /// Measures the spectrum, the relief at every wavelength: spectral density, its exponents, the
    /// spacing that stands out, the variogram.
    MeasureSpectrum, "measure_spectrum", "spectrum.json", [SAUPE, PERRON], SpectrumMeasured, |raster| {
        let (grid, z) = (raster.grid(), raster.elevation());
        let spectrum = spectrum(grid, z);
        SpectrumMeasured {
            transects: spectrum.as_ref().and_then(|s| transects(grid, z, s.window)),
            spectrum,
            variogram: variogram(grid, z),
        }
    }
);

/// The drainage network.
pub type DrainageMeasured = Network;

measure!(
    /// Measures the drainage network: exponents of area and length, slope against area, chi, stream
    /// orders and ratios, density.
    MeasureDrainage, "measure_drainage", "drainage.json", [HORTON, CHI], DrainageMeasured, |raster| {
        network(&Drainage::with_open_holes(&*raster), raster.elevation())
    }
);

measure!(
    /// Measures whether the ground shows the lattice that it was made on: directions of slopes and
    /// channels, facets, one slope everywhere, sharp hollows. Each number comes with the range that
    /// it has on real ground.
    MeasureDirections, "measure_directions", "directions.json", [HORN], Directions, |raster| directions_of(&raster)
);

/// Slopes and shapes.
#[derive(Clone, Debug, Serialize)]
pub struct SurfaceMeasured {
    /// Slopes, directions, curvature; none if no node has eight neighbours with data.
    pub surface: Option<Surface>,
    /// Pits, peaks, sinks.
    pub form: Form,
    /// Half the integral over the map of z_xx² + 2 z_xy² + z_yy²: the energy that a thin plate of
    /// this shape holds (without unit); none where cells are not square.
    pub bending_energy: Option<f64>,
}

measure!(
    /// Measures the surface: slopes, directions, curvature, relief, pits, peaks and sinks, bending
    /// energy.
    MeasureSurface, "measure_surface", "surface.json", [HORN, EVANS], SurfaceMeasured, |raster| SurfaceMeasured {
        surface: surface(raster.grid(), raster.elevation()),
        form: form_of(raster.grid(), &raster.domain(), raster.elevation()),
        bending_energy: (raster.grid().spacing[0] == raster.grid().spacing[1])
            .then(|| bending_energy(raster.grid().shape, raster.elevation()) / raster.grid().cell_area()),
    }
);
