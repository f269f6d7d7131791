package org.robotui.entity.image.internal;

import java.util.Arrays;
import java.util.Optional;
import org.robotui.data.image.PixelEncoding;
import org.robotui.entity.image.Span;

/**
 * The range of numbers that colours span, held from picture to picture: it widens at once and narrows slowly, so that
 * colours neither flicker nor saturate. For one thread at a time.
 */
public final class Levels {
  private static final double LOW = 0.01;
  private static final double HIGH = 0.99;
  private static final double NARROWING = 0.04;
  private static final int STEPS = 20;
  private static final int LEAST_BITS = 8;
  private static final int[] USUAL_BITS = {8, 10, 12, 14, 16};

  private Optional<PixelEncoding> encoding = Optional.empty();
  private Optional<Span> held = Optional.empty();
  private int bits = LEAST_BITS;

  /** For a camera of which nothing was seen yet. */
  public Levels() {
    // Ranges come with pictures.
  }

  /** Forgets what was held where the pictures are of another kind than before. */
  void begin(PixelEncoding next) {
    if (!encoding.equals(Optional.of(next))) {
      encoding = Optional.of(next);
      held = Optional.empty();
      bits = LEAST_BITS;
    }
  }

  /** The range after some more numbers, of which the outermost hundredths do not count; the array is sorted by this. */
  Span follow(float[] numbers, int count) {
    if (count > 0) {
      Arrays.sort(numbers, 0, count);
      double low = numbers[(int) (LOW * (count - 1))];
      double high = numbers[(int) Math.ceil(HIGH * (count - 1))];
      held = Optional.of(widened(held.map(h -> merged(h, low, high)).orElseGet(() -> widened(low, high))));
    }
    return held.map(Levels::rounded).orElse(new Span(0, 1));
  }

  /** How many bits the numbers of all pictures so far take: sensors of 10 or 12 bits send 16. */
  int bits(int largest) {
    int needed = Integer.SIZE - Integer.numberOfLeadingZeros(largest);
    bits = Math.max(bits, Arrays.stream(USUAL_BITS).filter(b -> b >= needed).findFirst().orElse(Short.SIZE));
    return bits;
  }

  private static Span merged(Span held, double low, double high) {
    double from = low < held.low() ? low : held.low() + (low - held.low()) * NARROWING;
    double to = high > held.high() ? high : held.high() + (high - held.high()) * NARROWING;
    return widened(from, to);
  }

  private static Span widened(Span span) {
    return widened(span.low(), span.high());
  }

  private static Span widened(double low, double high) {
    double least = Math.max(1e-6, 1e-4 * Math.max(Math.abs(low), Math.abs(high)));
    return high - low >= least ? new Span(low, high) : new Span(low - least, low + least);
  }

  /** Ends at round numbers, which stay the same while the range moves a little. */
  private static Span rounded(Span span) {
    double step = Math.pow(10, Math.ceil(Math.log10((span.high() - span.low()) / STEPS)));
    double fine = step / 2 * STEPS >= span.high() - span.low() ? step / 2 : step;
    return new Span(Math.floor(span.low() / fine) * fine, Math.ceil(span.high() / fine) * fine);
  }
}
