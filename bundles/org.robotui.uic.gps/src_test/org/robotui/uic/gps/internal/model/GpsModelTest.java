package org.robotui.uic.gps.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.FrameId;
import org.robotui.data.sensor.GpsFix;
import org.robotui.entity.gps.GeoPoint;
import org.robotui.testkit.FakeInput;
import org.robotui.testkit.FakeUicContext;
import org.robotui.uic.gps.internal.GpsOptions;
import org.robotui.uic.gps.internal.GpsType;
import org.robotui.uic.gps.internal.LayerKinds;

class GpsModelTest {
  private static final SourceId KEIRA = new SourceId("base", "fix");
  private static final SourceId SECOND = new SourceId("base", "rear_fix");
  private static final SourceId ROVER = new SourceId("rover", "fix");

  private final FakeUicContext context = new FakeUicContext("gps", GpsOptions.schema());
  private final FakeInput<GpsFix> input = context.input(GpsType.FIX);
  private final GpsModel model = new GpsModel(context, () -> LayerKinds.ALL);

  @Test
  void theFirstFixIsTheOrigin() {
    put(KEIRA, fix("Keira", GpsFix.Quality.NO_FIX, Double.NaN, Double.NaN));
    tick();
    assertTrue(model.snapshot().plane().isEmpty());
    assertTrue(model.snapshot().withoutFix());
    put(KEIRA, fix("Keira", GpsFix.Quality.FIX, 42, -71));
    put(KEIRA, fix("Keira", GpsFix.Quality.FIX, 42.001, -71));
    tick();
    assertEquals(GeoPoint.degrees(42.001, -71), model.snapshot().plane().orElseThrow().origin(),
        "the first that was looked at");
    put(KEIRA, fix("Keira", GpsFix.Quality.FIX, 42.002, -71));
    tick();
    assertEquals(111, model.snapshot().receivers().getFirst().at().orElseThrow().north(), 1);
  }

  @Test
  void anOriginThatWasConfiguredIsTaken() {
    put(KEIRA, fix("Keira", GpsFix.Quality.FIX, 42, -71));
    tick();
    context.settings().set(GpsOptions.ORIGIN, GpsOptions.FIXED);
    context.settings().set(GpsOptions.ORIGIN_LATITUDE, 42.0);
    context.settings().set(GpsOptions.ORIGIN_LONGITUDE, -71.001);
    assertTrue(tick());
    assertEquals(82.8, model.snapshot().receivers().getFirst().at().orElseThrow().east(), 0.1);
  }

  @Test
  void aLostFixKeepsTheLastPlace() {
    put(KEIRA, fix("Keira", GpsFix.Quality.FIX, 42, -71));
    tick();
    put(KEIRA, fix("Keira", GpsFix.Quality.NO_FIX, Double.NaN, Double.NaN));
    assertTrue(tick());
    Receiver receiver = model.snapshot().receivers().getFirst();
    assertFalse(receiver.fixed());
    assertEquals(Optional.of(GeoPoint.degrees(42, -71)), receiver.place());
    assertTrue(model.snapshot().withoutFix());
  }

  @Test
  void receiversAreNamedByRobotAndAsFarAsNeeded() {
    put(KEIRA, fix("Keira", GpsFix.Quality.FIX, 42, -71));
    put(ROVER, fix("Rover", GpsFix.Quality.FIX, 42, -71));
    tick();
    assertEquals(List.of("Keira", "Rover"), names());
    put(SECOND, fix("Keira", GpsFix.Quality.FIX, 42, -71));
    tick();
    assertEquals(List.of("Keira fix", "Rover", "Keira rear_fix"), names());
    input.remove(SECOND);
    tick();
    assertEquals(List.of("Keira", "Rover"), names());
    assertEquals(3, model.scene().layers().size(), "the grid and two receivers");
  }

  @Test
  void aReceiverOutOfReachIsKnownButNotOnThePlane() {
    put(KEIRA, fix("Keira", GpsFix.Quality.FIX, 42, -71));
    put(ROVER, fix("Rover", GpsFix.Quality.FIX, -33, 151));
    tick();
    Receiver rover = model.snapshot().receivers().get(1);
    assertTrue(rover.place().isPresent());
    assertTrue(rover.at().isEmpty());
  }

  @Test
  void tickSaysWhetherThereIsSomethingNew() {
    tick();
    assertFalse(tick());
    put(KEIRA, fix("Keira", GpsFix.Quality.FIX, 42, -71));
    assertTrue(tick());
    assertFalse(tick());
    input.state(new InputState.Stale(2.1, "no data"));
    assertTrue(tick());
    assertInstanceOf(InputState.Stale.class, model.snapshot().state());
    assertTrue(model.scene().layers().getLast().faded());
  }

  @Test
  void clearingForgetsTheWayAndTheOrigin() {
    put(KEIRA, fix("Keira", GpsFix.Quality.FIX, 42, -71));
    tick();
    put(KEIRA, fix("Keira", GpsFix.Quality.FIX, 42.001, -71));
    tick();
    assertTrue(model.scene().bounds().orElseThrow().height() > 100);
    model.clear();
    assertTrue(tick());
    assertEquals(GeoPoint.degrees(42.001, -71), model.snapshot().plane().orElseThrow().origin());
    assertEquals(2, model.scene().bounds().orElseThrow().height(), 0.1);
  }

  @Test
  void withoutSourcesItSaysWhatTheMatchingSays() {
    input.state(new InputState.Unconnected("nothing offers GpsFix"));
    tick();
    assertEquals("nothing offers GpsFix", model.snapshot().state().explanation());
  }

  private boolean tick() {
    return model.tick(System.nanoTime(), GpsOptions.of(context.settings().current()));
  }

  private List<String> names() {
    return model.snapshot().receivers().stream().map(Receiver::name).toList();
  }

  private void put(SourceId source, GpsFix fix) {
    input.put(source, fix, System.nanoTime(), Optional.empty());
  }

  private static GpsFix fix(String robot, GpsFix.Quality quality, double latitude, double longitude) {
    return new GpsFix(new FrameId(robot, "gps"), quality, Math.toRadians(latitude), Math.toRadians(longitude), 7, 0.9);
  }
}
