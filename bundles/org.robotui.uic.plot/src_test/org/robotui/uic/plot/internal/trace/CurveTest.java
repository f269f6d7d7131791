package org.robotui.uic.plot.internal.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;

class CurveTest {
  private static final TimeSpan ALL = new TimeSpan(0, Long.MAX_VALUE / 2);
  private static final Curve.Fineness SCREEN = new Curve.Fineness(1.0 / 400, 1.0 / 400);

  private final CurveSketch sketch = new CurveSketch();

  @Test
  void ofASmoothCurveAsManyPointsAreDrawnAsTheScreenTellsApart() {
    Curve curve = new Curve(2_000_000);
    for (int i = 0; i < 1_000_000; i++) {
      curve.add(i, Math.cos(i * 1e-5), Math.sin(i * 1e-5));
    }
    curve.sketch(ALL, SCREEN, sketch);
    assertTrue(sketch.size() < 12_000, "points: " + sketch.size());
    for (int i = 1; i < sketch.size(); i++) {
      double far = Math.hypot(sketch.x(i) - sketch.x(i - 1), sketch.y(i) - sketch.y(i - 1));
      assertTrue(far < 3 * SCREEN.x(), "step " + i + " goes " + far);
    }
  }

  @Test
  void howeverRoughItIsTheNumberOfPointsIsBoundedAndThePointsFarthestOutStay() {
    Curve curve = new Curve(2_000_000);
    Random random = new Random(3);
    for (int i = 0; i < 400_000; i++) {
      boolean far = i == 123_457;
      curve.add(i, far ? 50 : random.nextDouble(), random.nextDouble());
    }
    curve.sketch(ALL, SCREEN, sketch);
    assertTrue(sketch.isDense() && sketch.size() <= 10 * CurveSketch.MOST_RUNS + 1, "points: " + sketch.size());
    boolean found = false;
    for (int i = 0; i < sketch.size(); i++) {
      found |= sketch.x(i) == 50;
    }
    assertTrue(found, "the point far out");
  }

  @Test
  void numbersOfAnySizeBreakItOrAreDrawn() {
    Curve curve = new Curve(1000);
    double[] hostile = {Double.NaN, Double.POSITIVE_INFINITY, 1e300, -1e300, Double.MIN_VALUE, -0.0, 3};
    int time = 0;
    for (double x : hostile) {
      for (double y : hostile) {
        curve.add(time++, x, y);
      }
    }
    curve.sketch(ALL, SCREEN, sketch);
    int points = 0;
    for (int i = 0; i < sketch.size(); i++) {
      assertEquals(Double.isFinite(sketch.x(i)), Double.isFinite(sketch.y(i)));
      points += Double.isFinite(sketch.x(i)) ? 1 : 0;
      assertTrue(i == 0 || !Double.isNaN(sketch.x(i)) || !Double.isNaN(sketch.x(i - 1)), "one break is enough");
    }
    assertTrue(points >= 5, "points: " + points);
  }

  @Test
  void onlyWhatLiesWithinTheSpanIsDrawnAndPointsAreFoundByTime() {
    Curve curve = new Curve(1000);
    for (int i = 0; i < 10; i++) {
      curve.add(i, i, i == 5 ? Double.NaN : 10 * i);
    }
    curve.sketch(new TimeSpan(2, 4), SCREEN, sketch);
    assertEquals(2, sketch.time(0));
    assertEquals(4, sketch.time(sketch.size() - 1));
    assertEquals(new Curve.At(4, 4, 40), curve.lastUntil(5).orElseThrow());
    assertEquals(new Curve.At(6, 6, 60), curve.nearest(6, 0).orElseThrow());
    assertTrue(curve.nearest(5, 0).isEmpty(), "a break is no point");
  }

  @Test
  void theOldestPointsAreForgottenInBothAlike() {
    Curve curve = new Curve(5000);
    for (int i = 0; i < 20_000; i++) {
      curve.add(i, i, -i);
    }
    Curve.Both both = curve.samples();
    assertTrue(both.x().size() >= 5000 && both.x().size() < 15_000, "kept: " + both.x().size());
    assertEquals(both.x().size(), both.y().size());
    assertEquals(both.x().value(0), -both.y().value(0));
  }
}
