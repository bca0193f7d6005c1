//! A process with its state, behind one interface.

use crate::terrain::Terrain;
use crate::verb::{Change, Context, Environment, Process, Step};
use crate::{Error, Result};

/// The interface of a process for the driver, for any of its types.
pub(super) trait Running<T: Terrain>: Send {
    fn name(&self) -> &'static str;
    fn start(&mut self, terrain: &mut T, context: &Context) -> Result<()>;
    fn reconcile(&mut self, terrain: &mut T, context: &Context) -> Result<()>;
    fn is_at_rest(&self, terrain: &T) -> bool;
    fn is_short_of_its_end(&self, terrain: &T) -> bool;
    fn max_step(&self, terrain: &T) -> Option<f64>;
    fn begin(&mut self, terrain: &T, at: &Step) -> Result<()>;
    fn step(&mut self, terrain: &mut T, at: &Step) -> Result<Change>;
    fn finish(&mut self, terrain: &mut T, environment: &Environment) -> Result<()>;
    fn note(&self, terrain: &T) -> Option<String>;
    fn save(&self) -> Result<Vec<u8>>;
    fn load(&mut self, bytes: &[u8]) -> Result<()>;
}

/// A process and, once started, its state.
pub(super) struct Run<P, S> {
    pub(super) params: P,
    pub(super) state: Option<S>,
}

impl<T: Terrain, P: Process<T>> Running<T> for Run<P, P::State> {
    fn name(&self) -> &'static str {
        P::NAME
    }

    fn start(&mut self, terrain: &mut T, context: &Context) -> Result<()> {
        self.state = Some(self.params.start(terrain, context)?);
        Ok(())
    }

    fn reconcile(&mut self, terrain: &mut T, context: &Context) -> Result<()> {
        match &mut self.state {
            Some(state) => self.params.reconcile(terrain, state, context),
            None => self.start(terrain, context),
        }
    }

    fn is_at_rest(&self, terrain: &T) -> bool {
        self.state.as_ref().is_some_and(|s| self.params.is_at_rest(terrain, s))
    }

    fn is_short_of_its_end(&self, terrain: &T) -> bool {
        self.state.as_ref().is_some_and(|s| self.params.is_short_of_its_end(terrain, s))
    }

    fn max_step(&self, terrain: &T) -> Option<f64> {
        self.state.as_ref().and_then(|s| self.params.max_step(terrain, s))
    }

    fn begin(&mut self, terrain: &T, at: &Step) -> Result<()> {
        let state = self.state.as_mut().ok_or_else(|| not_started(P::NAME))?;
        self.params.begin(terrain, state, at)
    }

    fn step(&mut self, terrain: &mut T, at: &Step) -> Result<Change> {
        let state = self.state.as_mut().ok_or_else(|| not_started(P::NAME))?;
        self.params.step(terrain, state, at)
    }

    fn finish(&mut self, terrain: &mut T, environment: &Environment) -> Result<()> {
        let state = self.state.as_mut().ok_or_else(|| not_started(P::NAME))?;
        self.params.finish(terrain, state, environment)
    }

    fn note(&self, terrain: &T) -> Option<String> {
        self.state.as_ref().and_then(|s| self.params.note(terrain, s))
    }

    fn save(&self) -> Result<Vec<u8>> {
        postcard::to_stdvec(&self.state).map_err(|e| Error::format("process state", e))
    }

    fn load(&mut self, bytes: &[u8]) -> Result<()> {
        self.state = postcard::from_bytes(bytes).map_err(|e| Error::format("process state", e))?;
        Ok(())
    }
}

fn not_started(name: &str) -> Error {
    Error::parameter(name, "not started", "a call of `start` before `step`")
}
