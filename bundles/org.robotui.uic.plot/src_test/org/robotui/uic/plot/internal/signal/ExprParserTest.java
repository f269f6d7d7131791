package org.robotui.uic.plot.internal.signal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.api.port.SourceId;

class ExprParserTest {
  @ParameterizedTest
  @ValueSource(strings = {
      "base./odom:twist.linear.x",
      "base./a/b-c:ranges[3]",
      "arm.position2d:0:pose.x",
      "derivative(base./odom:x)",
      "average(integral(base./odom:x), 0.5)",
      "scale(base./odom:x, 57.29577951308232)",
      "scale(base./odom:x, -2, 1.0E-7)",
      "difference(base./odom:x, scale(sim.odom:x, 2))",
      "norm(base./imu:a.x, base./imu:a.y, base./imu:a.z)",
      "base./a/b-c:x - base./odom:x",
      "2 * base./odom:x + 1",
      "(base./odom:x + 1) / (base./odom:y - base./odom:z)",
      "-(base./odom:x * base./odom:y)",
      "base./odom:x - (base./odom:y - base./odom:z) - 3",
      "base./odom:x / (base./odom:y * base./odom:z) * 3",
      "atan2(base./odom:y, -base./odom:x)",
      "max(base./odom:x, 0)",
      "deg(unwrap(yaw(base./odom:pose.rotation)))",
      "lowpass(sqrt(base./odom:x), 0.5)"
  })
  void whatIsReadIsWrittenAgain(String text) {
    assertEquals(text, ExprParser.parse(text).toString());
    assertEquals(ExprParser.parse(text), ExprParser.parse(ExprParser.parse(text).toString()));
  }

  @Test
  void aSourceIsTheComponentBeforeTheFirstDotAndThePortAfterIt() {
    assertEquals(new Expr.Field(new SourceId("base", "/camera/scan.raw"), "ranges[3]"),
        ExprParser.parse("  base./camera/scan.raw:ranges[3] "));
  }

  @Test
  void blanksDoNotMatter() {
    assertEquals("difference(a.b:c, norm(d.e:f))", ExprParser.parse(" difference( a.b:c ,norm( d.e:f ) ) ").toString());
  }

  @Test
  void fieldsComeInTheOrderOfTheText() {
    List<String> fields =
        ExprParser.parse("difference(norm(a.b:x, a.b:y), average(c.d:z, 1))").fields().map(Expr.Field::path).toList();
    assertEquals(List.of("x", "y", "z"), fields);
  }

  @ParameterizedTest
  @CsvSource(delimiter = '|', value = {
      "odom | 'odom' is no signal",
      "base.odom | is no signal",
      "base.odom: | is no signal",
      "base.odom:a..b | is no field name",
      "sine(a.b:c) | there is no function 'sine'; there are derivative",
      "derivative(a.b:c, 3) | derivative() takes one signal",
      "derivative(a.b:c, d.e:f) | derivative() takes one signal",
      "average(a.b:c) | the seconds over which",
      "average(a.b:c, -1) | more than 0",
      "average(a.b:c, x) | 'x' is no number",
      "scale(a.b:c) | a factor",
      "scale(a.b:c, Infinity) | is no finite number",
      "difference(a.b:c) | two signals",
      "norm(3) | '3' in norm() is no signal",
      "derivative(a.b:c | is not closed",
      "derivative(a.b:c) x | left over",
      "derivative() | is no signal",
      "2 + 3 | has no field",
      "base.odom:x*2 | write blanks around + - * /",
      "2 * (base.odom:x + 1 | ')' is missing at the end (column 21)",
      "base.odom:x + | '' is no signal",
      "base.odom:x + sine(a.b:c) | there is no function 'sine'; there are derivative, integral",
      "yaw(2 * a.b:c) | an orientation, a field with x, y, z and w",
      "lowpass(a.b:c) | the limit in hertz",
      "lowpass(a.b:c, 0) | more than 0",
      "max(a.b:c) | two signals, or a signal and a number",
      "abs(a.b:c, 2) | takes one signal",
      "speed * 2 | 'speed' is no signal",
  })
  void whatIsWrongIsSaid(String text, String message) {
    String said = assertThrows(IllegalArgumentException.class, () -> ExprParser.parse(text)).getMessage();
    assertTrue(said.contains(message), said);
  }

  @Test
  void aNameStandsForItsSignalAndStaysInTheText() {
    Expr speed = new Expr.Named("speed", Optional.of("m/s"), ExprParser.parse("base.odom:x"));
    Expr read = ExprParser.parse("derivative(2 * speed)", name -> Optional.of(speed).filter(s -> name.equals("speed")));
    assertEquals("derivative(2 * speed)", read.toString());
    assertEquals(List.of("x"), read.fields().map(Expr.Field::path).toList());
  }

  @Test
  void endlessNestingIsRefused() {
    String deep = "derivative(".repeat(300) + "a.b:c" + ")".repeat(300);
    assertThrows(IllegalArgumentException.class, () -> ExprParser.parse(deep));
    assertThrows(IllegalArgumentException.class, () -> ExprParser.parse("(".repeat(5000)));
  }
}
