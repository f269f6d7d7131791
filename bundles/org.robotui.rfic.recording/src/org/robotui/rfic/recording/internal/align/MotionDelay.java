package org.robotui.rfic.recording.internal.align;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalLong;
import org.robotui.api.replay.OffsetEstimate;

/** By how much one series comes later than another one, by the peak of their correlation. */
final class MotionDelay {
  private static final long STEP = 50_000_000L;
  private static final double SECOND = 1e9;
  /** Ten minutes at the step. */
  private static final int MOST_LAGS = 12_000;
  private static final int LEAST_STEPS = 100;
  private static final int LONGEST = 24_000;
  /** Below it something else was measured. */
  private static final double LEAST_ALIKE = 0.7;
  /** A second peak as high as this share of the first one leaves open which of them is right. */
  private static final double RIVAL = 0.92;
  /** Nearer ones belong to the peak itself. */
  private static final int PEAK_WIDTH = 40;

  private final EvenSeries reference;
  private final EvenSeries moved;
  private final int least;

  private MotionDelay(EvenSeries reference, EvenSeries moved) {
    this.reference = reference;
    this.moved = moved;
    this.least = Math.max(LEAST_STEPS, Math.min(reference.size(), moved.size()) / 2);
  }

  /** What is to be added to the times of the second one; empty where that cannot be told. */
  static Optional<OffsetEstimate> offset(TurningRates.Rate reference, TurningRates.Rate moved) {
    if (isShort(reference.samples()) || isShort(moved.samples())) {
      return Optional.empty();
    }
    long longest = Math.max(span(reference.samples()), span(moved.samples()));
    long step = Math.max(STEP, longest / LONGEST);
    MotionDelay delay =
        new MotionDelay(EvenSeries.of(reference.samples(), step), EvenSeries.of(moved.samples(), step));
    return delay.estimate(reference.port(), moved.port());
  }

  private static boolean isShort(List<TurningRates.Sample> samples) {
    return samples.size() < LEAST_STEPS || span(samples) < LEAST_STEPS * STEP;
  }

  private static long span(List<TurningRates.Sample> samples) {
    return samples.getLast().time() - samples.getFirst().time();
  }

  private Optional<OffsetEstimate> estimate(String referencePort, String movedPort) {
    int begin = Math.max(-MOST_LAGS, least - moved.size());
    int end = Math.min(MOST_LAGS, reference.size() - least);
    double[] alike = new double[Math.max(0, end - begin + 1)];
    int best = -1;
    for (int i = 0; i < alike.length; i++) {
      // A sensor that hangs upside down turns the other way round.
      alike[i] = Math.abs(reference.correlation(moved, begin + i, least));
      best = Double.isFinite(alike[i]) && (best < 0 || alike[i] > alike[best]) ? i : best;
    }
    if (best < 0 || alike[best] < LEAST_ALIKE || hasRival(alike, best)) {
      return Optional.empty();
    }
    OptionalLong width = deviation(alike, best, begin + best);
    return width.isEmpty() ? Optional.empty()
        : Optional.of(new OffsetEstimate(offset(begin + best + refined(alike, best)), width.getAsLong(),
            String.format(Locale.ROOT, "%s turns as %s does (correlation %.0f %%)", movedPort, referencePort,
                100 * alike[best])));
  }

  /** From the lag to what is added to times: series begin at times of their own. */
  private long offset(double lag) {
    return reference.start() - moved.start() + Math.round(lag * reference.step());
  }

  private static boolean hasRival(double[] alike, int best) {
    for (int i = 1; i < alike.length - 1; i++) {
      boolean peak = alike[i] >= alike[i - 1] && alike[i] >= alike[i + 1];
      if (peak && Math.abs(i - best) > PEAK_WIDTH && alike[i] > RIVAL * alike[best]) {
        return true;
      }
    }
    return false;
  }

  /** The top of the parabola through the peak and its neighbours, in steps from the peak. */
  private static double refined(double[] alike, int best) {
    if (best == 0 || best == alike.length - 1) {
      return 0;
    }
    double bend = alike[best - 1] - 2 * alike[best] + alike[best + 1];
    return bend < 0 ? Math.clamp((alike[best - 1] - alike[best + 1]) / (2 * bend), -0.5, 0.5) : 0;
  }

  /**
   * The deviation of a delay that is found by correlation: sqrt((1 - r2) / (r2 n b2)), where b2 is how sharp the peak
   * is and n how many values are of each other's independent.
   */
  private OptionalLong deviation(double[] alike, int best, int lag) {
    if (best == 0 || best == alike.length - 1) {
      return OptionalLong.empty();
    }
    double seconds = reference.step() / SECOND;
    double sharpness = (2 * alike[best] - alike[best - 1] - alike[best + 1]) / (alike[best] * seconds * seconds);
    if (!(sharpness > 0)) {
      return OptionalLong.empty();
    }
    int overlap = Math.min(reference.size(), moved.size() + lag) - Math.max(0, lag);
    double independent = Math.max(2, overlap * seconds * Math.sqrt(sharpness));
    double square = Math.min(alike[best] * alike[best], 1 - 1e-6);
    double deviation = Math.sqrt((1 - square) / (square * independent * sharpness));
    return OptionalLong.of(Math.round(Math.max(deviation, seconds / 20) * SECOND));
  }
}
