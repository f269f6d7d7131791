package org.robotui.api.config;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class ValueTypeTest {
  private static final ValueType METRES = new ValueType.Num(0, 10, "m");
  private static final ValueType COUNT = new ValueType.Int(0, Long.MAX_VALUE);

  private static void refuses(ValueType type, Object... values) {
    List.of(values).forEach(v -> assertEquals(Optional.empty(), type.fit(v), () -> v + " is not " + type.expected()));
  }

  @Test
  void numbersMustBeWithinTheirLimits() {
    assertEquals(Optional.of(10.0), METRES.fit(10L));
    refuses(METRES, 10.5, -1, Double.NaN, Double.POSITIVE_INFINITY, "1", true);
  }

  @Test
  void wholeNumbersAreHeldExactly() {
    assertEquals(Optional.of(9_007_199_254_740_993L), COUNT.fit(9_007_199_254_740_993L));
    assertEquals(Optional.of(3L), COUNT.fit(3.0));
    refuses(COUNT, 3.5, -1L, Double.NaN, Double.POSITIVE_INFINITY, 1e300);
  }

  @Test
  void textsMustKeepTheirRuleAndAreNotEndless() {
    ValueType frame = new ValueType.Text(TextRule.FRAME);

    assertEquals(Optional.of("robot/map"), frame.fit("robot/map"));
    assertEquals(Optional.of("7"), new ValueType.Text().fit(7L));
    refuses(frame, " padded", "", true);
    refuses(new ValueType.Text(), "x".repeat(TextRule.LONGEST + 1), List.of());
  }

  @Test
  void whatIsWithinListsMapsAndSectionsMustFitAsWell() {
    Schema schema = new Schema(List.of(Setting.required("size", METRES, "How long."),
        Setting.of("on", new ValueType.Flag(), true, "Whether.")));
    ValueType section = new ValueType.Section(schema);

    assertEquals(Optional.of(List.of(1.0, 2.0)), new ValueType.ListOf(METRES).fit(List.of(1, 2)));
    assertEquals(Optional.of(Map.of("a", 1.0)), new ValueType.MapOf(METRES).fit(Map.of("a", 1)));
    assertEquals(Optional.of(new Settings(schema, Map.of("size", 1.0, "on", true))), section.fit(Map.of("size", 1)));
    refuses(new ValueType.ListOf(METRES), List.of(1, "two"), 1);
    refuses(new ValueType.MapOf(METRES), Map.of("a", "one"), 1);
    refuses(section, Map.of(), Map.of("size", 99), Map.of("size", 1, "unknown", 1), "size");
  }

  @Test
  void theFirstAlternativeThatFitsIsTaken() {
    ValueType either = new ValueType.AnyOf(List.of(COUNT, METRES, new ValueType.Choice(List.of("auto"))));

    assertEquals(Optional.of(2L), either.fit(2.0));
    assertEquals(Optional.of(2.5), either.fit(2.5));
    assertEquals(Optional.of("auto"), either.fit("auto"));
    refuses(either, "manual", -2);
    assertEquals("a whole number from 0 to 9223372036854775807, or a number from 0 to 10 in m, or one of auto",
        either.expected());
  }

  @Test
  void whatFollowsFromAnotherSettingIsKnownInItsGroup() {
    ValueType.Dependent size = new ValueType.Dependent("unit", Map.of("pixels", COUNT), METRES);

    assertEquals(COUNT, size.in(Map.of("unit", "pixels")));
    assertEquals(METRES, size.in(Map.of("unit", "feet")));
    assertEquals(METRES, size.in(Map.of()));
    assertEquals(Optional.of(2.5), size.fit(2.5));
    assertEquals(METRES.expected(), size.expected());
  }

  @Test
  void aPlaceIsKept() {
    assertEquals(Optional.of(Placed.nowhere(1.0)), new ValueType.WithPlace(METRES).fit(1));
    refuses(new ValueType.WithPlace(METRES), 11);
  }
}
