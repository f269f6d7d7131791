package org.robotui.uic.plot.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.NumberField;
import org.robotui.data.Data;
import org.robotui.data.record.DataRecord;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldPath;
import org.robotui.data.record.FieldUnits;
import org.robotui.data.record.FieldValue;
import org.robotui.uic.plot.internal.Robots;
import org.robotui.uic.plot.internal.signal.ExprParser;

class WordsTest {
  @ParameterizedTest
  @CsvSource(delimiter = ';', value = {
      "base./odom:linear.x ; linear.x",
      "derivative(base./odom:linear.x) ; d/dt linear.x",
      "difference(a.b:x, average(c.d:y, 0.5)) ; x \u2212 (mean 0.5\u00a0s y)",
      "scale(a.b:x, 2, -1) ; x \u00b7 2 \u2212 1",
      "scale(integral(a.b:x), 1, 3) ; (\u222b x) + 3",
      "norm(a.b:x, a.b:y) ; |x, y|",
      "2 * a.b:x + 1 ; 2 \u00b7 x + 1",
      "(a.b:x - a.b:y) / derivative(a.b:z) ; (x \u2212 y) / (d/dt z)",
      "deg(yaw(a.b:pose.rotation)) ; deg (yaw pose.rotation)",
  })
  void signalsHaveShortNames(String signal, String label) {
    assertEquals(label, Labels.of(ExprParser.parse(signal)));
  }

  @ParameterizedTest
  @CsvSource({
      "a.b:linear.x, m/s",
      "derivative(a.b:linear.x), m/s\u00b2",
      "derivative(a.b:pose.translation.x), m/s",
      "integral(a.b:linear.x), m",
      "integral(derivative(derivative(a.b:pose.translation.x))), m/s",
      "a.b:angular.z, rad/s",
      "'difference(a.b:linear.x, a.b:linear.y)', m/s",
      "'difference(a.b:linear.x, a.b:angular.z)', ''",
      "'scale(a.b:linear.x, 2)', ''",
      "'average(a.b:linear.x, 1)', m/s",
      "a.b:twistCovariance[3], ''",
      "a.b:linear.x - a.b:linear.y + 1, m/s",
      "a.b:linear.x * a.b:linear.y, ''",
      "yaw(a.b:pose.rotation), rad",
      "deg(derivative(yaw(a.b:pose.rotation))), \u00b0/s",
      "'lowpass(abs(a.b:linear.x), 2)', m/s",
  })
  void unitsFollowWhatIsComputed(String signal, String unit) {
    assertEquals(unit, Units.of(ExprParser.parse(signal), f -> FieldUnits.of("Odometry", f.path())));
  }

  @Test
  void unitsOfTheRobotsOwnMessages() {
    assertEquals("m/s", FieldUnits.of("nav_msgs/Odometry", "twist.twist.linear.x"));
    assertEquals("m", FieldUnits.of("nav_msgs/Odometry", "pose.pose.position.y"));
    assertEquals("m/s\u00b2", FieldUnits.of("sensor_msgs/Imu", "linear_acceleration.z"));
    assertEquals("m", FieldUnits.of("sensor_msgs/LaserScan", "ranges[17]"));
    assertEquals("rad", FieldUnits.of("GpsFix", "latitude"));
  }

  @Test
  void theNamesOfOurRecordsComeBeforeThoseOfTheRobot() {
    DynamicRecord own = new Own();
    assertEquals(new NumberField.Number(1, "Odometry"),
        new NumberField(FieldPath.parse("linear.x")).read(DataRecord.of(Robots.odometry(1, 2)), () -> own));
    assertEquals(new NumberField.Number(1, "test/Own"),
        new NumberField(FieldPath.parse("moving")).read(DataRecord.of(Robots.odometry(1, 2)), () -> own));
  }

  @ParameterizedTest
  @CsvSource(delimiter = '|', value = {
      "speed | has no field 'speed'; fields there are: frame, childFrame, pose",
      "linear.x.y | has no field 'linear.x.y'; linear.x has no fields",
      "linear | linear of Odometry is a group; fields there are: x, y, z",
      "name | name of test/Own is a text, not a number",
      "twistCovariance[3] | has no field 'twistCovariance[3]'; twistCovariance has 0 elements",
  })
  void whyThereIsNoNumberIsSaid(String path, String reason) {
    NumberField.Found found =
        new NumberField(FieldPath.parse(path)).read(DataRecord.of(Robots.odometry(1, 2)), Own::new);
    String said = assertInstanceOf(NumberField.Missing.class, found).reason();
    assertTrue(said.contains(reason), said);
  }

  @Test
  void lostValuesBreakTheLineAndAreCounted() {
    LiveTrace trace = new LiveTrace(ExprParser.parse("base./odom:linear.x"), 1000, 0);
    take(trace, 0, 10);
    take(trace, 1, 20);
    take(trace, 6, 30);
    assertEquals(List.of(new Loss(20, 30, 4)), trace.losses());
    assertEquals(4, trace.series().size());
    assertTrue(Double.isNaN(trace.series().samples().value(2)));
  }

  @Test
  void aSourceThatBeginsToCountAnewHasLostNothing() {
    LiveTrace trace = new LiveTrace(ExprParser.parse("base./odom:linear.x"), 1000, 0);
    take(trace, 100, 10);
    take(trace, 0, 20);
    take(trace, 1, 30);
    assertEquals(List.of(), trace.losses());
    assertEquals(4, trace.series().size());
  }

  @Test
  void lossesAreCountedOnceForAllFieldsOfASourceAndBounded() {
    LiveTrace trace = new LiveTrace(ExprParser.parse("norm(base./odom:linear.x, base./odom:linear.y)"), 1000, 0);
    for (int i = 0; i < 1000; i++) {
      take(trace, i * 2L, i);
    }
    assertEquals(200, trace.losses().size());
    assertEquals(1, trace.losses().getLast().count());
  }

  private static void take(LiveTrace trace, long sequence, long time) {
    Data value = Robots.odometry(1, 2);
    Envelope<Data> envelope = new Envelope<>(value, Robots.ODOM, sequence, Optional.empty(), 0, Optional.empty());
    trace.take(envelope, time, DataRecord.of(value), envelope::record);
  }

  private static final class Own implements DynamicRecord {
    @Override
    public String schema() {
      return "test/Own";
    }

    @Override
    public List<String> fields() {
      return List.of("moving", "name");
    }

    @Override
    public Optional<FieldValue> field(String name) {
      return switch (name) {
        case "moving" -> Optional.of(new FieldValue.Flag(true));
        case "name" -> Optional.of(new FieldValue.Text("Keira"));
        default -> Optional.empty();
      };
    }
  }
}
