package org.robotui.gl.display;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Settings;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.ClockKind;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.geometry.StampedPose;
import org.robotui.geometry.RigidTransform;
import org.robotui.gl.shape.Rgba;

class RecentTest {
  private static final FrameId BASE = new FrameId("r", "base");
  private static final InputState LIVE = new InputState.Live(10, 0);
  private static final Schema SCHEMA = Schema.of(ColorSetting.of("color", "#ff0000", "Its colour."));

  private final Recent<StampedPose, Object> recent =
      new Recent<>(StampedPose.class, Anchor.When.MEASURED, StampedPose::frame, v -> 10);
  private Optional<RigidTransform> exact = Optional.of(RigidTransform.planar(1, 0, 0));
  private Optional<RigidTransform> now = Optional.of(RigidTransform.planar(2, 0, 0));
  private String fixed = "map";
  private long knownUntil = Long.MAX_VALUE;

  @Test
  void keepsTheNewestWhereNoTimeIsAsked() {
    recent.update(tick(LIVE, 1, value(0), value(1)), 0, 1000);
    assertEquals(1, recent.entries().size());
    recent.update(tick(LIVE, 9), 0, 1000);
    assertEquals(1, recent.entries().size(), "the newest stays however old");
    assertEquals(0, recent.dropped());
  }

  @Test
  void keepsTheLastSecondsAndUsesSlotsAgain() {
    recent.update(tick(LIVE, 2, value(0), value(1), value(2)), 1.5, 1000);
    assertEquals(List.of(1, 2), recent.entries().stream().map(Recent.Entry::slot).toList());
    recent.update(tick(LIVE, 3, value(3)), 1.5, 1000);
    assertEquals(List.of(2, 0), recent.entries().stream().map(Recent.Entry::slot).toList());
  }

  @Test
  void theOldestMakeRoomAndAreCounted() {
    recent.update(tick(LIVE, 1, value(1), value(1), value(1)), 100, 25);
    assertEquals(2, recent.entries().size());
    assertEquals(1, recent.dropped());
    recent.update(tick(LIVE, 1), 100, 1);
    assertEquals(1, recent.entries().size(), "the newest stays however large");
  }

  @Test
  void valuesStayAsLongAsTheTimeByWhichTheyGrowOldStandsStill() {
    recent.update(tick(LIVE, 1, value(1)), 3, 1000);
    recent.update(tick(LIVE, 2, value(2)), 3, 1000);
    DisplayTick standing = new DisplayTick(List.of(), LIVE, places(), settings(), Rgba.WHITE, 60_000_000_000L, false,
        received -> 2 - received * 1e-9);
    recent.update(standing, 3, 1000);
    assertEquals(2, recent.entries().size());
    recent.update(tick(LIVE, 60), 3, 1000);
    assertEquals(1, recent.entries().size(), "by the clock of this machine the first is too old");
  }

  @Test
  void whatWasMeasuredStaysWhereItWasAndMovesWithTheFixedFrameOnly() {
    recent.update(tick(LIVE, 1, value(1)), 0, 1000);
    exact = Optional.of(RigidTransform.planar(7, 0, 0));
    recent.update(tick(LIVE, 2), 0, 1000);
    assertEquals(1, place(), 1e-9);
    fixed = "odom";
    recent.update(tick(LIVE, 3), 0, 1000);
    assertEquals(7, place(), 1e-9);
  }

  @Test
  void isPlacedByTheNewestTransformUntilItsOwnIsKnown() {
    exact = Optional.empty();
    recent.update(tick(LIVE, 1, value(1)), 0, 1000);
    assertEquals(2, place(), 1e-9);
    assertInstanceOf(DisplayStatus.Partly.class, status(LIVE));
    exact = Optional.of(RigidTransform.planar(1, 0, 0));
    recent.update(tick(LIVE, 2), 0, 1000);
    assertEquals(1, place(), 1e-9);
    assertInstanceOf(DisplayStatus.Shown.class, status(LIVE));
  }

  @Test
  void aTransformThatIsAboutToComeIsNoNews() {
    knownUntil = -100_000_000;
    recent.update(tick(LIVE, 1, value(1)), 0, 1000);
    assertEquals(2, place(), 1e-9);
    assertInstanceOf(DisplayStatus.Shown.class, status(LIVE));
    knownUntil = Long.MAX_VALUE;
    recent.update(tick(LIVE, 2), 0, 1000);
    assertEquals(1, place(), 1e-9, "it is placed by its own once that is there");
    knownUntil = -300_000_000;
    recent.update(tick(LIVE, 3, value(2)), 0, 1000);
    assertInstanceOf(DisplayStatus.Partly.class, status(LIVE));
  }

  @Test
  void saysWhyNothingIsSeen() {
    assertEquals(new DisplayStatus.NoData("no topic fits"), status(new InputState.Unconnected("no topic fits")));
    assertInstanceOf(DisplayStatus.NoData.class, status(LIVE));
    exact = Optional.empty();
    now = Optional.empty();
    recent.update(tick(LIVE, 1, value(1)), 0, 1000);
    assertEquals(new DisplayStatus.NoFrame("no base"), status(LIVE));
  }

  @Test
  void saysThatItIsTooOldAndPalerThen() {
    recent.update(tick(LIVE, 1, value(1)), 0, 1000);
    InputState stale = new InputState.Stale(9, "the link is lost");
    assertEquals(new DisplayStatus.TooOld("the link is lost"), status(stale));
    assertTrue(Recent.opacity(tick(stale, 1)) < 1);
  }

  @Test
  void saysThatAColourIsNone() {
    recent.update(tick(LIVE, 1, value(1)), 0, 1000);
    DisplayTick tick = new DisplayTick(List.of(), LIVE, places(), new Settings(SCHEMA, Map.of("color", "reddish")),
        Rgba.WHITE, 0, false);
    assertTrue(recent.status(tick, new DisplayStatus.Shown("")).words().contains("reddish"));
    assertEquals(Rgba.of(0xff0000), ColorSetting.read(tick.settings(), "color"));
    assertEquals(Optional.of(Rgba.of(0x102030).withAlpha(1 / 255.0)), ColorSetting.parse("#10203001"));
  }

  @Test
  void forgetsAllWhereTheClockJumpsBackOrTheSourceIsGone() {
    recent.update(tick(LIVE, 1, value(1)), 0, 1000);
    recent.update(new DisplayTick(List.of(), LIVE, places(), settings(), Rgba.WHITE, 0, true), 0, 1000);
    assertTrue(recent.entries().isEmpty());
    recent.update(tick(LIVE, 1, value(1)));
    recent.update(tick(new InputState.Unconnected("gone"), 1));
    assertTrue(recent.newest().isEmpty());
  }

  @Test
  void preparesOnceForEachValueAndSetting() {
    recent.update(tick(LIVE, 1, value(1)), 0, 1000);
    Recent.Entry<StampedPose, Object> entry = recent.newest().orElseThrow();
    Object first = entry.prepared("red", v -> new Object());
    assertSame(first, entry.prepared("red", v -> new Object()));
    assertNotSame(first, entry.prepared("blue", v -> new Object()));
  }

  private double place() {
    return recent.newest().orElseThrow().anchor().found().orElseThrow().translation().x();
  }

  private DisplayStatus status(InputState state) {
    return recent.status(tick(state, 1), new DisplayStatus.Shown("a pose"));
  }

  private DisplayTick tick(InputState state, int second, Envelope<?>... arrived) {
    return new DisplayTick(List.of(arrived), state, places(), settings(), Rgba.WHITE, second * 1_000_000_000L, false);
  }

  private static Settings settings() {
    return new Settings(SCHEMA, Map.of("color", "#ffffff"));
  }

  private static Envelope<StampedPose> value(int second) {
    return new Envelope<>(new StampedPose(BASE, RigidTransform.IDENTITY), new SourceId("r", "pose"), second,
        Optional.of(new Stamp(second, ClockKind.ROBOT)), second * 1_000_000_000L, Optional.empty());
  }

  private Places places() {
    return new Places() {
      @Override
      public FrameId fixed() {
        return new FrameId("r", fixed);
      }

      @Override
      public Place at(FrameId frame, Optional<Stamp> stamp) {
        return (stamp.isPresent() ? exact.filter(e -> stamp.get().nanos() <= knownUntil) : now)
            .<Place>map(Place.At::new).orElseGet(() -> new Place.Missing("no " + frame.name()));
      }

      @Override
      public List<FrameId> all() {
        return List.of(BASE);
      }

      @Override
      public Optional<FrameId> parent(FrameId frame) {
        return Optional.empty();
      }
    };
  }
}
