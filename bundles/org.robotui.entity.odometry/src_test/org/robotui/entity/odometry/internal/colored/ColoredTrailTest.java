package org.robotui.entity.odometry.internal.colored;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Settings;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.SourceId;
import org.robotui.api.replay.StreamHistory;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.array.Doubles;
import org.robotui.data.navigation.Odometry;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.display.ColorScale;
import org.robotui.testkit.KeptHistory;
import org.robotui.testkit.KeptTimeline;

class ColoredTrailTest {
  private static final SourceId ODOM = new SourceId("base", "/odom");
  private static final SourceId OTHER = new SourceId("base", "/other");
  private static final Schema SCHEMA = ColorBy.with();
  private static final double ENDLESS = 1e9;

  private final Map<SourceId, StreamHistory> recorded = new HashMap<>();
  private final ColoredTrail trail =
      new ColoredTrail(Odometry.class, Runnable::run, source -> Optional.ofNullable(recorded.get(source)));
  private long now;

  @Test
  void eachPlaceHasTheValueThatWasNewestThere() {
    ColorBy by = by("base./other:angular.z");
    update(by, from(ODOM, 0, 0));
    update(by, from(OTHER, 0, 3), from(ODOM, 1, 0));
    update(by, from(ODOM, 2, 0), from(OTHER, 0, 5));
    ColoredTrail.Seen seen = update(by, from(ODOM, 3, 0));
    assertArrayEquals(new double[]{Double.NaN, 3, 3, 5}, seen.way().values());
    assertArrayEquals(new double[]{0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0}, seen.way().xyz());
    ColorScale scale = seen.scale().orElseThrow();
    assertEquals(List.of("angular.z", "rad/s", 3.0, 5.0),
        List.of(scale.title(), scale.unit(), scale.low(), scale.high()));
    assertEquals(Optional.empty(), seen.problem());
    assertSame(seen, update(by), "nothing came");
  }

  @Test
  void aValueOfThePoseItselfColoursThePlaceAtWhichItIs() {
    ColorBy by = by("base./odom:angular.z");
    update(by, from(ODOM, 0, 1));
    assertArrayEquals(new double[]{1, 2}, update(by, from(ODOM, 1, 2)).way().values());
  }

  @Test
  void whatIsMissingIsSaidAndTheWayIsSeenAllTheSame() {
    ColoredTrail.Seen none = update(by("base./other:angular.z"), from(ODOM, 0, 0));
    assertEquals(Optional.of("no value of base./other:angular.z came yet"), none.problem());
    ColoredTrail.Seen wrong = update(by("base./odom:angular.w"), from(ODOM, 0, 0));
    assertTrue(wrong.problem().orElseThrow().contains("has no field 'angular.w'"), wrong.problem().toString());
    assertEquals(1, wrong.way().count());
    assertEquals(Optional.empty(), wrong.scale());
  }

  @Test
  void numbersOfAnySizeHaveAColour() {
    ColorBy by = by("base./odom:angular.z");
    double[] hostile = {1e308, -1e308, 1e300, Double.MIN_VALUE, 0};
    for (int i = 0; i < hostile.length; i++) {
      update(by, from(ODOM, i, hostile[i]));
    }
    ColorScale scale = update(by).scale().orElseThrow();
    for (double value : hostile) {
      assertTrue(scale.rgb(value) >= 0 && scale.rgb(value) <= 0xffffff);
    }
    assertTrue(scale.rgb(Double.NaN) >= 0);
  }

  @Test
  void ofARecordingTheWholeWayIsSeenAtOnceUnlessThatIsNotWanted() {
    KeptHistory history = new KeptHistory(new KeptTimeline());
    for (int i = 0; i < 10; i++) {
      history.add("/odom", i, odometry(i, 0));
      history.add("/other", i + 0.5, odometry(0, 10 * i));
    }
    recorded.put(ODOM, history);
    recorded.put(OTHER, history);
    ColoredTrail.Seen seen = update(by("base./other:angular.z"), from(ODOM, 4, 0));
    assertEquals(10, seen.way().count());
    assertArrayEquals(new double[]{Double.NaN, 0, 10, 20, 30, 40, 50, 60, 70, 80}, seen.way().values());
    assertSame(seen, update(by("base./other:angular.z")), "read once");
    Map<String, Object> values = values("base./other:angular.z");
    values.put("whole", false);
    assertEquals(1, update(ColorBy.of(new Settings(SCHEMA, values))).way().count());
  }

  @Test
  void whatColoursIsNoWayOfItsOwnAndAJumpOfTheClockBeginsAnew() {
    ColorBy by = by("base./other:angular.z");
    update(by, from(OTHER, 50, 1));
    update(by, from(ODOM, 0, 0));
    assertEquals(1, update(by, from(OTHER, 60, 1)).way().count());
    assertEquals(0.0, update(by).way().xyz()[0]);
    assertTrue(trail.update(List.of(), by, ENDLESS, true).isEmpty());
  }

  private ColoredTrail.Seen update(ColorBy by, Envelope<?>... arrived) {
    List<Envelope<? extends Data>> all = new ArrayList<>();
    for (Envelope<?> envelope : arrived) {
      all.add((Envelope<? extends Data>) envelope);
    }
    return trail.update(all, by, ENDLESS, false).orElse(null);
  }

  private static ColorBy by(String field) {
    return ColorBy.of(new Settings(SCHEMA, values(field)));
  }

  private static Map<String, Object> values(String field) {
    Map<String, Object> values = new HashMap<>();
    SCHEMA.settings().forEach(s -> s.fallback().ifPresent(value -> values.put(s.name(), value)));
    values.put("color_by", field);
    return values;
  }

  private Envelope<Odometry> from(SourceId source, double x, double turn) {
    now++;
    return new Envelope<>(odometry(x, turn), source, now, Optional.empty(), now, Optional.empty());
  }

  private static Odometry odometry(double x, double turn) {
    return new Odometry(new FrameId("Keira", "odom"), new FrameId("Keira", "base"), RigidTransform.planar(x, 0, 0),
        Doubles.EMPTY, Vector3.ZERO, new Vector3(0, 0, turn), Doubles.EMPTY);
  }
}
