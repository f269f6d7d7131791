package org.robotui.uic.plot.internal.signal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
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
      "norm(base./imu:a.x, base./imu:a.y, base./imu:a.z)"
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
  })
  void whatIsWrongIsSaid(String text, String message) {
    String said = assertThrows(IllegalArgumentException.class, () -> ExprParser.parse(text)).getMessage();
    assertTrue(said.contains(message), said);
  }

  @Test
  void endlessNestingIsRefused() {
    String deep = "derivative(".repeat(300) + "a.b:c" + ")".repeat(300);
    assertThrows(IllegalArgumentException.class, () -> ExprParser.parse(deep));
    assertThrows(IllegalArgumentException.class, () -> ExprParser.parse("(".repeat(5000)));
  }
}
