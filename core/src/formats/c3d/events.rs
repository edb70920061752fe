//! Events: those of the group `EVENT`, or else those of the header.

use super::C3d;
use crate::markers::Event;

impl C3d {
    /// Returns what happened when. Times are in seconds, 0 is frame 1; `EVENT:TIMES` has minutes and seconds.
    pub fn events(&self) -> Vec<Event> {
        let times = self.numbers("EVENT", "TIMES");
        let used = self.parameter("EVENT", "USED").and_then(|used| used.count()).unwrap_or(times.len());
        let times = times.as_chunks::<2>().0.iter().take(used).map(|[minutes, seconds]| 60.0 * minutes + seconds);
        let times: Vec<f64> = times.take_while(|time| time.is_finite()).collect();
        if times.is_empty() {
            return self.header_events();
        }
        let mut texts = ["LABELS", "CONTEXTS", "SUBJECTS"].map(|name| self.texts("EVENT", name).into_iter());
        let events = times.into_iter().map(|time_s| {
            let [label, context, subject] = texts.each_mut().map(|texts| texts.next().unwrap_or_default());
            Event { label, context, subject, time_s }
        });
        events.collect()
    }

    fn header_events(&self) -> Vec<Event> {
        let events = self.header.events.iter().filter(|event| event.time_s.is_finite());
        let event = |event: &super::HeaderEvent| Event {
            label: event.label.clone(),
            time_s: event.time_s.into(),
            ..Event::default()
        };
        events.map(event).collect()
    }
}
