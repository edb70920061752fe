//! Work on the components of vectors, angles or quaternions as channels of numbers.

/// Returns samples each component of which `work` made from that component's channel.
///
/// `work` gets the channel over all frames, and as many results to fill.
pub(crate) fn by_component<const N: usize>(samples: &[[f64; N]], work: impl Fn(&[f64], &mut [f64])) -> Vec<[f64; N]> {
    let mut results = vec![[0.0; N]; samples.len()];
    let mut channel_results = vec![0.0; samples.len()];
    for component in 0..N {
        let channel: Vec<f64> = samples.iter().map(|sample| sample[component]).collect();
        work(&channel, &mut channel_results);
        for (result, &value) in results.iter_mut().zip(&channel_results) {
            result[component] = value;
        }
    }
    results
}
