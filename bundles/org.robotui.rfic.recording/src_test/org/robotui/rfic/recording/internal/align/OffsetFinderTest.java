package org.robotui.rfic.recording.internal.align;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.util.Optional;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.RawMessage;
import org.robotui.api.replay.OffsetEstimate;
import org.robotui.data.FrameId;
import org.robotui.data.array.Bytes;
import org.robotui.data.array.Doubles;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.sensor.Battery;
import org.robotui.data.sensor.Imu;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.rfic.recording.internal.ToldHistory;

class OffsetFinderTest {
  private static final FrameId BASE = new FrameId("robot", "base");
  private static final Battery BATTERY = new Battery(12, 1, 0.5, Battery.Status.DISCHARGING);

  private final Random random = new Random(7);

  private static Optional<RawMessage> message(long number) {
    byte[] bytes = ByteBuffer.allocate(24).putLong(number).array();
    return Optional.of(new RawMessage("Battery", "test", Bytes.of(bytes), RawMessage.Reader.NONE));
  }

  private static Optional<OffsetEstimate> offset(ToldHistory reference, ToldHistory moved) throws Exception {
    return OffsetFinder.offset(reference, moved);
  }

  @Test
  void messagesThatBothHaveTellIt() throws Exception {
    ToldHistory one = new ToldHistory();
    ToldHistory other = new ToldHistory();
    for (int i = 0; i < 50; i++) {
      one.says("battery", 100 + i, BATTERY, message(i));
      other.says("battery", 103.25 + i + 0.002 * random.nextGaussian(), BATTERY, message(i));
    }
    OffsetEstimate found = offset(one, other).orElseThrow();
    assertEquals(-3.25e9, found.offset(), 2e6);
    assertTrue(found.deviation() > 0.5e6 && found.deviation() < 5e6, found::toString);
    assertEquals("50 messages that both have", found.basis());
  }

  @Test
  void whatIsSaidTwiceTellsNothing() throws Exception {
    ToldHistory one = new ToldHistory();
    ToldHistory other = new ToldHistory();
    for (int i = 0; i < 50; i++) {
      one.says("battery", i, BATTERY, message(1));
      other.says("battery", 7 + i, BATTERY, message(1));
    }
    assertEquals(Optional.empty(), offset(one, other));
  }

  @Test
  void messagesOfOtherTimesAreNotTheSame() throws Exception {
    ToldHistory one = new ToldHistory();
    ToldHistory other = new ToldHistory();
    for (int i = 0; i < 50; i++) {
      one.says("battery", i, BATTERY, message(i));
      other.says("battery", 3 * i, BATTERY, message(49 - i));
    }
    assertEquals(Optional.empty(), offset(one, other));
  }

  private ToldHistory odometry(double from, double seconds, double late, DoubleUnaryOperator turning) {
    ToldHistory told = new ToldHistory();
    for (double t = from; t < from + seconds; t += 0.05) {
      told.says("odom", t + late, new Odometry(BASE, BASE, RigidTransform.IDENTITY, Doubles.EMPTY, Vector3.ZERO,
          new Vector3(0, 0, turning.applyAsDouble(t) + 0.01 * random.nextGaussian()), Doubles.EMPTY));
    }
    return told;
  }

  private ToldHistory imu(double from, double seconds, double late, DoubleUnaryOperator turning) {
    ToldHistory told = new ToldHistory();
    for (double t = from; t < from + seconds; t += 0.01) {
      told.says("imu", t + late, new Imu(BASE, Optional.empty(),
          Optional.of(new Vector3(0, 0, turning.applyAsDouble(t) + 0.02 * random.nextGaussian())), Optional.empty()));
    }
    return told;
  }

  /** A drive: turns of several lengths at times that do not repeat. */
  private static double drive(double t) {
    return 0.5 * Math.sin(t) * Math.sin(0.13 * t * t / 10) + 0.3 * Math.sin(0.37 * t);
  }

  @Test
  void whatTurnsAlikeTellsIt() throws Exception {
    OffsetEstimate found = offset(odometry(1000, 90, 0, OffsetFinderTest::drive),
        imu(1010, 60, 12.345, OffsetFinderTest::drive)).orElseThrow();
    assertEquals(-12.345, found.offset() * 1e-9, Math.max(0.02, 4e-9 * found.deviation()), found::toString);
    assertTrue(found.deviation() < 50_000_000, found::toString);
    assertTrue(found.basis().startsWith("imu turns as odom does (correlation 9"), found.basis());
  }

  @Test
  void aSensorThatHangsUpsideDownTellsIt() throws Exception {
    OffsetEstimate found = offset(odometry(1000, 90, 0, OffsetFinderTest::drive),
        imu(1010, 60, -5, t -> -drive(t))).orElseThrow();
    assertEquals(5, found.offset() * 1e-9, 0.02, found::toString);
  }

  @Test
  void aSensorThatLiesOnItsSideTellsIt() throws Exception {
    ToldHistory imu = new ToldHistory();
    for (double t = 1010; t < 1070; t += 0.02) {
      imu.says("imu", t + 2, new Imu(BASE, Optional.empty(), Optional.of(new Vector3(0.1, drive(t), 0)),
          Optional.of(new Vector3(0.2, 9.7, -0.1))));
    }
    OffsetEstimate found = offset(odometry(1000, 90, 0, OffsetFinderTest::drive), imu).orElseThrow();
    assertEquals(-2, found.offset() * 1e-9, 0.02, found::toString);
  }

  @Test
  void whatTurnsOtherwiseTellsNothing() throws Exception {
    assertEquals(Optional.empty(), offset(odometry(1000, 90, 0, OffsetFinderTest::drive),
        odometry(1000, 90, 0, t -> 0.4 * Math.cos(0.9 * t) * Math.sin(0.05 * t * t))));
  }

  @Test
  void turnsThatRepeatLeaveItOpen() throws Exception {
    assertEquals(Optional.empty(), offset(odometry(0, 90, 0, Math::sin), odometry(0, 90, 4, Math::sin)));
  }

  @Test
  void aRobotThatStandsTellsNothing() throws Exception {
    ToldHistory still = new ToldHistory();
    for (int i = 0; i < 2000; i++) {
      still.says("odom", i * 0.05, new Odometry(BASE, BASE, RigidTransform.IDENTITY, Doubles.EMPTY, Vector3.ZERO,
          Vector3.ZERO, Doubles.EMPTY));
    }
    assertEquals(Optional.empty(), offset(still, still));
    assertEquals(Optional.empty(), offset(still, odometry(0, 90, 0, OffsetFinderTest::drive)));
  }
}
