package org.robotui.entity.sonar.internal.display;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.config.Settings;
import org.robotui.api.port.InputState;
import org.robotui.data.FrameId;
import org.robotui.data.sensor.RangeReading;
import org.robotui.data.sensor.RangeReadings;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.display.ColorSetting;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.display.DisplayTick;
import org.robotui.gl.display.Places;
import org.robotui.gl.display.Recent;
import org.robotui.gl.shape.Describer;
import org.robotui.gl.shape.Instances;
import org.robotui.gl.shape.Material;
import org.robotui.gl.shape.Meshes;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Placings;
import org.robotui.gl.shape.Properties;
import org.robotui.gl.shape.Rgba;

/** A cone for each sensor, from the sensor to the echo. */
final class SonarDisplay implements Display {
  private static final int MOST_SENSORS = 1000;
  private static final double WIDEST = Math.toRadians(170);
  private static final double NARROWEST = Math.toRadians(0.5);
  private static final double FAINTER = 0.35;

  private final Map<FrameId, Drawn> newest = new LinkedHashMap<>();
  private long dropped;

  /** A reading, and its cone in the frame of the sensor; none where it says nothing. */
  private record Drawn(RangeReading reading, Optional<Instances> cone) {}

  @Override
  public DisplayResult update(DisplayTick tick) {
    if (tick.reset() || tick.state() instanceof InputState.Unconnected) {
      newest.clear();
    }
    tick.arrived().stream().map(e -> e.value()).filter(RangeReadings.class::isInstance).map(RangeReadings.class::cast)
        .flatMap(readings -> readings.readings().stream()).forEach(this::take);
    List<Part> parts = new ArrayList<>();
    List<String> missing = new ArrayList<>();
    newest.values().forEach(drawn -> drawn.cone().ifPresent(cone -> {
      switch (tick.places().at(drawn.reading().frame(), Optional.empty())) {
        case Places.Place.Missing none -> missing.add(none.reason());
        case Places.Place.At at -> part(drawn.reading(), cone, at.fixedFromFrame(), tick).ifPresent(parts::add);
      }
    }));
    return new DisplayResult(parts, status(tick, parts.size(), missing), dropped);
  }

  @Override
  public void close() {
    newest.clear();
  }

  private void take(RangeReading reading) {
    Drawn before = newest.get(reading.frame());
    if (before == null && newest.size() >= MOST_SENSORS) {
      dropped++;
    } else if (before == null || !before.reading().equals(reading)) {
      newest.put(reading.frame(), new Drawn(reading, cone(reading)));
    }
  }

  private static Optional<Instances> cone(RangeReading reading) {
    boolean free = reading.range() > reading.rangeMax();
    double length = reading.isEcho() ? reading.range() : reading.rangeMax();
    if (!reading.isEcho() && !free || !(length > 0) || !Double.isFinite(length)) {
      return Optional.empty();
    }
    double width = 2 * length * Math.tan(Math.clamp(reading.fieldOfView(), NARROWEST, WIDEST) / 2);
    RigidTransform tip = new RigidTransform(Vector3.ZERO, Quaternion.IDENTITY);
    return Optional.of(new Placings(1).add(tip, new Vector3(length, width, width)).of(Meshes.cone()));
  }

  private static Optional<Part> part(RangeReading reading, Instances cone, RigidTransform place, DisplayTick tick) {
    Settings settings = tick.settings();
    if (!reading.isEcho() && !settings.flag("free")) {
      return Optional.empty();
    }
    Rgba color = ColorSetting.read(settings, "color");
    double opacity = settings.number("opacity") * Recent.opacity(tick) * (reading.isEcho() ? 1 : FAINTER);
    return Optional.of(
        new Part(reading.frame(), cone, place, Material.lit(color.withAlpha(color.alpha() * opacity)), text(reading)));
  }

  private DisplayStatus status(DisplayTick tick, int cones, List<String> missing) {
    if (newest.isEmpty()) {
      return new DisplayStatus.NoData(
          tick.state() instanceof InputState.Live ? "no reading yet" : tick.state().explanation());
    }
    if (tick.state() instanceof InputState.Stale stale) {
      return new DisplayStatus.TooOld(stale.explanation());
    }
    if (!missing.isEmpty()) {
      return cones == 0 ? new DisplayStatus.NoFrame(missing.getFirst())
          : new DisplayStatus.Partly(cones + " cones; " + missing.getFirst());
    }
    return ColorSetting.complaint(tick.settings()).<DisplayStatus>map(DisplayStatus.Partly::new)
        .orElseGet(() -> new DisplayStatus.Shown(cones + " of " + newest.size() + " sensors"));
  }

  private static Describer text(RangeReading reading) {
    String kind = reading.kind() == RangeReading.Kind.INFRARED ? "infrared " : "sonar ";
    return (element, place) -> Properties.of(kind + reading.frame().name(),
        new Properties.Entry("range",
            reading.isEcho() ? metres(reading.range()) : "free to " + metres(reading.rangeMax())),
        new Properties.Entry("limits", metres(reading.rangeMin()) + " to " + metres(reading.rangeMax())),
        new Properties.Entry("opening",
            String.format(Locale.ROOT, "%.1f\u00b0", Math.toDegrees(reading.fieldOfView()))));
  }

  private static String metres(double value) {
    return String.format(Locale.ROOT, "%.2f m", value);
  }
}
