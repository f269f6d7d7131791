package org.robotui.uic.plot.internal.signal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robotui.geometry.Quaternion;
import org.robotui.uic.plot.internal.trace.Sample;

class PipelineTest {
  private static final long SECOND = 1_000_000_000L;
  private static final double NAN = Double.NaN;

  private final List<Sample> out = new ArrayList<>();

  @Test
  void theDerivativeOfASineIsACosine() {
    Sink in = single("derivative(a.b:c)");
    for (int i = 0; i <= 1000; i++) {
      in.accept(i * SECOND / 100, Math.sin(i / 100.0));
    }
    assertEquals(1000, out.size());
    out.forEach(s -> assertEquals(Math.cos(s.time() * 1e-9), s.value(), 1e-4));
  }

  @Test
  void aDerivativeKnowsNothingAcrossABreakAndSkipsEqualTimes() {
    feed(single("derivative(a.b:c)"), 0, 0, 1, 2, 1, 9, 2, NAN, 3, 10, 4, 11);
    assertSamples(0.5, 2, 1, NAN, 3.5, 1);
  }

  @Test
  void theIntegralOfACosineIsASine() {
    Sink in = single("integral(a.b:c)");
    for (int i = 0; i <= 1000; i++) {
      in.accept(i * SECOND / 100, Math.cos(i / 100.0));
    }
    out.forEach(s -> assertEquals(Math.sin(s.time() * 1e-9), s.value(), 1e-4));
  }

  @Test
  void anIntegralAddsNothingOverABreak() {
    feed(single("integral(a.b:c)"), 0, 1, 1, 1, 2, NAN, 10, 1, 11, 1);
    assertSamples(0, 0, 1, 1, 2, NAN, 10, 1, 11, 2);
  }

  @Test
  void theIntegralOfADerivativeIsTheSignalButForItsBeginning() {
    Sink in = single("integral(derivative(a.b:c))");
    for (int i = 0; i <= 100; i++) {
      in.accept(i * SECOND / 10, 3.0 * i);
    }
    assertEquals(3.0 * 99, out.getLast().value(), 1e-9);
  }

  @Test
  void anAverageIsThatOfTheLastSecondsAsIfTakenAnew() {
    Random random = new Random(5);
    Sink in = single("average(a.b:c, 0.5)");
    List<Sample> fed = new ArrayList<>();
    long time = 0;
    for (int i = 0; i < 20_000; i++) {
      time += random.nextInt(20_000_000);
      double value = random.nextGaussian() * 1e6;
      fed.add(new Sample(time, value));
      in.accept(time, value);
    }
    for (int i = 0; i < fed.size(); i += 97) {
      long now = fed.get(i).time();
      double mean = fed.subList(0, i + 1).stream().filter(s -> s.time() > now - SECOND / 2).mapToDouble(Sample::value)
          .average().orElseThrow();
      assertEquals(mean, out.get(i).value(), 1e-3);
    }
  }

  @Test
  void anAverageBeginsAnewAfterABreak() {
    feed(single("average(a.b:c, 100)"), 0, 10, 1, 20, 2, NAN, 3, 1, 4, 3);
    assertSamples(0, 10, 1, 15, 2, NAN, 3, 1, 4, 2);
  }

  @Test
  @Timeout(value = 10, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
  void anAverageOverNoTimeIsTheValueItself() {
    feed(single("average(a.b:c, 1e-10)"), 0, 1, 1, 2, 2, 4);
    assertSamples(0, 1, 1, 2, 2, 4);
  }

  @Test
  @Timeout(value = 10, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
  void anAverageBearsTimesAtTheEndOfAllNumbers() {
    Sink in = single("average(a.b:c, 1)");
    in.accept(Long.MIN_VALUE, 1);
    in.accept(Long.MAX_VALUE, 3);
    assertEquals(2, out.size());
  }

  @Test
  void anAverageRecoversFromAnInfiniteValue() {
    feed(single("average(a.b:c, 1)"), 0, 1, 1, Double.POSITIVE_INFINITY, 2, 4, 3, 6);
    assertEquals(6, out.getLast().value());
  }

  @Test
  void aScaleMultipliesAndAdds() {
    feed(single("scale(a.b:c, 2, -1)"), 0, 1, 1, NAN, 2, 3);
    assertSamples(0, 1, 1, NAN, 2, 5);
  }

  @Test
  void aDifferenceOfOneSourceIsThereAtOnce() {
    Pipeline pipeline = of("difference(a.b:c, a.b:d)");
    feed(pipeline.inputs().get(0).sink(), 1, 5);
    feed(pipeline.inputs().get(1).sink(), 1, 3);
    assertSamples(1, 2);
  }

  @Test
  void aDifferenceOfSeveralRatesIsTakenBetweenTheSamplesOfTheOther() {
    Pipeline pipeline = of("difference(a.b:c, d.e:f)");
    feed(pipeline.inputs().get(0).sink(), 0.5, 10, 1, 10, 1.25, 10, 2.5, 10);
    assertSamples();
    feed(pipeline.inputs().get(1).sink(), 1, 0, 2, 4);
    assertSamples(1, 10, 1.25, 9);
    feed(pipeline.inputs().get(1).sink(), 3, 6);
    assertSamples(1, 10, 1.25, 9, 2.5, 5);
  }

  @Test
  void aBreakOfEitherBreaksTheResult() {
    Pipeline pipeline = of("difference(a.b:c, d.e:f)");
    feed(pipeline.inputs().get(1).sink(), 0, 0, 2, NAN, 3, 0, 9, 0);
    feed(pipeline.inputs().get(0).sink(), 0, 1, 1, 1, 2, 1, 3, 1, 4, NAN, 5, 1);
    assertSamples(0, 1, 1, NAN, 2, NAN, 3, 1, 4, NAN, 5, 1);
  }

  @Test
  void whatWaitsForASilentSignalIsBounded() {
    Pipeline pipeline = of("difference(a.b:c, d.e:f)");
    Sink fast = pipeline.inputs().get(0).sink();
    int many = JoinNode.MOST_WAITING + 1000;
    for (int i = 0; i < many; i++) {
      fast.accept(i, i);
    }
    feed(pipeline.inputs().get(1).sink(), 0, 0, 1, 0);
    assertEquals(JoinNode.MOST_WAITING, out.size());
    assertEquals(1000, out.getFirst().value());
  }

  @Test
  void formulasCalculateWithNumbersAndWithSeveralSignals() {
    feed(single("2 * a.b:c - 1"), 0, 3, 1, -1);
    assertSamples(0, 5, 1, -3);
    out.clear();
    Pipeline pipeline = of("(a.b:x - d.e:y) / 2");
    feed(pipeline.inputs().get(1).sink(), 0, 0, 2, 4);
    feed(pipeline.inputs().get(0).sink(), 0, 10, 1, 10, 2, 10);
    assertSamples(0, 5, 1, 4, 2, 3);
  }

  @Test
  void anOrientationHasAnglesAndOneThatIsNoneHasNot() {
    Quaternion turned = Quaternion.fromRollPitchYaw(0.1, -0.2, 3);
    for (String angle : List.of("roll", "pitch", "yaw")) {
      out.clear();
      Pipeline pipeline = of(angle + "(a.b:rotation)");
      double[] parts = {turned.x(), turned.y(), turned.z(), turned.w()};
      for (int i = 0; i < parts.length; i++) {
        feed(pipeline.inputs().get(i).sink(), 0, 2 * parts[i], 1, 0);
      }
      assertEquals(switch (angle) {
        case "roll" -> 0.1;
        case "pitch" -> -0.2;
        default -> 3.0;
      }, out.getFirst().value(), 1e-9);
      assertTrue(Double.isNaN(out.get(1).value()), "all 0");
    }
  }

  @Test
  void anUnwrappedAngleGoesOnOverAWholeTurn() {
    feed(single("unwrap(a.b:c)"), 0, 3, 1, -3, 2, -2.9, 3, 3);
    assertSamples(0, 3, 1, 2 * Math.PI - 3, 2, 2 * Math.PI - 2.9, 3, 3);
  }

  @Test
  void aLowPassReachesAStepByItsTimeConstantWhateverTheDistancesOfSamples() {
    double hertz = 1 / (2 * Math.PI);
    feed(single("lowpass(a.b:c, " + hertz + ")"), 0, 0, 0.4, 1, 1, 1, 5, NAN, 6, 7);
    assertEquals(1 - Math.exp(-1), out.get(2).value(), 1e-9);
    assertTrue(Double.isNaN(out.get(3).value()), "a break");
    assertEquals(7, out.get(4).value());
  }

  @Test
  void theNormOfSeveral() {
    Pipeline pipeline = of("norm(a.b:x, a.b:y, a.b:z)");
    feed(pipeline.inputs().get(0).sink(), 0, 2);
    feed(pipeline.inputs().get(1).sink(), 0, 3);
    feed(pipeline.inputs().get(2).sink(), 0, 6);
    assertSamples(0, 7);
  }

  @Test
  void ofManyPairsThoseFarthestOutAreKept() {
    List<String> kept = new ArrayList<>();
    ThinningPairs thinning = new ThinningPairs(100, (time, x, y) -> kept.add(time + ": " + x + ", " + y));
    for (int i = 0; i < 150; i++) {
      thinning.accept(i, i == 7 ? 9 : 0, i == 50 ? -3 : i == 120 ? 4 : 0);
    }
    thinning.accept(150, NAN, 0);
    thinning.accept(151, 1, 1);
    thinning.flush();
    assertEquals(List.of("0: 0.0, 0.0", "7: 9.0, 0.0", "50: 0.0, -3.0", "100: 0.0, 0.0", "120: 0.0, 4.0",
        "150: NaN, 0.0", "151: 1.0, 1.0"), kept);
  }

  @Test
  void timesOfResultsNeverFall() {
    Random random = new Random(3);
    Pipeline pipeline = of("derivative(average(difference(derivative(a.b:c), average(d.e:f, 0.1)), 0.2))");
    long[] times = new long[2];
    for (int i = 0; i < 20_000; i++) {
      int input = random.nextInt(2);
      times[input] += random.nextInt(30_000_000);
      pipeline.inputs().get(input).sink().accept(times[input], random.nextInt(30) == 0 ? NAN : random.nextGaussian());
    }
    assertTrue(out.size() > 5_000);
    for (int i = 1; i < out.size(); i++) {
      assertTrue(out.get(i).time() >= out.get(i - 1).time(), "at " + i);
    }
  }

  private Sink single(String text) {
    return of(text).inputs().getFirst().sink();
  }

  private Pipeline of(String text) {
    return Pipeline.of(ExprParser.parse(text), (time, value) -> out.add(new Sample(time, value)));
  }

  private static void feed(Sink in, double... secondsAndValues) {
    for (int i = 0; i < secondsAndValues.length; i += 2) {
      in.accept(Math.round(secondsAndValues[i] * SECOND), secondsAndValues[i + 1]);
    }
  }

  private void assertSamples(double... secondsAndValues) {
    assertEquals(secondsAndValues.length / 2, out.size(), out.toString());
    for (int i = 0; i < out.size(); i++) {
      assertEquals(Math.round(secondsAndValues[2 * i] * SECOND), out.get(i).time(), out.toString());
      assertEquals(secondsAndValues[2 * i + 1], out.get(i).value(), 1e-12, out.toString());
    }
  }
}
