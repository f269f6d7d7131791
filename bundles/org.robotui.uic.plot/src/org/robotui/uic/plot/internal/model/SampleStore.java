package org.robotui.uic.plot.internal.model;

import java.util.Optional;
import org.robotui.uic.plot.internal.signal.Expr;
import org.robotui.uic.plot.internal.signal.Pipeline;
import org.robotui.uic.plot.internal.signal.ThinningPairs;
import org.robotui.uic.plot.internal.signal.ThinningSink;
import org.robotui.uic.plot.internal.trace.Curve;
import org.robotui.uic.plot.internal.trace.Series;

/** Where the samples of a signal are kept: one series, or the two of a curve. Filled by one thread, read by all. */
sealed interface SampleStore {
  /** With room for so many samples; of so many in a row only those are kept that show how far they go. */
  static SampleStore of(Expr expr, long samples, int every) {
    return expr instanceof Expr.Over over ? new Points(over, samples, every) : new Values(expr, samples, every);
  }

  /** How many samples in a row are thinned so that those expected find room; 1 where all do. */
  static int every(Expr expr, long expected, long room) {
    int kept = expr instanceof Expr.Over ? ThinningPairs.KEPT : 2;
    return expected > room
        ? Math.toIntExact(Math.min(Integer.MAX_VALUE, kept * Math.ceilDiv(expected, Math.max(1, room))))
        : 1;
  }

  Series series();

  Optional<Curve> curve();

  /** Forgets all; what computes the samples from now on. */
  Pipeline begin();

  /** Keeps what still waits: the end. */
  void flush();

  /** Of a signal over time. */
  final class Values implements SampleStore {
    private final Expr expr;
    private final Series series;
    private final ThinningSink thinning;

    private Values(Expr expr, long samples, int every) {
      this.expr = expr;
      this.series = new Series(samples);
      this.thinning = new ThinningSink(every, series::add);
    }

    @Override
    public Series series() {
      return series;
    }

    @Override
    public Optional<Curve> curve() {
      return Optional.empty();
    }

    @Override
    public Pipeline begin() {
      series.clear();
      return Pipeline.of(expr, thinning);
    }

    @Override
    public void flush() {
      thinning.flush();
    }
  }

  /** Of a signal over another one. */
  final class Points implements SampleStore {
    private final Expr.Over over;
    private final Curve curve;
    private final ThinningPairs thinning;

    private Points(Expr.Over over, long samples, int every) {
      this.over = over;
      this.curve = new Curve(samples);
      this.thinning = new ThinningPairs(every, curve::add);
    }

    @Override
    public Series series() {
      return curve.y();
    }

    @Override
    public Optional<Curve> curve() {
      return Optional.of(curve);
    }

    @Override
    public Pipeline begin() {
      curve.clear();
      return Pipeline.of(over, thinning);
    }

    @Override
    public void flush() {
      thinning.flush();
    }
  }
}
