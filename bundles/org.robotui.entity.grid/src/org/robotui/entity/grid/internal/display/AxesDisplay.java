package org.robotui.entity.grid.internal.display;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.robotui.api.config.Settings;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.display.ColorSetting;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.display.DisplayTick;
import org.robotui.gl.display.Places;
import org.robotui.gl.shape.Instances;
import org.robotui.gl.shape.Label;
import org.robotui.gl.shape.Material;
import org.robotui.gl.shape.Meshes;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Placings;
import org.robotui.gl.shape.PointSet;
import org.robotui.gl.shape.Properties;
import org.robotui.gl.shape.Rgba;

/** The axes of one frame, with its name. */
final class AxesDisplay implements Display {
  private static final float TEXT = 12;
  /** Where the name is, in lengths of the axes: above z, where no axis hides it. */
  private static final double NAME_AT = 1.1;

  private Optional<Made> made = Optional.empty();

  /** What is drawn, and what it was made by. */
  private record Made(double length, String name, Instances axes, Label label) {}

  @Override
  public DisplayResult update(DisplayTick tick) {
    Settings s = tick.settings();
    String written = s.text("frame");
    return switch (FrameChoice.place(tick.places(), written)) {
      case Places.Place.Missing missing -> DisplayResult.nothing(new DisplayStatus.NoFrame(missing.reason()));
      case Places.Place.At at -> {
        String name = written.isBlank() ? tick.places().fixed().name() : written;
        DisplayStatus status = ColorSetting.complaint(s).<DisplayStatus>map(DisplayStatus.Partly::new)
            .orElse(new DisplayStatus.Shown(name));
        yield new DisplayResult(parts(s, name, at.fixedFromFrame()), status, 0);
      }
    };
  }

  @Override
  public void close() {
    made = Optional.empty();
  }

  private List<Part> parts(Settings s, String name, RigidTransform place) {
    Made shapes = shapes(s.number("length"), name);
    Properties words = describe(name, place);
    List<Part> parts = new ArrayList<>();
    parts.add(new Part("axes", shapes.axes(), place, Material.lit(Rgba.WHITE.withAlpha(s.number("opacity"))),
        (element, at) -> words));
    if (s.flag("label")) {
      RigidTransform above =
          place.times(new RigidTransform(new Vector3(0, 0, NAME_AT * shapes.length()), Quaternion.IDENTITY));
      parts.add(new Part("label", shapes.label(), above, Material.flat(ColorSetting.read(s, "label_color")),
          (element, at) -> words));
    }
    return parts;
  }

  private Made shapes(double length, String name) {
    if (made.filter(m -> m.length == length && m.name.equals(name)).isEmpty()) {
      Instances axes = new Placings(1)
          .add(new RigidTransform(Vector3.ZERO, Quaternion.IDENTITY), new Vector3(length, length, length))
          .of(Meshes.axes());
      made = Optional.of(new Made(length, name, axes, new Label(name, TEXT, PointSet.Unit.PIXELS)));
    }
    return made.orElseThrow();
  }

  private static Properties describe(String name, RigidTransform place) {
    return Properties.of("frame " + name,
        number("x", "%.3f m", place.translation().x()),
        number("y", "%.3f m", place.translation().y()),
        number("z", "%.3f m", place.translation().z()),
        number("yaw", "%.1f\u00b0", Math.toDegrees(place.rotation().yaw())));
  }

  private static Properties.Entry number(String name, String format, double value) {
    return new Properties.Entry(name, String.format(Locale.ROOT, format, value));
  }
}
